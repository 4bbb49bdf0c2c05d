#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "felt/base/constants.h"
#include "felt/replay/testing/guided_drawing.h"

namespace felt::guided_drawing_test {
namespace {

using testing::draw_guided;
using testing::GuidedDrawing;

GuideLine line_of(GuideKind kind, int count, const std::function<Point(double)>& at) {
  GuideLine line{.kind = kind};
  for (int i = 0; i <= count; ++i) line.points.push_back(at(double(i) / count));
  return line;
}

/// A circle of 60 mm; the person lands at the top.
GuideLine circle(GuideKind kind) {
  return line_of(kind, 200, [](double t) {
    return Point{80.0 + 30.0 * std::sin(kTau * t), 80.0 - 30.0 * std::cos(kTau * t)};
  });
}
/// Two periods of a sine, 120 mm long.
GuideLine wave(GuideKind kind) {
  return line_of(kind, 300, [](double t) {
    return Point{20.0 + 120.0 * t, 80.0 + 15.0 * std::sin(2.0 * kTau * t)};
  });
}
/// Three turns from the inside to the outside, 70 mm wide.
GuideLine spiral(GuideKind kind) {
  return line_of(kind, 500, [](double t) {
    const double radius = 2.0 + 33.0 * t;
    return Point{80.0 + radius * std::cos(3.0 * kTau * t),
                 80.0 + radius * std::sin(3.0 * kTau * t)};
  });
}

/// Returns the means over the first people of the population.
GuidedDrawing mean_drawing(const GuideLine& line, std::size_t people) {
  GuidedDrawing mean;
  const double share = 1.0 / static_cast<double>(people);
  for (const Person& person : population(people, 1)) {
    const GuidedDrawing one = draw_guided(person, line);
    mean.mean_mm += share * one.mean_mm;
    mean.rms_mm += share * one.rms_mm;
    mean.mean_n += share * one.mean_n;
    mean.max_n = std::max(mean.max_n, one.max_n);
    mean.seconds += share * one.seconds;
    mean.energy_mj = std::max(mean.energy_mj, one.energy_mj);
    mean.faults += one.faults;
  }
  return mean;
}

TEST(GuidedDrawing, AGrooveHelpsPeopleAndErrorAmplifyingDoesNot) {
  for (const Person& person : population(3, 1)) {
    const GuidedDrawing free = draw_guided(person, circle(GuideKind::kNone));
    const GuidedDrawing groove = draw_guided(person, circle(GuideKind::kGroove));
    const GuidedDrawing amplified = draw_guided(person, circle(GuideKind::kErrorAmplifying));
    EXPECT_EQ(free.max_n, 0.0);
    EXPECT_LT(groove.mean_mm, 0.85 * free.mean_mm);
    EXPECT_LE(groove.max_n, 0.8);
    EXPECT_LT(groove.mean_n, 0.4);
    EXPECT_GT(amplified.mean_mm, 1.1 * free.mean_mm);
    EXPECT_LE(amplified.max_n, 0.2);
    EXPECT_LT(groove.energy_mj, 1.0);
    GuideLine teacher = circle(GuideKind::kTeacher);  // takes 4 s
    for (std::size_t i = 0; i < teacher.points.size(); ++i) {
      teacher.times_ms.push_back(20.0 * static_cast<double>(i));
    }
    const GuidedDrawing led = draw_guided(person, teacher);
    EXPECT_LT(led.mean_mm, free.mean_mm);
    EXPECT_LE(led.max_n, 0.8);
    EXPECT_EQ(groove.faults + amplified.faults + led.faults, 0);
  }
}

/// Prints the figures of docs/design/forces.md#guides.
TEST(GuidedDrawing, DISABLED_Figures) {
  using Make = GuideLine (*)(GuideKind);
  for (const auto& [name, make] :
       {std::pair<const char*, Make>{"circle", circle}, {"wave", wave}, {"spiral", spiral}}) {
    for (const GuideKind kind : {GuideKind::kNone, GuideKind::kGroove, GuideKind::kAsNeeded,
                                 GuideKind::kErrorAmplifying}) {
      const GuidedDrawing mean = mean_drawing(make(kind), 10);
      std::printf(
          "%-7s %d  mean %.3f mm  rms %.3f mm  mean %.3f N  max %.3f N  %.2f s  %.2f mJ  %d\n",
          name, static_cast<int>(kind), mean.mean_mm, mean.rms_mm, mean.mean_n, mean.max_n,
          mean.seconds, mean.energy_mj, mean.faults);
    }
  }
}

}  // namespace
}  // namespace felt::guided_drawing_test
