// Checks that our drawings keep their exact strokes after Inkscape opened and saved them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "felt/io/svg/svg_import.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/stroke/testing/random_stroke.h"
#include "tests/support/scratch_path.h"

namespace felt::inkscape_test {
namespace {

namespace fs = std::filesystem;

Drawing drawing() {
  DrawingBuilder d;
  d.drawing().has_page = true;
  d.drawing().page = Page{120.0, 90.0, {250, 248, 240, 255}};
  std::uint64_t seed = 500;
  for (const char* name : {"Back", "Front \"1\""}) {
    const std::size_t layer = d.add_layer({name, true, name[0] == 'B'});
    for (int i = 0; i < 6; ++i) {
      d.add(layer, testing::random_stroke(seed), "s" + std::to_string(seed));
      ++seed;
    }
  }
  d.add(d.add_layer({"Hidden", false}), testing::random_stroke(seed));
  return std::move(d).build();
}

/// Opens `d` in Inkscape and runs `actions`. Returns the file that Inkscape saves, or "" if it
/// fails.
std::string saved_by_inkscape(const Drawing& d, const std::string& actions) {
  const fs::path folder = scratch_path("inkscape");
  fs::create_directories(folder);
  const std::string in = (folder / "in.svg").string(), out = (folder / "out.svg").string();
  std::ofstream(in, std::ios::binary) << svg_text(d, {}).value();
  const std::string command = "HOME=" + folder.string() + " XDG_CONFIG_HOME=" + folder.string() +
                              " inkscape " + in + " --actions='" + actions +
                              "export-filename:" + out + ";export-do' >/dev/null 2>&1";
  if (std::system(command.c_str()) != 0) return {};
  std::ifstream file(out, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  fs::remove_all(folder);
  return text.str();
}

bool has_inkscape() {
  return std::system("command -v inkscape >/dev/null 2>&1") == 0;
}

TEST(SvgInkscape, LoadAndSaveKeepsEverything) {
  if (!has_inkscape()) GTEST_SKIP() << "inkscape is not installed (package inkscape)";
  const std::string text = saved_by_inkscape(drawing(), "");
  ASSERT_NE(text.find("sodipodi:namedview"), std::string::npos) << "Inkscape saved nothing";
  const auto back = import_svg(text);
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->drawing, drawing());
  for (const ImportNotice& n : back->report.notices()) ADD_FAILURE() << notice_text(n);
}

TEST(SvgInkscape, WhatItMovedIsMoved) {
  if (!has_inkscape()) GTEST_SKIP() << "inkscape is not installed (package inkscape)";
  const Stroke stroke = testing::random_stroke(7);
  Drawing one = testing::drawing_of({stroke});
  one.has_page = true;
  one.page = Page{120.0, 90.0};
  const std::string text = saved_by_inkscape(one, "select-all:all;transform-translate:30,20;");
  const auto back = import_svg(text);
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_EQ(back->drawing.document.layers().size(), 1U);
  ASSERT_EQ(back->drawing.document.stroke_count(), 1U) << text;
  const StrokeData& was = stroke.data();
  const StrokeData is = testing::strokes_in(back->drawing.document)[0].data();
  ASSERT_EQ(is.points.size(), was.points.size());
  const Vec moved = is.points[0] - was.points[0];
  EXPECT_GT(norm(moved), 1.0);
  for (std::size_t i = 0; i < was.points.size(); ++i) {
    EXPECT_LT(distance(is.points[i], was.points[i] + moved), 1e-4) << i;
  }
  ASSERT_EQ(is.widths.size(), was.widths.size());
  for (std::size_t i = 0; i < was.widths.size(); ++i) {
    EXPECT_NEAR(is.widths[i].width_mm, was.widths[i].width_mm, 1e-4) << i;
  }
}

}  // namespace
}  // namespace felt::inkscape_test
