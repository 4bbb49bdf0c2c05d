// Draws what our SVG reader reads, and compares the pictures with those of other programs: with
// librsvg's pictures of the files in this repository, and with the pictures of a suite of files
// that is not part of the repository.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "felt/base/read_file.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/picture/png.h"
#include "felt/io/svg/svg_import.h"
#include "felt/render/page_painter.h"
#include "tests/formats/svg/scene_picture.h"
#include "tests/formats/svg/suite.h"
#include "tests/support/scratch_path.h"

namespace felt::testing::pictures_test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFiles = "tests/formats/svg/files";

std::vector<std::string> files_in(const char* folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".svg") names.push_back(entry.path().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool librsvg_is_there() {
  return std::system("command -v rsvg-convert >/dev/null 2>&1") == 0;
}

/// Draws a file with librsvg as a picture 300 pixels wide. Returns false if librsvg failed.
bool draw_with_librsvg(const std::string& name, const std::string& png) {
  std::string command = "rsvg-convert -w 300 ";
  command.append(name).append(" -o ").append(png);
  return std::system(command.c_str()) == 0;
}

TEST(SvgPictures, OurFilesLookAsLibrsvgDrawsThem) {
  if (!librsvg_is_there()) {
    GTEST_SKIP() << "rsvg-convert is not installed (package librsvg2-bin)";
  }
  const std::vector<std::string> names = files_in(kFiles);
  EXPECT_GE(names.size(), 60U);
  const std::string png = scratch_path("svg-picture.png");
  for (const std::string& name : names) {
    ASSERT_TRUE(draw_with_librsvg(name, png)) << name;
    const char* out = std::getenv("FELT_SVG_PICTURES");
    const SuiteResult result = compare_pictures(name, png, out == nullptr ? "" : out);
    EXPECT_TRUE(result.agrees) << name << ": " << result.why;
  }
  fs::remove(png);
}

/// Imports a file and returns a picture of its strokes, drawn as Feltline draws ink.
Image ink_picture(const std::string& name, int width_px) {
  const auto read = import_svg(read_file(name, std::size_t{1} << 20).value()).value();
  EXPECT_TRUE(read.drawing.has_page);
  const Rect area = read.drawing.page.area();
  return render_page(visible_strokes(read.drawing.document),
                     {.dpi = width_px * 25.4 / area.width(), .area = area, .paper = {0, 0, 0, 0}})
      .value();
}

/// Ink can represent lines with round ends and corners exactly. Such lines, imported as strokes,
/// must look as librsvg draws them.
TEST(SvgPictures, InkLooksAsLibrsvgDrawsTheLines) {
  if (!librsvg_is_there()) {
    GTEST_SKIP() << "rsvg-convert is not installed (package librsvg2-bin)";
  }
  const std::vector<std::string> names = files_in("tests/formats/svg/ink");
  EXPECT_GE(names.size(), 8U);
  const std::string png = scratch_path("svg-ink.png");
  for (const std::string& name : names) {
    ASSERT_TRUE(draw_with_librsvg(name, png)) << name;
    const Image theirs = decode_png(read_file(png, std::size_t{1} << 24).value()).value().image;
    const Image ours = ink_picture(name, theirs.width());
    EXPECT_LE(pixels_apart(ours, theirs), kPixelsAllowed) << name;
    if (const char* out = std::getenv("FELT_SVG_PICTURES")) {
      EXPECT_TRUE(
          write_png(std::string(out) + "/" + fs::path(name).stem().string() + ".png", ours, 96));
    }
  }
  fs::remove(png);
}

/// Returns the folder of the suite: FELT_SVG_SUITE, or a folder next to the repository.
std::string suite_folder() {
  const char* given = std::getenv("FELT_SVG_SUITE");
  return given != nullptr ? given : "../shared/data/svg";
}

TEST(SvgPictures, WhatAgreedWithTheSuiteStillDoes) {
  const std::string root = suite_folder();
  if (!fs::is_directory(root)) {
    GTEST_SKIP() << "no suite of SVG files at " << root << " (FELT_SVG_SUITE names another place)";
  }
  std::ifstream list("tests/formats/svg/suite_agrees.txt");
  std::string name;
  int count = 0;
  while (std::getline(list, name)) {
    const SuiteResult result = compare_with_suite(root, name);
    EXPECT_TRUE(result.agrees) << name << ": " << result.why;
    ++count;
  }
  EXPECT_GE(count, 261);
}

TEST(SvgPictures, TheDrawingsAgreeWithTheSuite) {
  const std::string root = suite_folder();
  if (!fs::is_directory(root)) GTEST_SKIP() << "no suite of SVG files at " << root;
  const std::set<std::string> differ = {
      "painting/stroke/control-points-clamping-1",
      "painting/stroke/pattern-with-objectBoundingBox-fallback-on-zero-bbox-shape"};
  std::ifstream list("tests/formats/svg/suite_agrees.txt");
  for (std::string name; std::getline(list, name);) {
    if (differ.contains(name)) continue;
    const SuiteResult result = compare_with_suite(root, name, {}, SuitePicture::kDrawing);
    EXPECT_TRUE(result.agrees) << name << ": " << result.why;
  }
}

}  // namespace
}  // namespace felt::testing::pictures_test
