#include "felt/driver/net_address.h"

#include <gtest/gtest.h>

namespace felt::net_address_test {
namespace {

std::string parsed(std::string_view text) {
  const auto address = parse_net_address(text, 7);
  return address ? address->text() : "none";
}

TEST(NetAddress, HasASchemeAPortAndAPathOrNone) {
  EXPECT_EQ(parsed("ws://localhost:10001"), "localhost:10001");
  EXPECT_EQ(parsed("http://10.0.0.1:80/devices"), "10.0.0.1:80");
  EXPECT_EQ(parsed("192.168.0.25"), "192.168.0.25:7");
  EXPECT_EQ(parsed("[::1]:9"), "::1:9");
  EXPECT_EQ(parsed("[::1]"), "::1:7");
}

TEST(NetAddress, NonsenseIsNoAddress) {
  for (const char* const text : {"", ":", ":80", "host:", "host:0", "host:65536", "host:8x"}) {
    EXPECT_EQ(parsed(text), "none") << text;
  }
}

}  // namespace
}  // namespace felt::net_address_test
