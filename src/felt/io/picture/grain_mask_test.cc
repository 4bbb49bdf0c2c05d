#include "felt/io/picture/grain_mask.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "felt/base/atomic_file.h"
#include "felt/io/picture/pdf_writer.h"
#include "felt/io/picture/png.h"
#include "felt/io/svg/svg_import.h"
#include "felt/io/svg/svg_writer.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/material/materials.h"
#include "felt/material/relief.h"
#include "felt/render/page_painter.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::grain_mask_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr double kDpi = 101.6;  // 4 pixels per millimetre
constexpr Rect kArea{0.0, 0.0, 120.0, 90.0};

Grain grain_of(std::string_view surface) {
  return Grain(surface_grain(*find_surface(surface)));
}

Stroke wavy(std::string material, double width_mm, Rgba color = {30, 40, 90, 255}) {
  StrokeData data;
  data.points = {{10, 20}, {40, -5}, {70, 75}, {100, 40}};
  data.widths = {{0.0, 0.5 * width_mm}, {1.0, width_mm}};
  data.medium = std::move(material);
  data.color = color;
  return Stroke::create(std::move(data)).value();
}

Drawing all_media() {
  std::vector<Stroke> strokes;
  for (const Medium& medium : media()) {
    const auto shift = 8.0 * static_cast<double>(strokes.size() % 5);
    StrokeData data = wavy(medium.id, 5.0, {200, 30, 60, 255}).data();
    for (Point& p : data.points) p.y = p.y * 0.6 + shift;
    if (strokes.size() % 3 == 2) data.color.a = 128;
    strokes.push_back(Stroke::create(std::move(data)).value());
  }
  return testing::drawing_of(strokes);
}

/// Lines drawn with light pressure, which show the most grain.
Drawing thin_lines() {
  std::vector<Stroke> strokes;
  for (int i = 0; i < 12; ++i) {
    StrokeData data = wavy(i % 3 == 0 ? "chalk" : "pencil", 1.5, {40, 20, 70, 255}).data();
    for (Point& p : data.points) p.y = p.y * 0.3 + 6.0 * i;
    if (i % 4 == 1) data.color.a = 128;
    strokes.push_back(Stroke::create(std::move(data)).value());
  }
  return testing::drawing_of(strokes);
}

/// Draws the outline through the mask.
Image through(const GrainMask& mask, const Stroke& stroke) {
  Image image = Image::create(mask.width, mask.height).value();
  const Pixels pixels = image.pixels();
  StrokeOutliner outliner;
  Rasterizer rasterizer;
  const View view = View::at_dpi({mask.area.x0, mask.area.y0}, kDpi);
  rasterizer.fill(outliner.trace(stroke, kRasterTolerancePx / view.px_per_mm), view, pixels.rect(),
                  {0, 0, 0, 255}, pixels);
  for (std::size_t i = 0; i < mask.seen.size(); ++i) {
    std::uint8_t& alpha = pixels.data[4 * i + 3];
    alpha = static_cast<std::uint8_t>((alpha * mask.seen[i] + 127) / 255);
  }
  return image;
}

// For all media and surfaces, outline and mask look the same in another program as the ink on the
// screen.
TEST(GrainMask, OutlineThroughItIsTheInkOnTheScreen) {
  int masks_made = 0;
  for (const SurfaceMaterial& surface : surface_materials()) {
    const Grain grain = grain_of(surface.id);
    for (const Medium& medium : media()) {
      SCOPED_TRACE(surface.id + ", " + medium.id);
      const Stroke stroke = wavy(medium.id, 4.0, {0, 0, 0, 255});
      GrainMasks masks({grain, kDpi}, kArea);
      const std::optional<GrainMask> mask = masks.of(stroke).value();
      const View view = View::at_dpi(mask ? Point{mask->area.x0, mask->area.y0} : Point{}, kDpi);
      Image ours = Image::create(mask ? mask->width : 480, mask ? mask->height : 360).value();
      const Pixels pixels = ours.pixels();
      Rasterizer rasterizer;
      rasterizer.draw(stroke, view, pixels.rect(), grain, pixels);
      const GrainMask whole{kArea, 480, 360, std::vector<std::uint8_t>(480 * 360, 255)};
      const Image theirs = through(mask ? *mask : whole, stroke);
      masks_made += mask ? 1 : 0;
      int worst = 0;
      for (std::size_t i = 3; i < ours.bytes().size(); i += 4) {
        worst = std::max(worst, std::abs(ours.bytes()[i] - theirs.bytes()[i]));
      }
      // At the rim, where less than a fifth of a pixel is ink, values are taken from the
      // neighbours.
      EXPECT_LE(worst, mask ? 48 : 3);
    }
  }
  EXPECT_GE(masks_made, 12);
}

