#include "felt/render/tile_painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_fills.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::tile_painter_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

Pixels pixels_of(Bytes& bytes) {
  return {bytes.data(), kTileSide, kTileSide, std::ptrdiff_t{4} * kTileSide, PixelOrder::kBgra};
}

Bytes straight(const InkScene& scene, const View& view) {
  Bytes bytes(std::size_t{4} * kTileSide * kTileSide);
  TilePainter painter;
  InkJob job = TilePainter::job_of(scene, view, {0, 0, kTileSide, kTileSide});
  while (!job.is_done()) painter.draw_next(job, {}, pixels_of(bytes));
  return bytes;
}

int worst_difference(const Bytes& a, const Bytes& b) {
  int worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
  return worst;
}

/// Puts strokes of a preview anywhere in a pile of transparent strokes. The tile composed of the
/// strokes below, between and above them must equal the tile that is drawn directly.
void compare_splits(int strokes, std::uint64_t seeds, int bound) {
  int splits = 0;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    testing::RandomStroke random(seed);
    Document document;
    EditBuilder builder(document);
    for (int i = 0; i < strokes; ++i) {
      builder.add({1}, std::make_shared<const Stroke>(
                           testing::random_stroke(seed * 1000 + std::uint64_t(i))));
    }
    ASSERT_TRUE(document.apply(std::move(builder).build("Draw")));
    InkScene scene(document);
    const View view{{random.uniform(0, 5), random.uniform(0, 5)},
                    random.uniform(5, 20),
                    {0.8, 0.6},
                    random.chance(0.5)};
    TilePainter painter;
    TileSplit split;
    Bytes tile = straight(scene, view);
    const auto& ids = document.layers()[0].strokes;
    const auto first = static_cast<std::size_t>(random.pick(4, strokes - 4));
    for (int sample = 0; sample < 12; ++sample) {
      EditBuilder preview(document);
      const std::size_t count = sample < 8 ? 1 : 3;  // the eraser finds more and more strokes
      for (std::size_t k = 0; k < count; ++k) {
        StrokeData data = document.find(ids[first + k])->data();
        for (Point& p : data.points) p = p + Vec{0.3 * sample, 0.2 * sample};
        if (data.closed) data.points.back() = data.points.front();
        preview.replace(ids[first + k],
                        std::make_shared<const Stroke>(Stroke::create(data).value()));
      }
      InkDamage damage;
      ASSERT_TRUE(scene.show(std::move(preview).build("Pull"), damage));
      for (const Rect& r : damage) {
        const Rect px = view.area_px(r).inflated(2.0);
        const auto clamped = [](double x) { return static_cast<int>(std::clamp(x, 0.0, 256.0)); };
        const PixelRect part{clamped(std::floor(px.x0)), clamped(std::floor(px.y0)),
                             clamped(std::ceil(px.x1)), clamped(std::ceil(px.y1))};
        if (part.empty()) continue;
        if (painter.paint_split(scene, view, part, {}, split, pixels_of(tile))) {
          ++splits;
          continue;
        }
        fill(pixels_of(tile), part, {0, 0, 0, 0});
        InkJob job = TilePainter::job_of(scene, view, part);
        while (!job.is_done()) painter.draw_next(job, {}, pixels_of(tile));
      }
      if (sample % 3 != 2) continue;
      EXPECT_LE(worst_difference(tile, straight(scene, view)), bound) << "sample " << sample;
    }
  }
  EXPECT_GT(splits, 20);
}

TEST(TilePainter, ASplitTileIsTheStraightOne) {
  compare_splits(28, 6, 2);
}

/// Levels are whole numbers, so blending dozens of overlapping transparent strokes as one picture
/// rounds differently than blending them one by one. The desktop program draws such tiles again
/// after the preview.
TEST(TilePainter, ASplitOfADeepPileIsTheStraightOneButForRounding) {
  compare_splits(90, 2, 4);
}

/// Returns the alpha of the pixel at (x, y).
int alpha_at(const Bytes& bytes, int x, int y) {
  return bytes[std::size_t{4} * static_cast<std::size_t>(y * kTileSide + x) + 3];
}

Fill filled_square(double from, double to) {
  const std::vector<Point> corners{{from, from}, {to, from}, {to, to}, {from, to}, {from, from}};
  FillLoop loop{{corners[0]}, {}};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    loop.points.insert(loop.points.end(), {corners[i - 1], corners[i], corners[i]});
  }
  return {{loop}, {200, 0, 0, 128}, 0.0};
}

