#include "felt/base/read_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "felt/base/testing/test_folder.h"

namespace felt::read_file_test {
namespace {

using felt::testing::TestFolder;
using ::testing::EndsWith;
using ::testing::StartsWith;

TEST(ReadFile, TheCheckGetsTheHeadAndTheSize) {
  const TestFolder folder;
  for (const std::size_t size : {std::size_t{0}, std::size_t{5}, kCheckedHeadBytes, 1'000'000UL}) {
    std::string bytes(size, 'a');
    if (size > 0) bytes.back() = 'z';
    int calls = 0;
    const auto check = [&](std::string_view head, std::uint64_t known) -> Result<std::size_t> {
      ++calls;
      EXPECT_EQ(head, bytes.substr(0, kCheckedHeadBytes));
      EXPECT_EQ(known, size);
      return size;
    };
    const std::string path = folder.put("file", bytes);
    EXPECT_EQ(read_file(path, check).value(), bytes);
    EXPECT_EQ(read_regular_file(path, check).value(), bytes);
    EXPECT_EQ(calls, 2);
  }
}

TEST(ReadFile, ARefusalNamesTheFile) {
  const TestFolder folder;
  const std::string path = folder.put("file", "abc");
  const auto refuse = [](std::string_view, std::uint64_t) -> Result<std::size_t> {
    return invalid_data("has no form");
  };
  EXPECT_EQ(read_file(path, refuse).error().message, path + ": has no form");
  EXPECT_EQ(read_file(path, 3).value(), "abc");
  EXPECT_EQ(read_file(path, 2).error().code, ErrorCode::kLimitExceeded);
}

TEST(ReadFile, APipeIsReadUntilItsLimit) {
  const std::string endless = "/dev/zero";
  const Result<std::string> bytes = read_file(endless, std::size_t{1} << 20);
  ASSERT_FALSE(bytes);
  EXPECT_THAT(bytes.error().message, StartsWith(endless));
  EXPECT_THAT(bytes.error().message, EndsWith("is larger than 1048576 bytes"));
  EXPECT_FALSE(read_regular_file(endless, std::size_t{1} << 20));
}

}  // namespace
}  // namespace felt::read_file_test
