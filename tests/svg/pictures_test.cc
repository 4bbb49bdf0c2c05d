// What our reader of SVG sees, as a picture, is what others draw: librsvg of our own files, and the
// pictures beside a suite of files that is not part of the repository.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/svg/suite.h"

namespace felt::testing {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFiles = "tests/svg/files";

std::vector<std::string> own_files() {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(kFiles)) {
    if (entry.path().extension() == ".svg") names.push_back(entry.path().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(SvgPictures, OurFilesLookAsLibrsvgDrawsThem) {
  if (std::system("command -v rsvg-convert >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "rsvg-convert is not installed (package librsvg2-bin)";
  }
  const std::vector<std::string> names = own_files();
  EXPECT_GE(names.size(), 60U);
  const std::string png = (fs::temp_directory_path() / "felt-svg-picture.png").string();
  for (const std::string& name : names) {
    ASSERT_EQ(std::system(("rsvg-convert -w 300 " + name + " -o " + png).c_str()), 0) << name;
    const char* out = std::getenv("FELT_SVG_PICTURES");
    const SuiteResult result = compare_pictures(name, png, out == nullptr ? "" : out);
    EXPECT_TRUE(result.agrees) << name << ": " << result.why;
  }
  fs::remove(png);
}

/// Where the suite lies: FELT_SVG_SUITE, or beside the repository.
std::string suite_folder() {
  const char* given = std::getenv("FELT_SVG_SUITE");
  return given != nullptr ? given : "../shared/data/svg";
}

TEST(SvgPictures, WhatAgreedWithTheSuiteStillDoes) {
  const std::string root = suite_folder();
  if (!fs::is_directory(root)) {
    GTEST_SKIP() << "no suite of SVG files at " << root << " (FELT_SVG_SUITE names another place)";
  }
  std::ifstream list("tests/svg/suite_agrees.txt");
  std::string name;
  int count = 0;
  while (std::getline(list, name)) {
    const SuiteResult result = compare_with_suite(root, name);
    EXPECT_TRUE(result.agrees) << name << ": " << result.why;
    ++count;
  }
  EXPECT_GE(count, 250);
}

}  // namespace
}  // namespace felt::testing
