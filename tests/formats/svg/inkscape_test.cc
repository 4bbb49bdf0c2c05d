// A drawing of ours that Inkscape opened and saved is still ours.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "felt/io/svg/svg_import.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/stroke/testing/random_stroke.h"
#include "tests/support/scratch_path.h"

namespace felt {
namespace {

namespace fs = std::filesystem;

LayeredSketch drawing() {
  LayeredSketch d;
  d.page = SheetPage{120.0, 90.0, {250, 248, 240, 255}};
  std::uint64_t seed = 500;
  for (const char* name : {"Back", "Front \"1\""}) {
    SketchLayer layer{name, true, name[0] == 'B', {}};
    for (int i = 0; i < 6; ++i) {
      layer.strokes.push_back({"s" + std::to_string(seed), testing::random_stroke(seed)});
      ++seed;
    }
    d.layers.push_back(std::move(layer));
  }
  d.layers.push_back({"Hidden", false, false, {{"h", testing::random_stroke(seed)}}});
  return d;
}

/// What Inkscape saves of a drawing after `actions`; empty where it failed.
std::string saved_by_inkscape(const LayeredSketch& d, const std::string& actions) {
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
  LayeredSketch one;
  one.page = SheetPage{120.0, 90.0};
  one.layers.push_back({"Ink", true, false, {{"a", testing::random_stroke(7)}}});
  const std::string text = saved_by_inkscape(one, "select-all:all;transform-translate:30,20;");
  const auto back = import_svg(text);
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_EQ(back->drawing.layers.size(), 1U);
  ASSERT_EQ(back->drawing.layers[0].strokes.size(), 1U) << text;
  const StrokeData& was = one.layers[0].strokes[0].stroke.data();
  const StrokeData& is = back->drawing.layers[0].strokes[0].stroke.data();
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
}  // namespace felt