TEST(GrainMask, WhatLiesBesideTheSurfaceNeedsNone) {
  GrainMasks masks({grain_of("rough-paper"), kDpi}, kArea);
  StrokeData data = wavy("pencil", 3.0).data();
  for (Point& p : data.points) p.x += 500.0;
  EXPECT_FALSE(masks.of(Stroke::create(data).value()).value());
  for (Point& p : data.points) p.x += 1e9;
  EXPECT_FALSE(masks.of(Stroke::create(data).value()).value());
  for (Point& p : data.points) p.x -= 1e9 + 400.0;  // half of the line is there
  const auto mask = masks.of(Stroke::create(data).value()).value();
  ASSERT_TRUE(mask);
  EXPECT_LE(mask->area.x1, kArea.x1 + 1.0);
}

TEST(GrainMask, IsBounded) {
  const Stroke stroke = wavy("pencil", 3.0);
  for (const double dpi : {0.0, -1.0, 19.0, 1201.0, std::nan(""), 1e300}) {
    EXPECT_EQ(GrainMasks({grain_of("paper"), dpi}, kArea).of(stroke).error().code,
              ErrorCode::kInvalidArgument);
  }
  GrainMasks masks({grain_of("paper"), 1200.0}, {0, 0, 5000, 5000});
  StrokeData large = stroke.data();
  for (Point& p : large.points) p = {40.0 * p.x, 40.0 * p.y};
  const auto mask = masks.of(Stroke::create(large).value());
  ASSERT_FALSE(mask);
  EXPECT_EQ(mask.error().code, ErrorCode::kLimitExceeded);
  EXPECT_THAT(mask.error().message, HasSubstr("200 million pixels at 1200 dots per inch"));
}

// All strokes of a file share the same grain, the finest that is possible for all of them.
TEST(GrainMask, ForAllStrokesIsAsFineAsTheyFit) {
  const Rect page{0, 0, 297, 210};
  StrokeData data = wavy("pencil", 3.0).data();
  const Rect ink = wavy("pencil", 3.0).bounds();
  for (Point& p : data.points) {
    p = {280.0 * (p.x - ink.x0) / ink.width(), 200.0 * (p.y - ink.y0) / ink.height()};
  }
  const std::vector one{std::make_shared<const Stroke>(Stroke::create(data).value())};
  EXPECT_EQ(GrainMasks::dpi_for_all({}, page, 300.0), 300.0);
  EXPECT_EQ(GrainMasks::dpi_for_all(one, page, 300.0), 300.0);
  const std::vector<StrokePtr> many(200, one.front());
  const std::optional<double> dpi = GrainMasks::dpi_for_all(many, page, 300.0);
  ASSERT_TRUE(dpi);
  const auto mask = GrainMasks({grain_of("rough-paper"), *dpi}, page).of(*one.front());
  ASSERT_TRUE(mask && *mask);
  const std::int64_t pixels = 200 * std::int64_t{(*mask)->width} * (*mask)->height;
  EXPECT_LE(pixels, GrainMasks::kMaxPixels);
  EXPECT_GT(pixels, GrainMasks::kMaxPixels * 9 / 10);
  EXPECT_FALSE(GrainMasks::dpi_for_all(std::vector<StrokePtr>(20000, one.front()), page, 300.0));
}

/// Removes the masks and the references to them.
std::string unmasked(std::string svg) {
  const auto cut = [&svg](const std::string& from, const std::string& to) {
    for (std::size_t at = 0; (at = svg.find(from, at)) != std::string::npos;) {
      svg.erase(at, svg.find(to, at) + to.size() - at);
    }
  };
  cut("<defs><mask id=\"grain", "</mask></defs>\n");
  cut("mask=\"url(#grain", "\" ");
  return svg;
}

