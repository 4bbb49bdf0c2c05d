#include "felt/base/base64.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace felt::base64_test {

TEST(Base64, IsThatOfRfc4648) {
  EXPECT_EQ(base64_text(""), "");
  EXPECT_EQ(base64_text("f"), "Zg==");
  EXPECT_EQ(base64_text("fo"), "Zm8=");
  EXPECT_EQ(base64_text("foo"), "Zm9v");
  EXPECT_EQ(base64_text("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64_text(std::string_view("\xff\xfe\x00", 3)), "//4A");
}

RC_GTEST_PROP(Base64, DecodesWhatItEncodes, (const std::string& bytes)) {
  RC_ASSERT(base64_bytes(base64_text(bytes)) == bytes);
}

TEST(Base64, IgnoresWhiteSpace) {
  EXPECT_EQ(base64_bytes(" Zm9v\n Ym\tE=\r\n"), "fooba");
}

TEST(Base64, RefusesWhatIsNotBase64) {
  for (const char* text : {"Z", "Zg", "Zg=", "Zg===", "Zm9v=", "Z=g=", "Zm9*", "Zm9v\x80"}) {
    EXPECT_EQ(base64_bytes(text), std::nullopt) << text;
  }
}

}  // namespace felt::base64_test
