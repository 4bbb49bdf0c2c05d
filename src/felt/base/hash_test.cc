#include "felt/base/hash.h"

#include <gtest/gtest.h>

#include <string_view>

namespace felt::hash_test {
namespace {

std::uint64_t hash_text(std::string_view text) {
  Fnv1a hash;
  hash.add(std::as_bytes(std::span(text.data(), text.size())));
  return hash.value();
}

// Reference values published with the FNV test suite.
TEST(Fnv1a, GivesThePublishedValues) {
  EXPECT_EQ(hash_text(""), 0xcbf29ce484222325ULL);
  EXPECT_EQ(hash_text("a"), 0xaf63dc4c8601ec8cULL);
  EXPECT_EQ(hash_text("foobar"), 0x85944171f73967e8ULL);
}

}  // namespace
}  // namespace felt::hash_test