// Grain never changes lines and outlines, and we read the same drawing with and without it.
TEST(GrainMask, AnSvgIsTheSameBesideIt) {
  const SvgOptions plain{.area = kArea};
  SvgOptions grained = plain;
  grained.grain = GrainPrint{grain_of("rough-paper"), kDpi};
  const std::string without = svg_ink_text(all_media(), plain).value();
  const std::string with = svg_ink_text(all_media(), grained).value();
  EXPECT_GT(with.size(), without.size() + 10'000);
  EXPECT_EQ(unmasked(with), without);
  EXPECT_EQ(svg_ink_text(all_media(), grained).value(), with);

  Drawing drawing = all_media();
  drawing.has_page = true;
  drawing.page = Page{.width_mm = 120.0, .height_mm = 90.0, .surface = "rough-paper"};
  drawing.materials = {"id = \"a\"\n", "<&\">"};
  SvgOptions whole = grained;
  whole.area.reset();
  const Imported back = import_svg(svg_text(drawing, whole).value()).value();
  EXPECT_TRUE(back.report.empty()) << notice_text(back.report.notices().front());
  EXPECT_EQ(back.drawing, drawing);
}

Image picture_in(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return decode_png(bytes.str()).value().image;
}

double mean_difference(const Image& a, const Image& b) {
  EXPECT_EQ(a.width(), b.width());
  EXPECT_EQ(a.height(), b.height());
  if (a.bytes().size() != b.bytes().size()) return 255.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < a.bytes().size(); ++i) sum += std::abs(a.bytes()[i] - b.bytes()[i]);
  return sum / static_cast<double>(a.bytes().size());
}

class GrainPicture : public ::testing::Test {
 protected:
  GrainPicture() {
    std::string name = (fs::temp_directory_path() / "felt-grain-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~GrainPicture() override { fs::remove_all(folder_); }
  [[nodiscard]] std::string path(const char* name) const { return (folder_ / name).string(); }

  [[nodiscard]] Image ours() const {
    PageOptions page;
    page.dpi = kDpi;
    page.area = kArea;
    page.grain = print_.grain;
    return render_page(visible_strokes(drawing_.document), page).value();
  }
  /// The difference from solid ink, for comparison.
  [[nodiscard]] double solid_difference() const {
    return mean_difference(
        ours(),
        render_page(visible_strokes(drawing_.document), {.dpi = kDpi, .area = kArea}).value());
  }

  fs::path folder_;
  Drawing drawing_ = thin_lines();
  GrainPrint print_{grain_of("rough-paper"), kDpi};
};

TEST_F(GrainPicture, AnotherProgramShowsItFromSvg) {
  if (std::system("command -v rsvg-convert >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "rsvg-convert is not installed (package librsvg2-bin)";
  }
  ASSERT_TRUE(
      write_file(path("a.svg"), svg_ink_text(drawing_, {.area = kArea, .grain = print_}).value()));
  ASSERT_EQ(
      std::system(("rsvg-convert -w 480 -h 360 -b white " + path("a.svg") + " -o " + path("a.png"))
                      .c_str()),
      0);
  const double mean = mean_difference(picture_in(path("a.png")), ours());
  EXPECT_LE(mean, 0.4);
  EXPECT_GE(solid_difference(), 5.0 * mean);
  RecordProperty("mean_1e6", static_cast<int>(1e6 * mean));
}

TEST_F(GrainPicture, AnotherProgramShowsItFromPdf) {
  if (std::system("command -v pdftoppm >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "pdftoppm is not installed (package poppler-utils)";
  }
  PdfOptions options;
  options.area = kArea;
  const std::string plain = pdf_text(drawing_, options).value();
  options.grain = print_;
  const std::string grained = pdf_text(drawing_, options).value();
  EXPECT_GT(grained.size(), plain.size());
  ASSERT_TRUE(write_file(path("a.pdf"), grained));
  ASSERT_EQ(std::system(("pdftoppm -r 101.6 -W 480 -H 360 -png -singlefile " + path("a.pdf") + " " +
                         path("a"))
                            .c_str()),
            0);
  ASSERT_TRUE(write_file(path("b.pdf"), plain));
  ASSERT_EQ(std::system(("pdftoppm -r 101.6 -W 480 -H 360 -png -singlefile " + path("b.pdf") + " " +
                         path("b"))
                            .c_str()),
            0);
  const double mean = mean_difference(picture_in(path("a.png")), ours());
  EXPECT_LE(mean, 1.3);  // most of it is anti-aliasing of edges, of which dust has many
  EXPECT_GE(mean_difference(picture_in(path("b.png")), ours()), mean + 0.5 * solid_difference());
  RecordProperty("mean_1e6", static_cast<int>(1e6 * mean));
}

}  // namespace
}  // namespace felt::grain_mask_test
