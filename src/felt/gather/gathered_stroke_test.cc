#include "felt/gather/gathered_stroke.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "felt/stroke/fit/ink_fitter.h"

namespace felt::gathered_stroke_test {
namespace {

std::shared_ptr<const Stroke> stroke_at(double y, double width_mm, double length_mm = 80.0) {
  StrokeData data;
  for (int i = 0; i <= 3; ++i) data.points.push_back({length_mm * i / 3.0, y});
  data.widths = {{0.0, width_mm}, {1.0, width_mm}};
  data.color = {10, 20, static_cast<std::uint8_t>(length_mm), 255};
  data.medium = "charcoal";
  return std::make_shared<const Stroke>(Stroke::create(data).value());
}

// An arc of a circle with radius 30, in degrees.
std::shared_ptr<const Stroke> arc(double from_deg, double to_deg) {
  InkFitter fitter({});
  fitter.begin();
  for (double a = from_deg; a <= to_deg; a += 2.0) {
    const double r = a * 3.14159265358979 / 180.0;
    fitter.push({{30.0 * std::cos(r), 30.0 * std::sin(r)}, std::nullopt, std::nullopt});
  }
  fitter.end();
  return std::make_shared<const Stroke>(fitter.stroke().value());
}

TEST(GatheredStroke, HasTheMedianWidthAndTheLooksOfTheLongest) {
  const std::vector strokes{stroke_at(0, 1.0), stroke_at(1, 2.0, 90.0), stroke_at(2, 5.0)};
  const Stroke stroke = gathered_stroke(strokes, {}).value();
  EXPECT_DOUBLE_EQ(stroke.width_mm(0.0), 2.0);
  EXPECT_EQ(stroke.color(), (Rgba{10, 20, 90, 255}));
  EXPECT_EQ(stroke.medium(), "charcoal");
  EXPECT_NEAR(stroke.position(stroke.segment_count() / 2.0).y, 1.0, 0.1);
}

TEST(GatheredStroke, KeepsTheToneOfTheBundle) {
  std::vector<std::shared_ptr<const Stroke>> strokes;
  for (const double tone : {0.2, 0.6, 0.9}) {
    StrokeData data = stroke_at(tone, 0.8)->data();
    // The ends taper, as a hand draws them.
    data.widths = {{0.0, 0.8, 0.0}, {0.2, 0.8, tone}, {0.8, 0.8, tone}, {1.0, 0.8, 0.0}};
    strokes.push_back(std::make_shared<const Stroke>(Stroke::create(data).value()));
  }
  for (const GatheredWidth width : {GatheredWidth::kMedian, GatheredWidth::kStrip}) {
    const Stroke stroke = gathered_stroke(strokes, {.width = width}).value();
    for (const WidthKnot& knot : stroke.widths()) EXPECT_NEAR(knot.tone, 0.6, 0.06);
  }
}

RC_GTEST_PROP(GatheredStroke, KeepsOneToneOfEveryMedium, ()) {
  const double tone = *rc::gen::inRange(0, 101) / 100.0;
  StrokeData data = stroke_at(0.0, 0.7)->data();
  data.medium = *rc::gen::element<std::string>("pencil", "charcoal", "chalk", "ink-pen", "mine");
  data.widths = {{0.0, 0.7, tone}, {1.0, 0.7, tone}};
  std::vector<std::shared_ptr<const Stroke>> strokes;
  for (int i = 0; i < *rc::gen::inRange(2, 6); ++i) {
    for (Point& p : data.points) p.y += 0.4;
    strokes.push_back(std::make_shared<const Stroke>(Stroke::create(data).value()));
  }
  const Stroke stroke = gathered_stroke(strokes, {}).value();
  RC_ASSERT(stroke.tone(0.0) == tone && stroke.tone(stroke.segment_count()) == tone);
  RC_ASSERT(stroke.medium() == data.medium);
}

TEST(GatheredStroke, CanBeAsWideAsTheStrip) {
  const std::vector strokes{stroke_at(0, 1.0), stroke_at(4, 1.0)};
  const Stroke stroke = gathered_stroke(strokes, {.width = GatheredWidth::kStrip}).value();
  EXPECT_NEAR(stroke.width_mm(0.0), 5.0, 0.01);
}

TEST(GatheredStroke, IsClosedIfTheStripIs) {
  const std::vector strokes{arc(0, 150), arc(130, 270), arc(240, 380)};
  const Stroke stroke = gathered_stroke(strokes, {}).value();
  EXPECT_TRUE(stroke.closed());
  for (double u = 0.0; u < stroke.segment_count(); u += 0.1) {
    EXPECT_NEAR(norm(stroke.position(u) - Point{0, 0}), 30.0, 0.5);
  }
}

TEST(GatheredStroke, NeedsAStroke) {
  EXPECT_FALSE(gathered_stroke({}, {}));
}

}  // namespace
}  // namespace felt::gathered_stroke_test