TEST(TilePainter, AFillIsPaintedByTheEvenOddRuleAndNotInTheOutlineView) {
  Document document;
  Fill ring = filled_square(1, 9);
  ring.loops.push_back(filled_square(3, 7).loops[0]);  // in the same direction
  EditBuilder builder(document);
  builder.add_fill({1}, std::make_shared<const Fill>(ring));
  ASSERT_TRUE(document.apply(std::move(builder).build("Fill")));
  const InkScene scene(document);
  const View view{{0, 0}, 20.0};
  const Bytes tile = straight(scene, view);
  EXPECT_EQ(alpha_at(tile, 40, 40), 128);
  EXPECT_EQ(alpha_at(tile, 100, 100), 0) << "the hole";
  EXPECT_EQ(alpha_at(tile, 10, 100), 0) << "outside";
  Bytes outlines(std::size_t{4} * kTileSide * kTileSide);
  TilePainter painter;
  InkStyle style;
  style.hair_px = 1.0;
  InkJob job = TilePainter::job_of(scene, view, {0, 0, kTileSide, kTileSide});
  while (!job.is_done()) painter.draw_next(job, style, pixels_of(outlines));
  EXPECT_EQ(outlines, Bytes(outlines.size())) << "a fill has no centre line";
}

/// A part of a tile shows the same as the whole tile, so the borders of tiles are not visible.
TEST(TilePainter, PartsOfATileWithFillsJoinWithoutASeam) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    testing::RandomStroke random(seed);
    Document document;
    EditBuilder builder(document);
    for (int i = 0; i < 5; ++i) {
      builder.add_fill({1}, std::make_shared<const Fill>(testing::random_fill(random)));
      builder.add({1}, std::make_shared<const Stroke>(
                           testing::random_stroke(seed * 10 + static_cast<std::uint64_t>(i))));
    }
    ASSERT_TRUE(document.apply(std::move(builder).build("Draw")));
    const InkScene scene(document);
    const View view{{0, 0}, random.uniform(5, 20), {0.8, 0.6}};
    Bytes parts(std::size_t{4} * kTileSide * kTileSide);
    TilePainter painter;
    const int x = random.pick(1, 255), y = random.pick(1, 255);
    for (const PixelRect part :
         {PixelRect{0, 0, x, y}, PixelRect{x, 0, kTileSide, y}, PixelRect{0, y, x, kTileSide},
          PixelRect{x, y, kTileSide, kTileSide}}) {
      InkJob job = TilePainter::job_of(scene, view, part);
      while (!job.is_done()) painter.draw_next(job, {}, pixels_of(parts));
    }
    EXPECT_LE(worst_difference(parts, straight(scene, view)), 4) << "seed " << seed;
  }
}

/// Drawing with a rotated view equals rotating the drawn picture.
TEST(TilePainter, AQuarterTurnAndAMirrorMovePixelsOnly) {
  Document document;
  EditBuilder builder(document);
  for (std::uint64_t i = 0; i < 12; ++i) {
    builder.add({1}, std::make_shared<const Stroke>(testing::random_stroke(i)));
  }
  ASSERT_TRUE(document.apply(std::move(builder).build("Draw")));
  const InkScene scene(document);
  const double px = 12.0, side = kTileSide / px;
  const Bytes plain = straight(scene, {{0, 0}, px});
  const Bytes turned = straight(scene, {{0, side}, px, {0.0, 1.0}});
  const Bytes mirrored = straight(scene, {{side, 0}, px, {1.0, 0.0}, true});
  int worst = 0;
  const auto at = [](const Bytes& b, int x, int y, int k) {
    return b[static_cast<std::size_t>(4 * (y * kTileSide + x) + k)];
  };
  for (int y = 0; y < kTileSide; ++y) {
    for (int x = 0; x < kTileSide; ++x) {
      const int k = 3;
      const int here = at(plain, x, y, k);
      worst = std::max(worst, std::abs(here - at(turned, kTileSide - 1 - y, x, k)));
      worst = std::max(worst, std::abs(here - at(mirrored, kTileSide - 1 - x, y, k)));
    }
  }
  EXPECT_LE(worst, 3);
  const View view{{3, 4}, 7.5, {0.6, -0.8}, true};
  const Point there = view.to_mm(view.to_px({17.0, -2.5}));
  EXPECT_NEAR(there.x, 17.0, 1e-12);
  EXPECT_NEAR(there.y, -2.5, 1e-12);
}

}  // namespace
}  // namespace felt::tile_painter_test
