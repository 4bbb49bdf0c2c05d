// Simulated people draw over lines that are on the page (docs/design/forces.md#retracing).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "felt/base/constants.h"
#include "felt/document/edit_builder.h"
#include "felt/replay/testing/guided_drawing.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::retraced_drawing_test {
namespace {

using testing::draw_guided;
using testing::GuidedDrawing;

constexpr double kSlowPace = 0.25;

GuideLine path_of(int count, const std::function<Point(double)>& at) {
  GuideLine line;
  for (int i = 0; i <= count; ++i) line.points.push_back(at(double(i) / count));
  return line;
}
GuideLine wave() {
  return path_of(100, [](double t) {
    return Point{40.0 + 90.0 * t, 80.0 + 12.0 * std::sin(1.5 * kTau * t)};
  });
}
GuideLine circle() {
  return path_of(100, [](double t) {
    return Point{80.0 + 25.0 * std::sin(kTau * t), 80.0 - 25.0 * std::cos(kTau * t)};
  });
}

/// Returns a page with lines of ink along paths, each moved down by `down_mm`.
Document page_with(const std::vector<GuideLine>& paths, double down_mm = 0.0) {
  Document document;
  EditBuilder edit(document);
  for (const GuideLine& path : paths) {
    std::vector<Point> points = path.points;
    for (Point& p : points) p.y += down_mm;
    edit.add(document.layers().front().id,
             std::make_shared<const Stroke>(testing::polyline_stroke(points)));
  }
  EXPECT_TRUE(document.apply(std::move(edit).build("Draw")));
  return document;
}

/// Returns people of all models who draw slowly.
std::vector<Person> slow_people(std::size_t of_each) {
  std::vector<Person> people;
  for (const PersonModel model : kPersonModels) {
    for (Person person : population(of_each, 1, model)) {
      person.pace = kSlowPace;
      people.push_back(person);
    }
  }
  return people;
}

TEST(RetracedDrawing, R71_ALineThatIsDrawnOverHoldsThePenWithASmallForce) {
  double off_mm = 0.0, on_mm = 0.0, mean_n = 0.0, drawings = 0.0;
  for (const Person& person : slow_people(2)) {
    for (const GuideLine& path : {wave(), circle()}) {
      const Document page = page_with({path});
      const GuidedDrawing off = draw_guided(person, path, 0, page, "0");
      const GuidedDrawing on = draw_guided(person, path, 0, page);
      off_mm += off.mean_mm;
      on_mm += on.mean_mm;
      mean_n += on.mean_n;
      ++drawings;
      EXPECT_EQ(off.max_n, 0.0);
      EXPECT_GT(on.max_n, 0.0);
      EXPECT_LE(on.max_n, 0.1 + 1e-9);
      EXPECT_LE(on.energy_mj, 0.2);
      EXPECT_EQ(on.faults, 0);
    }
  }
  EXPECT_LE(on_mm, 0.65 * off_mm);
  EXPECT_LE(mean_n / drawings, 0.05);
}

TEST(RetracedDrawing, R71_FirstLinesAndLinesBesideOthersAreNotHeld) {
  const GuideLine path = wave();
  for (const Person& person : slow_people(1)) {
    EXPECT_EQ(draw_guided(person, path).max_n, 0.0);
    EXPECT_EQ(draw_guided(person, path, 0, page_with({path}, 1.5)).max_n, 0.0);
    // As in a hatching: the pen retraces the middle one of three lines.
    GuideLine above = path, below = path;
    for (Point& p : above.points) p.y -= 1.2;
    for (Point& p : below.points) p.y += 1.2;
    EXPECT_EQ(draw_guided(person, path, 0, page_with({path, above, below})).max_n, 0.0);
  }
}

}  // namespace
}  // namespace felt::retraced_drawing_test
