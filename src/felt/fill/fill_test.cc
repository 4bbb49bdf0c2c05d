#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "felt/base/random.h"
#include "felt/fill/curve_area.h"
#include "felt/fill/fill_map.h"
#include "felt/fill/fill_shape.h"
#include "felt/fill/testing/map_drawing.h"
#include "felt/geometry/intersect.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::fill_test {
namespace {

using testing::MapDrawing;

constexpr Rgba kRed{200, 0, 0, 255};

void expect_euler(const PlanarMap& map) {
  const MapCounts& c = map.counts();
  EXPECT_EQ(c.nodes + c.faces, c.edges + 1 + c.components);
}

/// The bounded faces of each component have the area inside the loop around the component.
void expect_areas(const PlanarMap& map) {
  double sum = 0.0, size = 1.0;
  for (const MapLoop& loop : map.loops()) {
    sum += loop.area_mm2;
    size += std::fabs(loop.area_mm2);
    EXPECT_TRUE(loop.outer || loop.area_mm2 > -1e-4) << loop.area_mm2;
  }
  EXPECT_NEAR(sum, 0.0, 1e-9 * size);
}

std::size_t bounded_faces(const PlanarMap& map) {
  return map.counts().faces - 1;
}

TEST(PlanarMap, random_strokes_have_the_faces_that_eulers_formula_wants) {
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomStroke random(seed);
    MapDrawing drawing;
    const int count = random.pick(1, 6);
    for (int i = 0; i < count; ++i) drawing.add(random.make());
    const PlanarMap& map = drawing.map.map(seed % 3 == 0 ? 3.0 : 0.0);
    expect_euler(map);
    expect_areas(map);
    if (::testing::Test::HasFailure()) return;
  }
}

// Lines in general position, each longer than all crossings: the bounded faces are those of a line
// arrangement, (n - 1)(n - 2) / 2.
TEST(PlanarMap, lines_have_the_faces_of_a_line_arrangement) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    MapDrawing drawing;
    std::vector<double> angles;
    const std::size_t n = 2 + seed % 7;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = std::numbers::pi * (static_cast<double>(i) + random.between(0.1, 0.9)) /
                           static_cast<double>(n);
      const Vec along{std::cos(angle), std::sin(angle)};
      const Point middle = Point{} + random.between(-20.0, 20.0) * perp(along);
      drawing.line(middle - 5e3 * along, middle + 5e3 * along, 0.05);
    }
    const PlanarMap& map = drawing.map.map(0.0);
    expect_euler(map);
    expect_areas(map);
    EXPECT_EQ(bounded_faces(map), (n - 1) * (n - 2) / 2);
    if (::testing::Test::HasFailure()) return;
  }
}

// The faces of circles are counted from their crossings, which for circles have a closed form.
TEST(PlanarMap, circles_have_the_faces_that_their_crossings_give) {
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    MapDrawing drawing;
    std::vector<std::pair<Point, double>> circles;
    const std::size_t n = 1 + seed % 6;
    std::size_t crossings = 0;
    std::vector<std::size_t> group(n);
    std::size_t components = n;
    for (std::size_t i = 0; i < n; ++i) {
      const Point centre{random.between(0.0, 30.0), random.between(0.0, 30.0)};
      circles.emplace_back(centre, random.between(2.0, 15.0));
      drawing.circle(centre, circles.back().second);
      group[i] = i;
      bool near_tangent = false;
      for (std::size_t k = 0; k < i; ++k) {
        const auto& [other, radius] = circles[k];
        const double d = distance(centre, other), r = circles[i].second;
        near_tangent = near_tangent || std::fabs(d - (r + radius)) < 0.05 ||
                       std::fabs(d - std::fabs(r - radius)) < 0.05;
        if (d >= r + radius || d <= std::fabs(r - radius)) continue;
        crossings += 2;
        const std::size_t from = group[k], to = group[i];
        if (from != to) --components;
        for (std::size_t& g : group) g = g == from ? to : g;
      }
      if (near_tangent) {  // cubics are only nearly circles
        crossings = 0;
        break;
      }
    }
    const PlanarMap& map = drawing.map.map(0.0);
    expect_euler(map);
    expect_areas(map);
    if (crossings > 0 && circles.size() == n) {
      EXPECT_EQ(bounded_faces(map), crossings + components);
    }
    if (::testing::Test::HasFailure()) return;
  }
}

