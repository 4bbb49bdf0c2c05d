#include "felt/formats/file_format.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace felt {
namespace {

TEST(FileFormat, IsNamedByTheEndingInEitherCase) {
  EXPECT_EQ(format_of_path("a/b.felt").value(), FileFormat::kFelt);
  EXPECT_EQ(format_of_path("A.XOPP").value(), FileFormat::kXopp);
  EXPECT_EQ(format_of_path("lines.jsonl").value(), FileFormat::kNdjson);
}

TEST(FileFormat, AnotherEndingIsAnErrorThatListsThem) {
  for (const char* path : {"a", "", ".felt", "a.doc", "felt"}) {
    const auto format = format_of_path(path);
    ASSERT_FALSE(format) << path;
    EXPECT_THAT(format.error().message, testing::HasSubstr(".inkml"));
  }
}

}  // namespace
}  // namespace felt
