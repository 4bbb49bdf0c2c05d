#include "felt/devices/simulated/towed_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/devices/simulated/person.h"

namespace felt::towed_plan_test {

std::vector<Point> wave() {
  std::vector<Point> points;
  for (int i = 0; i <= 100; ++i) points.push_back({0.8 * i, 10.0 * std::sin(kTau * i / 50.0)});
  return points;
}

double error_with(const RecordedPath& pen, const RecordedPath& nib_plan, const TowOptions& rope) {
  Point nib = pen.front().position;
  double sum = 0.0;
  for (const RecordedPoint& point : pen) {
    nib = towed_nib(rope, nib, point.position, 0.001);
    double nearest = 1e9;
    for (const RecordedPoint& on : nib_plan)
      nearest = std::min(nearest, distance(on.position, nib));
    sum += nearest;
  }
  return sum / static_cast<double>(pen.size());
}

TEST(TowedPlan, APenThatIsAheadByTheRopeKeepsTheNibOnThePath) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const RecordedPath nib = plan_movement(person_of(seed), wave());
    const TowOptions rope{.rope_mm = 6.0};
    EXPECT_LT(error_with(ahead_by_rope(nib, rope), nib, rope), 0.15);
    EXPECT_GT(error_with(nib, nib, rope), 0.3) << "the pen itself on the path";
  }
}

TEST(TowedPlan, TimesIncreaseAndNothingBecomesOfNothing) {
  EXPECT_TRUE(ahead_by_rope({}, {}).empty());
  const RecordedPath pen = ahead_by_rope(plan_movement(person_of(1), wave()), {});
  for (std::size_t i = 1; i < pen.size(); ++i) ASSERT_GT(pen[i].time_ns, pen[i - 1].time_ns);
}

}  // namespace felt::towed_plan_test
