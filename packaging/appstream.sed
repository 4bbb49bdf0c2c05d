# Changes the metainfo from AppStream 0.16 (Debian 12) to 1.0, which deprecates <developer_name>; 0.16 does not
# know <developer>, so no file passes `appstreamcli validate --strict` of both.
s,<developer_name>\(.*\)</developer_name>,<developer id="org.feltline"><name>\1</name></developer>,
