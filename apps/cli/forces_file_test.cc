#include "forces_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "tests/support/scratch_path.h"

namespace felt::cli::forces_file_test {
namespace {

std::string text_of(const std::string& path) {
  std::ostringstream all;
  all << std::ifstream(path).rdbuf();
  return all.str();
}

TEST(ForcesFile, TheOldFileStaysUntilTheNewOneIsComplete) {
  const std::string path = scratch_path("forces.csv");
  std::ofstream(path) << "old";
  for (const bool finishes : {false, true}) {
    ForcesFile file = ForcesFile::create(path).value();
    for (int i = 0; i < 20'000; ++i) ASSERT_TRUE(file.add(TickReport(), {}));
    EXPECT_EQ(text_of(path), "old");
    if (finishes) {
      ASSERT_TRUE(file.finish());
    }
  }
  EXPECT_TRUE(text_of(path).starts_with("t_ms,"));
  std::filesystem::remove(path);
  EXPECT_FALSE(ForcesFile::create("/nowhere/at/all.csv"));
}

}  // namespace
}  // namespace felt::cli::forces_file_test
