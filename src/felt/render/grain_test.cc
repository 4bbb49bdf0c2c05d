#include "felt/render/grain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

#include "felt/base/hash.h"
#include "felt/render/ink_look.h"
#include "felt/render/page_painter.h"
#include "felt/render/pressure_map.h"
#include "felt/render/raster.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::grain_test {
namespace {

Result<Image> picture_of(const Stroke& stroke, const PageOptions& options) {
  return render_page(std::vector{std::make_shared<const Stroke>(stroke)}, options);
}

using testing::random_stroke;
using testing::straight_stroke;

const HeightField& paper() {
  static const HeightField field({.wavelength_mm = 1.0, .rms_um = 2.8, .seed = 1});
  return field;
}

Stroke of_material(const Stroke& stroke, const char* material) {
  StrokeData data = stroke.data();
  data.medium = material;
  return Stroke::create(data).value();
}

/// Returns a line with tone 0 at its left end and 1 at its right end.
Stroke swelling(const char* material) {
  StrokeData data = straight_stroke({10, 10}, {90, 10}, 5.0, 5.0).data();
  data.medium = material;
  data.widths.front() = {0.0, 5.0, 0.0};
  data.widths.back().tone = 1.0;
  return Stroke::create(data).value();
}

Image page_of(const Stroke& stroke, const Grain& grain) {
  PageOptions options{.dpi = 200, .area = Rect{0, 0, 100, 20}};
  options.grain = grain;
  return picture_of(stroke, options).value();
}

/// Returns the visible fraction of the ink of a wide, straight line of a tone.
double seen_of(double tone, const char* material, const Grain& grain) {
  StrokeData data = straight_stroke({10, 10}, {90, 10}, 5.0, 5.0).data();
  data.medium = material;
  for (WidthKnot& knot : data.widths) knot.tone = tone;
  const Stroke line = Stroke::create(data).value();
  const Image smooth = page_of(line, Grain()), image = page_of(line, grain);
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
    // More pressure never gives less ink at a point.
    ASSERT_GE(grain.alpha(p, 0.6, "pencil"), grain.alpha(p, 0.3, "pencil"));
    const double h = hand.height_mm / (1e-3 * paper().spec().rms_um), r = grain.relief(p);
    together += h * r;
    squares += r * r;
    ++count;
  }
  // Hills that are felt are also seen; the rest is the tooth.
  EXPECT_GT(together / count, 0.65);
  EXPECT_NEAR(squares / count, 1.0, 0.1);
}

TEST(Grain, ALightLineShowsTheGrainAndAHeavyOneGoesDeeper) {
  const Grain grain(&paper());
  for (const Medium& medium : media()) {
    if (!medium.draws || !grain.look(medium.id, 8.0)) continue;
    double last = 0.0;
    for (const double tone : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      const double seen = seen_of(tone, medium.id.c_str(), grain);
      EXPECT_GE(seen, last) << medium.id << " " << tone;
      last = seen;
    }
    EXPECT_GT(last, 0.4) << medium.id;
  }
  for (const char* dry : {"pencil", "pencil-soft", "charcoal", "chalk", "crayon"}) {
    EXPECT_LT(seen_of(0.05, dry, grain), 0.5) << dry;
    EXPECT_GT(seen_of(0.05, dry, grain), 0.03) << dry;
  }
}

TEST(Grain, PlainIsSolidInkAndSoAreMediaWithoutALook) {
  Materials materials = Materials::built_in();
  Medium solid = *materials.find_medium("ink-pen");
  solid.id = "solid";
  solid.look = {.grain = 0.0};
  materials.put(solid);
  const HeightField flat({.wavelength_mm = 1.0, .rms_um = 0.0});
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Stroke stroke = of_material(random_stroke(seed), "solid");
    const PageOptions plain{.dpi = 120, .area = Rect{0, 0, 20, 20}};
    const Image as_before = picture_of(stroke, plain).value();
    PageOptions other = plain;
    for (const HeightField* field : {&paper(), &flat, static_cast<const HeightField*>(nullptr)}) {
      other.grain = Grain(field, materials);
      EXPECT_EQ(picture_of(stroke, other).value(), as_before) << seed;
    }
    // An unknown medium looks like the pencil, also on a surface of glass.
    other.grain = Grain(&flat, materials);
    const auto drawn = [&](const char* material) {
      return picture_of(of_material(stroke, material), other).value();
    };
    EXPECT_EQ(drawn("from far away"), drawn("pencil"));
    EXPECT_NE(drawn("pencil"), as_before);
  }
}