TEST(FaceAt, a_map_without_strokes_is_open_everywhere) {
  MapDrawing d;
  EXPECT_FALSE(d.map.face_at({1, 1}, 3.0, {}));
  d.set(d.circle({0, 0}, 10.0), nullptr);
  EXPECT_FALSE(d.map.face_at({1, 1}, 3.0, {}));
  EXPECT_EQ(d.map.map(0.0).loops().size(), 0U);
}

TEST(FaceAt, nested_circles_have_holes) {
  MapDrawing drawing;
  for (const double r : {20.0, 12.0, 5.0}) drawing.circle({30.0, 30.0}, r);
  drawing.circle({30.0, 60.0}, 4.0);
  const auto ring = drawing.map.face_at({30.0, 46.0}, 0.0, kRed);
  ASSERT_TRUE(ring.has_value());
  ASSERT_EQ(ring->fill.loops.size(), 2U);
  EXPECT_NEAR(area_of(ring->fill.loops[0]) + area_of(ring->fill.loops[1]),
              std::numbers::pi * (400.0 - 144.0), 0.5);
  EXPECT_FALSE(is_in_fill(ring->fill, {30.0, 30.0}));
  EXPECT_EQ(ring->fill.color, kRed);
}

TEST(FaceAt, random_points_are_in_their_fill_by_the_even_odd_rule) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    testing::RandomStroke random(seed);
    MapDrawing drawing;
    for (int i = 0; i < 4; ++i) drawing.add(random.make());
    const Point p{random.uniform(0.0, 20.0), random.uniform(0.0, 20.0)};
    const auto face = drawing.map.face_at(p, 1.0, kRed);
    if (!face) continue;
    ++found;
    EXPECT_TRUE(is_in_fill(face->fill, p));
    for (const FillLoop& loop : face->fill.loops) {
      EXPECT_EQ(loop.points.size() % 3, 1U);
      EXPECT_EQ(loop.points.front(), loop.points.back());
      EXPECT_EQ(old_steps(loop).size(), loop.pieces.size());
    }
  }
  EXPECT_GT(found, 200);
}

TEST(FaceAt, dead_ends_are_not_part_of_the_boundary) {
  MapDrawing drawing;
  drawing.box(0.0, 0.0, 20.0, 20.0);
  drawing.line({-5.0, 8.0}, {10.0, 8.0});  // enters and ends inside
  drawing.line({5.0, 12.0}, {8.0, 15.0});  // alone inside
  const auto face = drawing.map.face_at({15.0, 10.0}, 0.0, kRed);
  ASSERT_TRUE(face.has_value());
  ASSERT_EQ(face->fill.loops.size(), 1U);
  EXPECT_NEAR(area_of(face->fill.loops[0]), 400.0, 1e-9);
}

TEST(FaceAt, ink_that_touches_closes_an_area) {
  MapDrawing drawing;
  drawing.line({0.0, 0.0}, {20.0, 0.0});
  drawing.line({0.0, 0.3}, {0.0, 20.0});  // 0.3 mm from the first line, widths 0.5 mm
  drawing.line({-2.0, 20.4}, {22.0, 20.4});
  drawing.line({20.3, 20.1}, {20.2, -0.2});
  const auto face = drawing.map.face_at({10.0, 10.0}, 0.0, kRed);
  ASSERT_TRUE(face.has_value()) << face.error().message;
  EXPECT_TRUE(face->bridges.empty());
  EXPECT_NEAR(area_of(face->fill.loops[0]), 20.2 * 20.4, 4.0);
}

