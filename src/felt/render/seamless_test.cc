#include <gtest/gtest.h>

#include "felt/document/edit_builder.h"
#include "felt/material/relief.h"
#include "felt/render/tile_painter.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::seamless_test {
namespace {

constexpr int kSide = 300;
constexpr Rgba kPaper{240, 250, 230, 255};

Image blank() {
  Image image = Image::create(kSide, kSide).value();
  fill(image.pixels(), image.pixels().rect(), kPaper);
  return image;
}

void paint(const InkScene& scene, const View& view, PixelRect part, const InkStyle& style,
           Image& image) {
  TilePainter painter;
  InkJob job = TilePainter::job_of(scene, view, part);
  while (!job.is_done()) painter.draw_next(job, style, image.pixels());
}

Document random_strokes(std::uint64_t seed) {
  Document document;
  EditBuilder builder(document);
  for (std::uint64_t i = 0; i < 12; ++i) {
    builder.add({1}, std::make_shared<const Stroke>(testing::random_stroke(seed * 1000 + i)));
  }
  EXPECT_TRUE(document.apply(std::move(builder).build("Draw")));
  return document;
}

/// Paints a picture in random parts and in one piece.
void compare(const InkStyle& style, std::uint64_t seed) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  testing::RandomStroke random(seed);
  const InkScene scene(random_strokes(seed));
  const View view{{random.uniform(-5, 5), random.uniform(-5, 5)}, random.uniform(5, 20)};
  Image whole = blank(), parts = blank();
  paint(scene, view, {0, 0, kSide, kSide}, style, whole);
  const int x = random.pick(1, kSide - 1), y = random.pick(1, kSide - 1);
  for (const PixelRect part : {PixelRect{0, 0, x, y}, PixelRect{x, 0, kSide, y},
                               PixelRect{0, y, x, kSide}, PixelRect{x, y, kSide, kSide}}) {
    paint(scene, view, part, style, parts);
  }
  EXPECT_EQ(whole, parts);
}

TEST(Seamless, PartsAreEqualToTheWholeByteForByte) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) compare({.is_seamless = true}, seed);
}

TEST(Seamless, PartsWithGrainAreEqualToTheWhole) {
  const InkStyle style{.grain = Grain(surface_grain(surface_materials()[0])), .is_seamless = true};
  for (std::uint64_t seed = 100; seed <= 130; ++seed) compare(style, seed);
}

TEST(Seamless, NothingOutsideTheWindowChanges) {
  const InkScene scene(random_strokes(7));
  Image image = blank();
  paint(scene, {{0.0, 0.0}, 12.0}, {100, 120, 160, 170}, {.is_seamless = true}, image);
  int changed = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool is_inside = x >= 100 && x < 160 && y >= 120 && y < 170;
      const bool is_paper = image.at(x, y) == kPaper;
      ASSERT_TRUE(is_inside || is_paper) << x << ", " << y;
      changed += is_paper ? 0 : 1;
    }
  }
  EXPECT_GT(changed, 0);
}

}  // namespace
}  // namespace felt::seamless_test
