#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "felt/geometry/polyline.h"
#include "felt/render/raster.h"
#include "felt/tools/eraser/eraser_tool.h"
#include "felt/tools/testing/tool_fixture.h"

namespace felt::erased_test {
namespace {

using testing::Fixture;
using testing::Pen;
using testing::straight_stroke;
using testing::way;
using testing::operator+;

constexpr double kPxPerMm = 20.0;
constexpr double kPixelMm = 1.0 / kPxPerMm;
/// If the centre of a pixel is at least this far inside an edge, the whole pixel is inside.
constexpr double kEdgeMm = 0.75 * kPixelMm;

Image picture_of(const Fixture& fixture, const Rect& area) {
  Image image = Image::create(static_cast<int>(std::ceil((area.x1 - area.x0) * kPxPerMm)),
                              static_cast<int>(std::ceil((area.y1 - area.y0) * kPxPerMm)))
                    .value();
  Rasterizer rasterizer;
  const View view{{area.x0, area.y0}, kPxPerMm};
  const Pixels pixels = image.pixels();
  for (const StrokePtr& s : fixture.strokes()) rasterizer.draw(*s, view, pixels.rect(), pixels);
  return image;
}

/// The areas of the picture that a gesture of the eraser changed.
struct Damage {
  double covered_mm2 = 0.0;  ///< ink that the eraser covered
  double left_mm2 = 0.0;     ///< covered ink that is still there afterwards
  double lost_mm2 = 0.0;     ///< ink that the eraser did not cover but that is gone
  double gained_mm2 = 0.0;   ///< new ink on an area without ink
  std::size_t strokes = 0;
};

struct Case {
  std::vector<Stroke> strokes;
  std::vector<Point> corners;  // corners of the eraser's path
  double radius_mm = 2.0;
  bool include_width = true;
};

Damage erase(const Case& c) {
  Fixture fixture;
  EraserTool tool;
  EXPECT_TRUE(tool.set_option("radius_mm", c.radius_mm));
  if (!c.include_width) {
    EXPECT_TRUE(tool.set_option("include_width", false));
  }
  Rect area;
  for (const Stroke& s : c.strokes) {
    area.extend(s.bounds());
    fixture.add(s);
  }
  area = area.inflated(1.0);
  const Image before = picture_of(fixture, area);
  Pen pen(tool, fixture);
  std::vector<Point> path;
  for (std::size_t k = 0; k + 1 < c.corners.size(); ++k) {
    path = path + way(c.corners[k], c.corners[k + 1], 1.0);
  }
  pen.line(path);
  const Image after = picture_of(fixture, area);
  Damage damage{.strokes = fixture.strokes().size()};
  constexpr double kPixelArea = kPixelMm * kPixelMm;
  for (int y = 0; y < before.height(); ++y) {
    for (int x = 0; x < before.width(); ++x) {
      const double was = before.at(x, y).a / 255.0, is = after.at(x, y).a / 255.0;
      const Point p{area.x0 + (x + 0.5) * kPixelMm, area.y0 + (y + 0.5) * kPixelMm};
      const double off =
          std::sqrt(nearest_on_polyline(c.corners, p).distance_squared) - c.radius_mm;
      if (off < -kEdgeMm) {
        damage.covered_mm2 += was * kPixelArea;
        damage.left_mm2 += is * kPixelArea;
      } else if (off > kEdgeMm) {
        damage.lost_mm2 += std::max(0.0, was - is) * kPixelArea;
      }
      damage.gained_mm2 += std::max(0.0, is - was - 0.02) * kPixelArea;
    }
  }
  return damage;
}

/// Returns the area by which two round ends are smaller than two square ends. For each end it is
/// half a square minus half a disc, both as wide as the line.
double corners_mm2(double width_mm) {
  return width_mm * width_mm * (1.0 - 0.25 * std::numbers::pi);
}

void expect_clean(const Damage& d, const std::string& what) {
  EXPECT_GT(d.covered_mm2, 0.0) << what;
  EXPECT_LE(d.left_mm2, 0.002 * d.covered_mm2) << what;
  EXPECT_LE(d.gained_mm2, 0.02) << what;
}

TEST(Erased, R39_WhatTheEraserCoveredIsGoneAtAnyWidth) {
  for (const double radius : {0.2, 2.0}) {
    for (const double width : {0.05, 0.3, 1.0, 3.0, 4.0, 5.0, 6.0, 12.0, 20.0}) {
      Case c{{straight_stroke({10, 0}, {70, 0}, width, width)}, {{40, -20}, {40, 20}}, radius};
      const Damage d = erase(c);
      const std::string what =
          "radius " + std::to_string(radius) + ", width " + std::to_string(width);
      expect_clean(d, what);
      EXPECT_EQ(d.strokes, 2u) << what;
      EXPECT_LE(d.lost_mm2, 1.02 * corners_mm2(width) + 0.1 * width + 0.03) << what;
    }
  }
}

TEST(Erased, R39_ALineThatOnlyLosesItsRimStaysOneLineAndKeepsTheRest) {
  for (const double depth : {0.1, 0.5, 1.0, 2.0}) {
    Case c{{straight_stroke({0, 0}, {60, 0}, 6, 6)}, {{20, 5 - depth}, {40, 5 - depth}}};
    const Damage d = erase(c);
    const std::string what = std::to_string(depth) + " mm of the rim";
    expect_clean(d, what);
    EXPECT_EQ(d.strokes, 1u) << what;
    EXPECT_LE(d.lost_mm2, 1.2 * d.covered_mm2 + 1.0) << what << ": the other rim, as much again";
  }
}

TEST(Erased, R39_ARingThatIsTouchedAllAroundIsCutAnywhere) {
  constexpr double kRingMm = 5.0, kArm = 4.0 / 3.0 * kRingMm;
  const Stroke ring = Stroke::create({.points = {{-kRingMm, 0},
                                                 {-kRingMm, kArm},
                                                 {kRingMm, kArm},
                                                 {kRingMm, 0},
                                                 {kRingMm, -kArm},
                                                 {-kRingMm, -kArm},
                                                 {-kRingMm, 0}},
                                      .joints = {JointKind::kSmooth, JointKind::kSmooth},
                                      .closed = true,
                                      .widths = {{0, 4}, {2, 4}}})
                          .value();
  for (int k = 0; k < 40; ++k) {
    const double angle = 0.1 + 2.0 * std::numbers::pi * k / 40;
    const Point out{kRingMm * std::cos(angle), kRingMm * std::sin(angle)};
    const Damage d = erase({{ring}, {{0, 0}, out}, 3.5});
    EXPECT_GT(d.covered_mm2, 10.0);
    EXPECT_LE(d.left_mm2, 0.003 * d.covered_mm2) << "angle " << angle;
  }
}

TEST(Erased, R39_AnyLineAnyWidthAnyPath) {
  double covered = 0.0, left = 0.0, lost = 0.0, gained = 0.0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    testing::RandomStroke make(seed);
    StrokeData data = make.make();
    data.color = {0, 0, 0, 255};
    const double largest = make.chance(0.5) ? 6.0 : 1.0;
    for (WidthKnot& k : data.widths) k.width_mm = make.uniform(0.05, largest);
    if (data.closed) data.widths.back().width_mm = data.widths.front().width_mm;
    Case c{{Stroke::create(std::move(data)).value()}, {}, make.uniform(0.2, 4.0)};
    for (int k = 0; k < 3; ++k) c.corners.push_back({make.uniform(0, 20), make.uniform(0, 20)});
    const Damage d = erase(c);
    EXPECT_LE(d.left_mm2, 0.003 * d.covered_mm2 + 0.001) << "seed " << seed;
    EXPECT_LE(d.gained_mm2, 0.05) << "seed " << seed;
    covered += d.covered_mm2;
    left += d.left_mm2;
    lost += d.lost_mm2;
    gained += d.gained_mm2;
  }
  RecordProperty("covered_mm2", std::to_string(covered));
  RecordProperty("left_mm2", std::to_string(left));
  RecordProperty("lost_mm2", std::to_string(lost));
  RecordProperty("gained_mm2", std::to_string(gained));
  EXPECT_LE(left, 0.001 * covered);
  EXPECT_LE(lost, 0.33 * covered);
}

TEST(Erased, TheCentreLineCountsIfAsked) {
  Case c{{straight_stroke({0, 0}, {60, 0}, 6, 6)}, {{30, -20}, {30, 20}}};
  c.include_width = false;
  EXPECT_GT(erase(c).left_mm2, 10.0) << "round caps grow back over the cut";
}

}  // namespace
}  // namespace felt::erased_test
