#include "felt/solid/body_edits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <string>

#include "felt/solid/creases.h"
#include "felt/solid/front_paint.h"
#include "felt/solid/solid_picture.h"
#include "felt/solid/solid_writer.h"
#include "felt/solid/testing/random_bodies.h"
#include "felt/solid/testing/surface.h"
#include "felt/solid/view_frame.h"

namespace felt::body_edits_test {
namespace {

/// Two balls of radius 20, on the page at (50, 50) and (110, 50): the origin is (80, 50).
Solid two_balls() {
  testing::SolidDrawing drawing;
  drawing.circle({50, 50}, 20.0);
  drawing.circle({110, 50}, 20.0);
  Result<InflatedDrawing> inflated = inflate(drawing.document, {.triangles = 4000});
  EXPECT_TRUE(inflated);
  return std::move(inflated->solid);
}

/// A stroke from one point of the page to another.
std::vector<Vec3> stroke(Point from, Point to) {
  return {{from.x, -from.y, 0.0}, {to.x, -to.y, 0.0}};
}

BodyEdit cut(Point from, Point to) {
  return {.kind = BodyEditKind::kCut, .path_mm = stroke(from, to)};
}

BodyEdit red_line(Point from, Point to) {
  return {.kind = BodyEditKind::kPaint,
          .path_mm = stroke(from, to),
          .width_mm = 2.0,
          .color = {255, 0, 0, 255}};
}

/// A horn on the front at a point of the page.
BodyEdit horn(Point at, double radius, double z, double height) {
  BodyEdit edit{.kind = BodyEditKind::kExtrude};
  for (int i = 0; i < 40; ++i) {
    const double a = 2.0 * std::numbers::pi * i / 40;
    edit.path_mm.push_back({at.x + radius * std::cos(a), -at.y + radius * std::sin(a), 0.0});
    const double t = i / 19.5 - 1.0;
    edit.profile_mm.push_back({at.x + radius * t, -at.y, z + height * (1.0 - t * t)});
  }
  return edit;
}

std::size_t painted_points(const SolidBody& body) {
  return static_cast<std::size_t>(
      std::count_if(body.paint.begin(), body.paint.end(), [](Rgba c) { return c.a > 0; }));
}

void expect_sound(const Solid& solid) {
  for (const SolidBody& body : solid.bodies) {
    EXPECT_TRUE(check_body(body, solid.origin));
    EXPECT_EQ(testing::examine(testing::surface_of(body)).fault, "");
    EXPECT_TRUE(body.paint.empty() || body.paint.size() == body.points.size());
  }
}

TEST(BodyEdits, ActOnTheBodyBelowTheStroke) {
  const Solid before = two_balls();
  // Downwards through the second ball: the right part goes.
  const EditedSolid after = apply_body_edits(before, std::vector{cut({112, 20}, {112, 80})});
  EXPECT_EQ(after.refusals, std::vector<std::string>{""});
  ASSERT_EQ(after.solid.bodies.size(), 2U);
  expect_sound(after.solid);
  EXPECT_EQ(after.solid.bodies[0].points, before.bodies[0].points);
  EXPECT_EQ(after.solid.bodies[0].border_count, before.bodies[0].border_count);
  EXPECT_EQ(after.solid.bodies[1].border_count, 0U);
  EXPECT_LT(volume_mm3(after.solid.bodies[1]), 0.7 * volume_mm3(before.bodies[1]));
  for (const Vec3& p : after.solid.bodies[1].points) EXPECT_LE(p.x, 32.0 + 1e-9);
}

TEST(BodyEdits, R60_AnEditThatDoesNotFitIsLeftOutWithASentence) {
  const Solid before = two_balls();
  const EditedSolid after = apply_body_edits(
      before,
      std::vector{cut({50, 20}, {50, 50}), red_line({0, 0}, {10, 0}), horn({50, 50}, 5, 19, 9)});
  ASSERT_EQ(after.refusals.size(), 3U);
  EXPECT_EQ(
      after.refusals[0],
      "left out: edit 1 of the body, the cut that begins at (50.00, 20.00) mm: the stroke ends "
      "on the body");
  EXPECT_EQ(after.refusals[1],
            "left out: edit 2 of the body, the painted line that begins at (0.00, 0.00) mm: the "
            "stroke does not touch a body");
  EXPECT_EQ(after.refusals[2], "");
  EXPECT_EQ(after.reasons, (std::vector<std::string>{"the stroke ends on the body",
                                                     "the stroke does not touch a body", ""}));
  EXPECT_GT(volume_mm3(after.solid.bodies[0]), volume_mm3(before.bodies[0]));
}

TEST(BodyEdits, ACancelledListBeginsNoFurtherEdit) {
  const Solid balls = two_balls();
  const std::atomic<bool> is_cancelled{true};
  const EditedSolid result = apply_body_edits(
      balls, std::vector{cut({50, 80}, {50, 20}), red_line({100, 50}, {120, 50})}, &is_cancelled);
  EXPECT_EQ(result.refusals, std::vector<std::string>(2));
  EXPECT_EQ(result.solid.bodies[0].points, balls.bodies[0].points);
}

TEST(BodyEdits, R60_PaintStaysWhereItIsAndGoesWithThePartThatIsCutOff) {
  const std::vector edits{red_line({30, 50}, {70, 50}), cut({50, 20}, {50, 80})};
  const EditedSolid after = apply_body_edits(two_balls(), edits);
  EXPECT_EQ(after.refusals, (std::vector<std::string>{"", ""}));
  expect_sound(after.solid);
  EXPECT_GT(painted_points(after.solid.bodies[0]), 50U);
  EXPECT_EQ(painted_points(after.solid.bodies[1]), 0U);
}

TEST(BodyEdits, PaintIsSeenInPicturesAndInGlb) {
  const Solid before = two_balls();
  const EditedSolid after = apply_body_edits(before, std::vector{red_line({30, 50}, {70, 50})});
  const SolidView view{.width_px = 200, .height_px = 100, .turn_deg = 0.0, .rise_deg = 0.0};
  const Result<Image> plain = paint_solid(before, view), painted = paint_solid(after.solid, view);
  ASSERT_TRUE(plain && painted);
  const Rgba at = painted->at(47, 50), was = plain->at(47, 50);
  EXPECT_GT(at.r, at.g + 80) << "red";
  EXPECT_EQ(was.r, was.g);
  EXPECT_EQ(painted->at(47, 30).g, plain->at(47, 30).g) << "elsewhere it looks as before";
  const Result<std::string> glb = encode_solid(after.solid, SolidFormat::kGlb);
  ASSERT_TRUE(glb);
  EXPECT_NE(glb->find("COLOR_0"), std::string::npos);
  EXPECT_EQ(encode_solid(before, SolidFormat::kGlb)->find("COLOR_0"), std::string::npos);
}

TEST(BodyEdits, CutEdgesAreSharpInShading) {
  const Solid before = two_balls();
  EXPECT_EQ(split_at_creases(before.bodies[0]).points.size(), before.bodies[0].points.size());
  const EditedSolid after = apply_body_edits(before, std::vector{cut({50, 20}, {50, 80})});
  const SolidBody& half = after.solid.bodies[0];
  const SolidBody split = split_at_creases(half);
  EXPECT_GT(split.points.size(), half.points.size() + 30);
  EXPECT_LT(split.points.size(), half.points.size() + half.points.size() / 4);
  const std::vector<Vec3> normals = point_normals(split);
  for (std::size_t i = 0; i < split.points.size(); ++i) {
    // Points of the flat face, at x = 50 of the page.
    if (std::fabs(split.points[i].x + 30.0) > 1e-6) continue;
    EXPECT_TRUE(std::fabs(normals[i].x) > 0.999 || std::fabs(normals[i].x) < 0.2) << normals[i].x;
  }
}

// Random edits of random bodies, in any order: never an open body, and always the same result.
TEST(BodyEdits, R60_RandomEditsNeverBreakABody) {
  int applied = 0;
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    Random random(seed);
    Solid solid;
    solid.bodies.push_back(testing::random_body(random, 800));
    std::vector<BodyEdit> edits;
    for (int i = 0; i < 5; ++i) {
      const Vec3 view = testing::random_direction(random);
      const ViewFrame frame = view_frame(view);
      BodyEdit edit{.kind =
                        static_cast<BodyEditKind>(static_cast<int>(random.between(0.0, 3.999)))};
      edit.view = view;
      edit.width_mm = random.between(0.0, 15.0);
      edit.color = {200, 0, 0, 255};
      edit.amount = random.between(0.0, 1.0);
      const Point at{random.between(-20, 20), random.between(-20, 20)};
      const double turn = random.between(0.0, 6.28),
                   reach = edit.kind == BodyEditKind::kCut ? 90 : 10;
      for (int k = -20; k <= 20; ++k) {
        const double t = k / 20.0;
        const Vec along{std::cos(turn), std::sin(turn)};
        const Point p = edit.kind == BodyEditKind::kExtrude
                            ? at + 4.0 * Vec{std::cos(3.14 * t), std::sin(3.14 * t)}
                            : at + reach * t * along + random.between(-0.5, 0.5) * perp(along);
        edit.path_mm.push_back(frame.to_solid(p, 0.0));
        if (edit.kind != BodyEditKind::kExtrude) continue;
        edit.profile_mm.push_back(frame.to_solid(at, 0.0) + 4.0 * t * frame.right +
                                  12.0 * (1.0 - t * t) * frame.towards);
      }
      edits.push_back(std::move(edit));
    }
    const EditedSolid after = apply_body_edits(solid, edits),
                      again = apply_body_edits(solid, edits);
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_EQ(after.refusals.size(), edits.size());
    expect_sound(after.solid);
    ASSERT_EQ(after.refusals, again.refusals);
    for (const std::string& refusal : after.refusals) applied += refusal.empty() ? 1 : 0;
    for (std::size_t i = 0; i < after.solid.bodies.size(); ++i) {
      EXPECT_EQ(after.solid.bodies[i].points, again.solid.bodies[i].points);
      EXPECT_EQ(after.solid.bodies[i].paint, again.solid.bodies[i].paint);
    }
  }
  EXPECT_GT(applied, 60);
}

}  // namespace
}  // namespace felt::body_edits_test