TEST(FaceAt, gaps_are_bridged_up_to_their_size) {
  MapDrawing drawing;
  drawing.line({0.0, 0.0}, {18.0, 0.0});  // the corner at (20, 0) is missing
  drawing.line({20.0, 2.0}, {20.0, 20.0});
  drawing.line({20.0, 20.0}, {0.0, 20.0});
  drawing.line({0.0, 20.0}, {0.0, 0.0});
  const auto open = drawing.map.face_at({10.0, 10.0}, 1.0, kRed);
  ASSERT_FALSE(open.has_value());
  EXPECT_EQ(open.error().message, "the area is open: it has a gap of 2.83 mm at (18.00, 0.00)");
  const auto closed = drawing.map.face_at({10.0, 10.0}, 3.0, kRed);
  ASSERT_TRUE(closed.has_value());
  ASSERT_EQ(closed->bridges.size(), 1U);
  EXPECT_NEAR(area_of(closed->fill.loops[0]), 400.0, 1e-6);  // the tangents meet in the corner
}

TEST(FaceAt, an_end_is_extended_to_the_line_in_its_path) {
  MapDrawing drawing;
  drawing.box(0.0, 0.0, 20.0, 20.0);
  drawing.line({10.0, 0.0}, {10.0, 18.5});
  const auto all = drawing.map.face_at({5.0, 10.0}, 1.0, kRed);
  const auto half = drawing.map.face_at({5.0, 10.0}, 2.0, kRed);
  ASSERT_TRUE(all.has_value() && half.has_value());
  EXPECT_NEAR(area_of(all->fill.loops[0]), 400.0, 1e-9);
  EXPECT_NEAR(area_of(half->fill.loops[0]), 200.0, 1e-9);
  ASSERT_EQ(half->bridges.size(), 1U);
  EXPECT_NEAR(half->bridges[0].length_mm, 1.5, 1e-9);
}

TEST(FaceAt, says_why_there_is_no_fill) {
  MapDrawing drawing;
  drawing.box(0.0, 0.0, 20.0, 20.0);
  EXPECT_EQ(drawing.map.face_at({40.0, 5.0}, 0.0, kRed).error().message, "the area is open");
  EXPECT_EQ(drawing.map.face_at({20.0, 5.0}, 0.0, kRed).error().message,
            "the point is on a line, not in an area");
  EXPECT_FALSE(drawing.map.face_at({std::nan(""), 5.0}, 0.0, kRed).has_value());
  EXPECT_FALSE(drawing.map.face_at({5.0, 5.0}, -1.0, kRed).has_value());
}

TEST(PlanarMap, coincident_and_touching_strokes_keep_eulers_formula) {
  MapDrawing drawing;
  drawing.box(0.0, 0.0, 20.0, 20.0);
  drawing.box(0.0, 0.0, 20.0, 20.0);        // a copy
  drawing.line({0.0, 0.0}, {30.0, 0.0});    // on a side, longer
  drawing.line({5.0, 20.0}, {10.0, 20.0});  // on a side, shorter
  drawing.circle({10.0, 10.0}, 10.0);       // touches the sides
  drawing.circle({10.0, 10.0}, 10.0);
  drawing.circle({30.0, 10.0}, 10.0);          // touches the first
  drawing.line({1e8, 1e8}, {1e8 + 7.0, 1e8});  // far away
  const PlanarMap& map = drawing.map.map(0.0);
  expect_euler(map);
  EXPECT_EQ(bounded_faces(map),
            7U);  // 5 in the box, a circle, and one between it, a side and the line
}