TEST(Grain, OnASmoothSurfaceThePencilIsGreyByItsToneAndCharcoalHasCrumbs) {
  const Grain glass(nullptr);
  EXPECT_TRUE(glass.is_smooth());
  EXPECT_FALSE(glass.is_plain());
  const auto spread = [&](const char* material) {
    double sum = 0.0, squares = 0.0;
    for (int k = 0; k < 4000; ++k) {
      const double a = glass.alpha({0.173 * k, 0.117 * k}, 0.3, material);
      sum += a;
      squares += a * a;
    }
    const double mean = sum / 4000;
    return std::sqrt(std::max(0.0, squares / 4000 - mean * mean));
  };
  EXPECT_GT(spread("charcoal"), 0.1);
  EXPECT_LT(seen_of(0.1, "pencil", glass), seen_of(0.9, "pencil", glass) - 0.2);
}

TEST(Grain, TablesSayWhatTheFormulaSays) {
  const View view{{-3.0, 2.0}, 40.0};
  const HeightField rough({.wavelength_mm = 1.3, .rms_um = 11.0, .seed = 4});
  for (const char* material : {"pencil", "pencil-soft", "crayon"}) {
    const Grain grain(&rough);
    const auto look = grain.look(material, view.px_per_mm);
    ASSERT_TRUE(look);
    const InkShade shade(*look, view);
    PressureMap pressure;
    pressure.begin({0, 0, 256, 4}, look->edge);
    pressure.lay(std::vector<TipAt>{{{-50.0, 2.0}, 4000.0, 0.4}, {{300.0, 2.0}, 4000.0, 0.4}});
    std::vector<std::uint8_t> alphas(256, 255);
    shade.row(pressure, {}, 0, 2, 256, alphas.data());
    double off = 0.0;
    for (int x = 0; x < 256; ++x) {
      const double exact = grain.alpha(view.to_mm({x + 0.5, 2.5}), 0.4, material);
      off += std::abs(alphas[static_cast<std::size_t>(x)] / 255.0 - exact) / 256.0;
    }
    EXPECT_LT(off, 0.07) << material;
  }
}

TEST(Grain, FromAfarOneSeesTheMean) {
  const HeightField rough({.wavelength_mm = 1.3, .rms_um = 11.0, .seed = 4});
  const Grain grain(&rough);
  for (const char* material : {"pencil", "charcoal", "crayon"}) {
    const auto mean_at = [&](double dpi) {
      PageOptions options{.dpi = dpi, .area = Rect{20, 8, 80, 12}};
      options.grain = grain;
      const Image image = picture_of(swelling(material), options).value();
      double sum = 0.0;
      for (std::size_t i = 0; i < image.bytes().size(); i += 4) sum += image.bytes()[i];
      return sum / (0.25 * static_cast<double>(image.bytes().size()));
    };
    const double near = mean_at(300.0);
    EXPECT_NEAR(mean_at(30.0), near, 20.0) << material;
  }
}

TEST(Grain, EqualGrainsLookAlike) {
  EXPECT_EQ(Grain(), Grain());
  EXPECT_EQ(Grain(&paper()), Grain(&paper()));
  EXPECT_FALSE(Grain() == Grain(nullptr));
  Materials other = Materials::built_in();
  Medium pencil = other.media()[0];
  pencil.look.soft *= 2.0;
  other.put(pencil);
  EXPECT_FALSE(Grain(&paper()) == Grain(&paper(), other));
}

TEST(Grain, R47_ThePictureIsTheSameFromRunToRun) {
  const auto picture = [] {
    std::vector<StrokePtr> strokes;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      strokes.push_back(std::make_shared<const Stroke>(random_stroke(seed)));
    }
    PageOptions options{.dpi = 150, .area = Rect{0, 0, 20, 20}};
    options.grain = Grain(&paper());
    return render_page(strokes, options).value();
  };
  EXPECT_EQ(picture(), picture());
}

