#include "felt/render/visit_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "felt/material/relief.h"
#include "felt/render/ink_look.h"
#include "felt/render/page_painter.h"
#include "felt/render/tip_travel.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::visit_map_test {
namespace {

constexpr const char* kDry[] = {"pencil-hard", "pencil", "pencil-soft",
                                "charcoal",    "chalk",  "crayon"};

const Grain& on_paper() {
  static const Grain grain(surface_grain(*find_surface("paper")));
  return grain;
}

/// Returns a stroke of straight segments through these points.
StrokePtr path_of(const std::vector<Point>& corners, const char* medium, double width_mm,
                  double tone, std::uint8_t alpha = 255) {
  StrokeData data;
  data.points = {corners[0]};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Vec step = corners[i] - corners[i - 1];
    for (const double t : {1.0 / 3.0, 2.0 / 3.0}) data.points.push_back(corners[i - 1] + t * step);
    data.points.push_back(corners[i]);
  }
  data.joints.assign(corners.size() - 2, JointKind::kCorner);
  const auto size = static_cast<double>(corners.size() - 1);
  data.widths = {{0.0, width_mm, tone}, {size, width_mm, tone}};
  data.medium = medium;
  data.color = {0, 0, 0, alpha};
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

Image picture_of(const std::vector<StrokePtr>& strokes, const Rect& area, double dpi = 200) {
  PageOptions options{.dpi = dpi, .area = area};
  options.grain = on_paper();
  return render_page(strokes, options).value();
}

/// Returns the mean darkness of a picture on white, 0..1.
double darkness_of(const Image& image) {
  double sum = 0.0;
  for (std::size_t i = 0; i < image.bytes().size(); i += 4) sum += 255.0 - image.bytes()[i];
  return sum / (255.0 * 0.25 * static_cast<double>(image.bytes().size()));
}

constexpr Point kLeft{5, 10}, kRight{45, 10}, kTop{25, 2}, kBottom{25, 18};
constexpr Rect kMiddle{15, 9.7, 35, 10.3};

TEST(Visits, ThereAndBackIsAsDarkAsTwoStrokes) {
  for (const char* medium : kDry) {
    const StrokePtr once = path_of({kLeft, kRight}, medium, 1.6, 0.5);
    const StrokePtr back = path_of({kLeft, kRight, kLeft}, medium, 1.6, 0.5);
    const double one = darkness_of(picture_of({once}, kMiddle));
    const double two = darkness_of(picture_of({once, once}, kMiddle));
    EXPECT_NEAR(darkness_of(picture_of({back}, kMiddle)), two, 0.02) << medium;
    EXPECT_GT(two, one + 0.08) << medium;
  }
}

TEST(Visits, ACrossingIsAsDarkAsThatOfTwoStrokes) {
  const std::vector<Point> path{kLeft, kRight, {45, 2}, kTop, kBottom};
  const Rect around{24.0, 9.0, 26.0, 11.0};
  for (const char* medium : kDry) {
    const Image together = picture_of({path_of(path, medium, 1.6, 0.5)}, around);
    const Image apart = picture_of(
        {path_of({kLeft, kRight}, medium, 1.6, 0.5), path_of({kTop, kBottom}, medium, 1.6, 0.5)},
        around);
    int worst = 0;
    for (std::size_t i = 0; i < apart.bytes().size(); ++i) {
      worst = std::max(worst, std::abs(apart.bytes()[i] - together.bytes()[i]));
    }
    EXPECT_LE(worst, 14) << medium;  // the coverage of a visit has 16 steps
    EXPECT_NEAR(darkness_of(together), darkness_of(apart), 0.005) << medium;
  }
}

TEST(Visits, InkAndTransparencyDoNotBuildUp) {
  for (const Medium& medium : media()) {
    if (!medium.draws) continue;
    const auto look = on_paper().look(medium.id, 8.0);
    const bool is_dry = std::find(std::begin(kDry), std::end(kDry), medium.id) != std::end(kDry);
    EXPECT_EQ(look && look->builds_up, is_dry) << medium.id;
    if (is_dry) continue;
    const Image once =
        picture_of({path_of({kLeft, kRight}, medium.id.c_str(), 1.6, 0.5, 128)}, kMiddle);
    EXPECT_EQ(
        picture_of({path_of({kLeft, kRight, kLeft}, medium.id.c_str(), 1.6, 0.5, 128)}, kMiddle),
        once)
        << medium.id;
  }
}

/// A line that turns by at most its own width is as dark in the turn as elsewhere: the same
/// picture as with the pressure of one visit. A second visit counts from 1.5 widths on.
TEST(Visits, ATightTurnIsNoVisit) {
  for (const double back_mm : {0.2, 0.5, 0.9}) {
    const StrokePtr turned = path_of({kLeft, {25, 10}, {25 - back_mm, 10.001}}, "pencil", 1.6, 0.5);
    const StrokePtr plain = path_of({kLeft, {25, 10}}, "pencil", 1.6, 0.5);
    EXPECT_NEAR(darkness_of(picture_of({turned}, kMiddle)),
                darkness_of(picture_of({plain}, kMiddle)), 0.002)
        << back_mm;
  }
}

/// Moving the corner of a hairpin by small steps changes no pixel by much.
TEST(Visits, SmallEditsMakeSmallChanges) {
  for (const char* medium : {"pencil", "charcoal"}) {
    Image last = Image::create(1, 1).value();
    int largest = 0;
    for (int step = 0; step <= 200; ++step) {
      const double end = 20.0 + 0.01 * step;
      const std::vector<Point> path{{12, 10}, {end, 10}, {12, 10.2 + 0.005 * step}};
      Image now = picture_of({path_of(path, medium, 1.6, 0.6)}, {10, 8, 26, 13}, 96);
      if (step > 0) {
        for (std::size_t i = 0; i < now.bytes().size(); ++i) {
          largest = std::max(largest, std::abs(now.bytes()[i] - last.bytes()[i]));
        }
      }
      last = std::move(now);
    }
    EXPECT_LE(largest, 24) << medium;
  }
}

/// A ring is as dark at its seam as elsewhere.
TEST(Visits, TheSeamOfAClosedStrokeIsNoCrossing) {
  StrokeData data;
  const double r = 10.0, k = 0.5523 * r;
  data.points = {{30, 20},     {30, 20 + k}, {20 + k, 30}, {20, 30},     {20 - k, 30},
                 {10, 20 + k}, {10, 20},     {10, 20 - k}, {20 - k, 10}, {20, 10},
                 {20 + k, 10}, {30, 20 - k}, {30, 20}};
  data.widths = {{0.0, 1.6, 0.5}, {4.0, 1.6, 0.5}};
  data.medium = "pencil";
  data.closed = true;
  data.joints.assign(4, JointKind::kCorner);
  const auto closed = std::make_shared<const Stroke>(Stroke::create(data).value());
  const Rect seam{29.4, 18.5, 30.6, 21.5};
  // One visit: the line through the seam as a stroke of its own.
  StrokeData open = data;
  open.closed = false;
  open.joints.assign(1, JointKind::kCorner);
  open.points = {data.points[9], data.points[10], data.points[11], data.points[12],
                 data.points[1], data.points[2],  data.points[3]};
  open.widths = {{0.0, 1.6, 0.5}, {2.0, 1.6, 0.5}};
  const auto through = std::make_shared<const Stroke>(Stroke::create(open).value());
  EXPECT_NEAR(darkness_of(picture_of({closed}, seam)), darkness_of(picture_of({through}, seam)),
              0.002);
}

TEST(Visits, AScribbleOfThousandsOfCrossingsSaturates) {
  std::vector<Point> path;
  for (int i = 0; i < 2000; ++i) path.push_back({i % 2 == 0 ? 5.0 : 25.0, 5.0 + 0.003 * i});
  const Image image = picture_of({path_of(path, "pencil", 0.6, 0.5)}, {6, 6, 24, 10});
  EXPECT_GT(darkness_of(image), 0.8);
  EXPECT_LE(darkness_of(image), 1.0);
}

TEST(Visits, TravelCountsWidthsAndDoesNotDependOnTheSteps) {
  const Cubic line{{Point{0, 0}, Point{30, 0}, Point{60, 0}, Point{90, 0}}};
  EXPECT_NEAR(segment_travel(line, 3.5, 3.5), 10.0, 1e-12);
  std::vector<TipAt> tips;
  for (int i = 0; i <= 9; ++i) tips.push_back({{10.0 * i, 0.0}, 3.5, 1.0});
  set_travel(tips, 2.0, 10.0);
  EXPECT_DOUBLE_EQ(tips.front().travel, 2.0);
  EXPECT_NEAR(tips[3].travel, 2.0 + 10.0 / 3.0, 1e-12);
  EXPECT_DOUBLE_EQ(tips.back().travel, 12.0);
  std::vector<TipAt> dot(3, TipAt{{5, 5}, 2.0, 1.0});
  set_travel(dot, 1.0, 0.0);
  EXPECT_EQ(dot[2].travel, 1.0);
}

}  // namespace
}  // namespace felt::visit_map_test
