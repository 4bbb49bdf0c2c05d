#include "felt/render/grain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "felt/base/hash.h"
#include "felt/render/page.h"
#include "felt/render/pressure_map.h"
#include "felt/render/raster.h"
#include "felt/stroke/random_stroke.h"

namespace felt {
namespace {

using testing::random_stroke;
using testing::straight_stroke;

const HeightField& paper() {
  static const HeightField field({.wavelength_mm = 1.0, .rms_um = 2.8, .seed = 1});
  return field;
}

Stroke of_material(const Stroke& stroke, const char* material) {
  StrokeData data = stroke.data();
  data.material = material;
  return Stroke::create(data).value();
}

/// Share of the ink that is seen of a wide, straight line.
double seen_of(double width, const char* material, const Grain& grain) {
  const Stroke line = of_material(straight_stroke({10, 10}, {90, 10}, width, width), material);
  PageOptions options{.dpi = 200, .sheet = Rect{0, 0, 100, 20}};
  const Image smooth = render_page({{"s", line}}, options).value();
  options.grain = grain;
  const Image image = render_page({{"s", line}}, options).value();
  double seen = 0.0, all = 0.0;
  for (std::size_t i = 0; i < image.bytes().size(); i += 4) {
    seen += 255.0 - image.bytes()[i];
    all += 255.0 - smooth.bytes()[i];
  }
  return seen / all;
}

TEST(Grain, R47_TheEyeSeesTheHeightsThatTheFieldHas) {
  const Grain grain(&paper());
  double together = 0.0, squares = 0.0;
  int count = 0;
  for (int k = 0; k < 20'000; ++k) {
    const Point p{0.37 * k - 600, 0.11 * k - 300};
    const HeightField::Sample eye = grain.at(p), hand = paper().at(p);
    ASSERT_EQ(eye.height_mm, hand.height_mm);
    ASSERT_EQ(eye.slope, hand.slope);
    // A place that is pressed on harder is never less inked.
    ASSERT_GE(grain.alpha(p, 0.6, 1.0), grain.alpha(p, 0.3, 1.0));
    const double h = hand.height_mm / (1e-3 * paper().spec().rms_um), r = grain.relief(p);
    together += h * r;
    squares += r * r;
    ++count;
  }
  // Hills that are felt are hills that are seen: the rest is the tooth.
  EXPECT_GT(together / count, 0.65);
  EXPECT_NEAR(squares / count, 1.0, 0.1);
}

TEST(Grain, ALightLineShowsTheGrainAndAHeavyOneIsNearlySolid) {
  const Grain grain(&paper());
  double last = 0.0;
  for (const double width : {0.5, 1.0, 2.0, 3.0, 4.0, 6.0}) {
    const double seen = seen_of(width, "pencil", grain);
    EXPECT_GT(seen, last) << width;
    last = seen;
  }
  EXPECT_LT(seen_of(0.5, "pencil", grain), 0.6);
  EXPECT_GT(seen_of(0.5, "pencil", grain), 0.3);
  EXPECT_GT(seen_of(6.0, "pencil", grain), 0.9);
}

TEST(Grain, WetInkAndSmoothSheetsAreDrawnAsBefore) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Stroke stroke = random_stroke(seed);
    const PageOptions plain{.dpi = 120, .sheet = Rect{0, 0, 20, 20}};
    PageOptions grainy = plain;
    grainy.grain = Grain(&paper());
    const Image as_before = render_page({{"s", stroke}}, plain).value();
    EXPECT_EQ(render_page({{"s", of_material(stroke, "felt-tip")}}, grainy).value(), as_before);
    EXPECT_NE(render_page({{"s", stroke}}, grainy).value(), as_before) << seed;
    const HeightField glass({.wavelength_mm = 1.0, .rms_um = 0.0});
    grainy.grain = Grain(&glass);
    EXPECT_EQ(render_page({{"s", stroke}}, grainy).value(), as_before);
  }
}

TEST(Grain, R47_ThePictureIsTheSameFromRunToRun) {
  const auto picture = [] {
    Sketch sketch;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) sketch.push_back({"s", random_stroke(seed)});
    PageOptions options{.dpi = 150, .sheet = Rect{0, 0, 20, 20}};
    options.grain = Grain(&paper());
    return render_page(sketch, options).value();
  };
  EXPECT_EQ(picture(), picture());
}

TEST(Grain, TilesGiveTheSamePixelsAsOnePicture) {
  const Stroke stroke = straight_stroke({1, 1}, {39, 28}, 1, 5);
  const View view{{0, 0}, 8.0};
  const Grain grain(&paper());
  Image whole = Image::create(320, 240).value(), tiled = Image::create(320, 240).value();
  Rasterizer rasterizer;
  rasterizer.draw(stroke, view, whole.pixels().rect(), grain, whole.pixels());
  for (int y = 0; y < 240; y += 60) {
    for (int x = 0; x < 320; x += 80) {
      rasterizer.draw(stroke, view, {x, y, x + 80, y + 60}, grain, tiled.pixels());
    }
  }
  for (std::size_t i = 0; i < whole.bytes().size(); ++i) {
    ASSERT_LE(std::abs(whole.bytes()[i] - tiled.bytes()[i]), 2) << i;
  }
}

TEST(PressureMap, IsThatOfTheWidthInTheMiddleOfTheLine) {
  const Stroke line = straight_stroke({2, 5}, {38, 5}, 0.3, 6.0);
  const View view{{0, 0}, 10.0};
  PressureMap map;
  map.make(line, view, {0, 0, 400, 100});
  for (int x = 60; x < 380; x += 10) {
    const double width = 0.3 + 5.7 * (x / 10.0 - 2) / 36;
    EXPECT_NEAR(static_cast<double>(map.at(x, 50)), pressure_of_width(width), 0.03) << x;
    const int edge = 50 + static_cast<int>(0.4 * 10 * width);
    EXPECT_LT(map.at(x, edge), map.at(x, 50));
  }
  EXPECT_EQ(map.at(5, 5), 0.0F);
}

}  // namespace
}  // namespace felt
