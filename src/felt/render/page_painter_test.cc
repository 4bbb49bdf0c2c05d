#include "felt/render/page_painter.h"

#include <gtest/gtest.h>

#include <limits>

#include "felt/stroke/testing/random_stroke.h"

namespace felt::page_painter_test {
namespace {

std::vector<StrokePtr> one_line() {
  return {std::make_shared<const Stroke>(testing::straight_stroke({10, 20}, {40, 20}, 2.0, 2.0))};
}

TEST(Page, FitsTheInkWithItsMargin) {
  const auto image = render_page(one_line(), {.dpi = 254.0, .area = {}, .margin_mm = 3.0});
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width(), 380);  // 30 + 2 x 1 + 2 x 3 mm at 10 px/mm
  EXPECT_EQ(image->height(), 80);
  EXPECT_EQ(image->at(0, 0), (Rgba{255, 255, 255, 255}));
  EXPECT_EQ(image->at(190, 40), (Rgba{0, 0, 0, 255}));
  EXPECT_EQ(image->at(190, 29).r, 255);
  EXPECT_EQ(image->at(190, 31).r, 0);
}

TEST(Page, ShowsTheSurfaceItIsGiven) {
  const auto image = render_page(one_line(), {.dpi = 25.4, .area = Rect{0, 0, 210, 297}});
  ASSERT_TRUE(image);
  EXPECT_EQ(image->width(), 210);
  EXPECT_EQ(image->height(), 297);
  EXPECT_EQ(image->at(25, 20).r, 0);
}

TEST(Page, PaperMayBeTransparent) {
  const auto image = render_page(one_line(), {.dpi = 50.0, .area = {}, .paper = {0, 0, 0, 0}});
  ASSERT_TRUE(image);
  EXPECT_EQ(image->at(0, 0), (Rgba{0, 0, 0, 0}));
}

TEST(Page, EmptySketchIsEmptyPaper) {
  const auto image = render_page({}, {});
  ASSERT_TRUE(image);
  EXPECT_EQ(image->at(5, 5), (Rgba{255, 255, 255, 255}));
}

TEST(Page, RefusesNonsense) {
  const double inf = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(render_page(one_line(), {.dpi = 0.0}));
  EXPECT_FALSE(render_page(one_line(), {.dpi = inf}));
  EXPECT_FALSE(render_page(one_line(), {.dpi = 300.0, .area = {}, .margin_mm = -1.0}));
  EXPECT_FALSE(render_page(one_line(), {.dpi = 300.0, .area = Rect{}}));
  EXPECT_FALSE(render_page(one_line(), {.dpi = 300.0, .area = Rect{0, 0, inf, 1}}));
  EXPECT_FALSE(render_page(one_line(), {.dpi = 100'000.0, .area = Rect{0, 0, 1000, 1000}}));
}

TEST(Page, TheSameSketchGivesTheSamePixels) {
  std::vector<StrokePtr> strokes;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    strokes.push_back(std::make_shared<const Stroke>(testing::random_stroke(seed)));
  }
  EXPECT_EQ(*render_page(strokes, {.dpi = 100.0}), *render_page(strokes, {.dpi = 100.0}));
}

}  // namespace
}  // namespace felt::page_painter_test
