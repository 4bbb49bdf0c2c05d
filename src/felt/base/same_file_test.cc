#include "felt/base/same_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/support/scratch_path.h"

namespace felt::same_file_test {
namespace {

namespace fs = std::filesystem;

class SameFile : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string at(const std::string& name) const { return folder_ + "/" + name; }

  std::string folder_ = scratch_path("same_file");
};

TEST_F(SameFile, NamesAndLinksOfOneFile) {
  std::ofstream(at("a")) << "ink";
  std::ofstream(at("b")) << "ink";
  fs::create_symlink("a", at("link"));
  fs::create_hard_link(at("a"), at("hard"));
  EXPECT_TRUE(is_same_file(at("a"), at("./a")));
  EXPECT_TRUE(is_same_file(at("a"), at("link")));
  EXPECT_TRUE(is_same_file(at("hard"), at("link")));
  EXPECT_FALSE(is_same_file(at("a"), at("b")));
}

TEST_F(SameFile, FilesThatAreStillToBeWritten) {
  fs::create_symlink("new", at("link"));
  EXPECT_TRUE(is_same_file(at("new"), at("./new")));
  EXPECT_TRUE(is_same_file(at("new"), at("link")));
  EXPECT_FALSE(is_same_file(at("new"), at("newer")));
  std::ofstream(at("a")) << "ink";
  EXPECT_FALSE(is_same_file(at("new"), at("a")));
}

TEST_F(SameFile, DevicesTakeFromSeveral) {
  EXPECT_FALSE(is_same_file("/dev/null", "/dev/null"));
}

}  // namespace
}  // namespace felt::same_file_test