/// Draws strokes of all media in tiles of different sizes, each with its own view, as on a display.
TEST(Grain, TilesGiveTheSamePixelsAsOnePicture) {
  constexpr int kWide = 300, kHigh = 220;
  const HeightField rough({.wavelength_mm = 1.3, .rms_um = 11.0, .seed = 4});
  const Grain on_rough(&rough), on_glass(nullptr);
  int worst = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    const auto any = [&](int a, int b) { return std::uniform_int_distribution(a, b)(random); };
    const Medium& medium = media()[seed % media().size()];
    const Stroke stroke = of_material(random_stroke(seed), medium.id.c_str());
    const double angle = seed % 3 == 0 ? 0.01 * any(0, 628) : 0.0;
    const View view{{0.01 * any(-300, 300), 0.01 * any(-300, 300)},
                    0.1 * any(20, 300),
                    {std::cos(angle), std::sin(angle)},
                    seed % 5 == 0};
    const Grain& grain = seed % 4 == 0 ? on_glass : on_rough;
    Image whole = Image::create(kWide, kHigh).value(), tiled = whole;
    Rasterizer rasterizer;
    rasterizer.draw(stroke, view, whole.pixels().rect(), grain, whole.pixels());
    for (int y = 0; y < kHigh;) {
      const int down = std::min(kHigh, y + any(20, 120));
      for (int x = 0; x < kWide;) {
        const int right = std::min(kWide, x + any(20, 150));
        const View shifted = view.from({static_cast<double>(x), static_cast<double>(y)});
        Pixels tile = tiled.pixels();
        tile.data += y * tile.stride + std::ptrdiff_t{4} * x;
        tile.width = right - x;
        tile.height = down - y;
        rasterizer.draw(stroke, shifted, tile.rect(), grain, tile);
        x = right;
      }
      y = down;
    }
    for (std::size_t i = 0; i < whole.bytes().size(); ++i) {
      const int off = std::abs(whole.bytes()[i] - tiled.bytes()[i]);
      ASSERT_LE(off, 2) << medium.id << ", seed " << seed << ", byte " << i;
      worst = std::max(worst, off);
    }
  }
  RecordProperty("worst", worst);
}

TEST(PressureMap, IsTheToneInTheMiddleOfTheLineAndLessBesideIt) {
  PressureMap map;
  map.begin({0, 0, 400, 100}, 0.0);
  map.lay(std::vector<TipAt>{{{20, 50}, 3, 0.0}, {{380, 50}, 30, 1.0}});
  for (int x = 80; x < 380; x += 10) {
    const double t = (x + 0.5 - 20) / 360, radius = 3 + 27 * t;
    EXPECT_NEAR(map.push_at(x, 50), t, 0.01) << x;
    EXPECT_LT(map.push_at(x, 50 + static_cast<int>(0.8 * radius)), map.push_at(x, 50));
    EXPECT_EQ(map.push_at(x, 50 + static_cast<int>(radius) + 4), PressureMap::kMinPush);
  }
  EXPECT_EQ(map.push_at(5, 5), PressureMap::kMinPush);
}

/// Every pixel within the tip is covered, in whatever direction the tip moved and however it grew.
TEST(PressureMap, HasNoHoles) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    std::mt19937_64 random(seed);
    const auto any = [&](double a, double b) {
      return std::uniform_real_distribution(a, b)(random);
    };
    std::vector<TipAt> way;
    Vec at{any(10, 110), any(10, 110)};
    double radius = any(0.5, 20);
    for (int k = 0; k < 12; ++k) {
      way.push_back({at, radius, any(0.1, 1.0)});
      at = at + Vec{any(-15, 15), any(-15, 15)};
      radius = std::clamp(radius + any(-8, 8), 0.3, 25.0);
    }
    PressureMap map;
    map.begin({0, 0, 120, 120}, 0.0);
    map.lay(way);
    for (const TipAt& tip : way) {
      for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 120; ++x) {
          const double d = norm(Vec{x + 0.5, y + 0.5} - tip.center_px);
          if (d > tip.radius_px) continue;
          ASSERT_GT(map.push_at(x, y), 0.04) << seed << ": " << x << ", " << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace felt::grain_test
