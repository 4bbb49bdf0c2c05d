#include "felt/render/grain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "felt/base/hash.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "felt/io/picture/png.h"
#include "felt/render/page_painter.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::grain_test {
namespace {

/// The effect of a texture on a pen that rests at a point, pressed with 0.5 N.
struct Felt {
  Force force;
  double friction_factor;
};
Felt force_at(const Texture& texture, Point place) {
  ForceMemory memory;
  memory.begin_tick(0.001);
  memory.normal_force_n = 0.5;
  PenSample pen;
  pen.position = {place.x, place.y, -1.0};
  const Force force = texture(pen, memory);
  return {force, memory.friction_factor};
}

std::vector<const HeightField*> reliefs() {
  std::vector<const HeightField*> all;
  for (const SurfaceMaterial& surface : surface_materials()) {
    if (const HeightField* field = surface_grain(surface)) all.push_back(field);
  }
  return all;
}

TEST(Grain, R47_OneHeightMapForEyeAndHand) {
  ASSERT_EQ(reliefs().size(), surface_materials().size() - 1);  // all but glass
  for (const HeightField* field : reliefs()) {
    const Grain eye(field);
    const Texture slopes(field, {.law = TextureLaw::kGradient});
    const Texture heights(field, {.law = TextureLaw::kFriction});
    // The ratio of force to slope is measured at one point. At all others, the slope that the
    // renderer uses must predict the force with this ratio.
    const Point first{3.21, 4.56};
    const double per_slope = force_at(slopes, first).force.x / eye.at(first).slope.x;
    ASSERT_LT(per_slope, 0.0);
    // Friction is bounded and so not proportional to the height. But of two points, the one that
    // the renderer draws higher must have more friction.
    std::vector<std::pair<double, double>> seen_and_felt;
    Fnv1a by_hand, by_eye;
    for (int y = 0; y < 100; ++y) {
      for (int x = 0; x < 100; ++x) {
        const Point p{0.173 * x - 5, 0.219 * y + 7};
        const HeightField::Sample seen = eye.at(p), known = field->at(p);
        const Force force = force_at(slopes, p).force;
        ASSERT_NEAR(force.x, per_slope * seen.slope.x, 1e-12);
        ASSERT_NEAR(force.y, per_slope * seen.slope.y, 1e-12);
        const double factor = force_at(heights, p).friction_factor;
        ASSERT_EQ(factor > 1.0, seen.height_mm > 0.0);
        seen_and_felt.emplace_back(seen.height_mm, factor);
        by_hand.add_value(known.height_mm);
        by_eye.add_value(seen.height_mm);
      }
    }
    EXPECT_EQ(by_hand.value(), by_eye.value());
    std::sort(seen_and_felt.begin(), seen_and_felt.end());
    for (std::size_t i = 1; i < seen_and_felt.size(); ++i) {
      const bool is_higher = seen_and_felt[i].first > seen_and_felt[i - 1].first + 1e-9;
      ASSERT_TRUE(is_higher ? seen_and_felt[i].second > seen_and_felt[i - 1].second
                            : seen_and_felt[i].second >= seen_and_felt[i - 1].second);
    }
  }
}

TEST(Grain, R47_ThePngIsTheSameBytesWhoeverMadeTheField) {
  const auto png = [](const HeightField* field) {
    std::vector<StrokePtr> strokes;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      strokes.push_back(std::make_shared<const Stroke>(testing::random_stroke(seed)));
    }
    PageOptions page{.dpi = 150, .area = Rect{0, 0, 20, 20}};
    page.grain = Grain(field);
    return encode_png(render_page(strokes, page).value(), page.dpi).value();
  };
  for (const HeightField* field : reliefs()) {
    const HeightField again(field->spec());
    const std::string bytes = png(field);
    EXPECT_EQ(png(&again), bytes);
    EXPECT_EQ(png(field), bytes);
    EXPECT_NE(png(nullptr), bytes);
  }
}

}  // namespace
}  // namespace felt::grain_test