// Copies, copies moved by less and less, and parts of the same curve, at growing coordinates.
TEST(PlanarMap, nearly_coincident_strokes_end_and_give_the_same_result_again) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const auto make = [&] {
      testing::RandomStroke random(seed);
      StrokeData data = random.make();
      const double far = seed % 4 == 0 ? 0.0 : std::pow(10.0, static_cast<double>(seed % 9));
      for (Point& p : data.points) p += Vec{far, -far};
      if (!check_invariants(data).has_value()) return MapDrawing{};  // rounding broke the stroke
      MapDrawing drawing;
      drawing.add(data);
      for (const double shift : {0.0, 1e-10, 1e-8, 1e-6, 1e-4}) {
        StrokeData moved = data;
        for (Point& p : moved.points) p += Vec{shift, 0.5 * shift};
        if (check_invariants(moved).has_value()) drawing.add(moved);
      }
      return drawing;
    };
    MapDrawing first = make(), second = make();
    EXPECT_EQ(first.map.map(1.0).edges().nodes, second.map.map(1.0).edges().nodes);
    EXPECT_EQ(first.map.map(1.0).counts().faces, second.map.map(1.0).counts().faces);
    EXPECT_LT(first.map.map(1.0).counts().nodes, 10'000U);
  }
}

TEST(PlanarMap, an_update_gives_the_same_map_as_a_new_one) {
  testing::RandomStroke random(5);
  std::vector<StrokePtr> strokes;
  for (int i = 0; i < 8; ++i) {
    strokes.push_back(std::make_shared<const Stroke>(Stroke::create(random.make()).value()));
  }
  FillMap changed, fresh;
  for (std::size_t i = 0; i < 8; ++i) {  // other strokes first
    changed.update(std::vector<FillLine>{{StrokeId{i + 1}, strokes[(i + 3) % 8]}});
  }
  changed.map(1.0);
  changed.update(std::vector<FillLine>{{StrokeId{3}, nullptr}});
  changed.map(1.0);
  std::vector<FillLine> all;
  for (std::size_t i = 0; i < 8; ++i) all.push_back({StrokeId{i + 1}, strokes[i]});
  changed.update(all);
  fresh.update(all);
  for (const double gap : {0.0, 1.0}) {
    EXPECT_EQ(changed.map(gap).edges().nodes, fresh.map(gap).edges().nodes);
    EXPECT_EQ(changed.map(gap).counts().faces, fresh.map(gap).counts().faces);
  }
}

// The index of segments leaves out no pair of strokes that meets.
TEST(LineMeetings, are_those_of_all_pairs_of_segments) {
  testing::RandomStroke random(11);
  std::vector<FillLine> lines;
  for (std::uint64_t i = 1; i <= 40; ++i) {
    StrokeData data = random.make();
    for (Point& p : data.points) p += Vec{3.0 * static_cast<double>(i), 0.0};
    lines.push_back({StrokeId{i}, std::make_shared<const Stroke>(Stroke::create(data).value())});
  }
  LineMeetings meetings;
  meetings.update(std::vector(lines.begin() + 20, lines.end()));
  meetings.update(lines);
  std::size_t met = 0;
  for (const FillLine& a : lines) {
    for (const FillLine& b : lines) {
      if (!(a.id < b.id)) continue;
      std::size_t count = 0;
      for (int i = 0; i < a.stroke->segment_count(); ++i) {
        for (int j = 0; j < b.stroke->segment_count(); ++j) {
          const Crossings found = intersections(a.stroke->segment(i), b.stroke->segment(j));
          count += static_cast<std::size_t>(std::distance(found.begin(), found.end()));
        }
      }
      EXPECT_EQ(meetings.between(a.id, b.id).size(), count);
      met += count;
    }
  }
  EXPECT_GT(met, 100U);
  for (const FillLine& line : lines) meetings.update(std::vector<FillLine>{{line.id, nullptr}});
  EXPECT_TRUE(meetings.lines().empty());
  EXPECT_TRUE(meetings.lines_in({-1e6, -1e6, 1e6, 1e6}).empty());
}

}  // namespace
}  // namespace felt::fill_test
