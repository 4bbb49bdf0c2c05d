#include "felt/tools/pull/edit_weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace felt::edit_weights_test {
namespace {

/// Returns the parameters that R21 names, and some in between.
std::vector<double> places() {
  std::vector<double> t{0.0, 1e-9, 1.0 - 1e-9};
  for (int i = 1; i <= 100; ++i) t.push_back(0.01 * i);
  return t;
}

/// Every combination of joints that are pinned and joints that may move.
struct Pins {
  bool left, right;
  [[nodiscard]] Compliance at(double t) const {
    return {.left_joint = left ? pinned_compliance(t) : 1.0,
            .right_joint = right ? pinned_compliance(1.0 - t) : 1.0};
  }
};
constexpr Pins kPins[] = {{false, false}, {true, false}, {false, true}, {true, true}};

void expect_continuous(const std::function<EditWeights(double)>& weights) {
  constexpr double kStep = 1e-5;
  double step = 0.0, largest = 0.0;
  EditWeights last = weights(0.0);
  for (int i = 1; i <= 100'000; ++i) {
    const EditWeights now = weights(std::min(1.0, i * kStep));
    for (std::size_t k = 0; k < 4; ++k) {
      step = std::max(step, std::fabs(now.w[k] - last.w[k]));
      largest = std::max(largest, std::fabs(now.w[k]));
    }
    last = now;
  }
  EXPECT_LE(step, 2e-4);
  EXPECT_LE(largest, 2.2);
}

TEST(EditWeights, R21_ThePointGoesAllTheWay) {
  for (const double t : places()) {
    EXPECT_NEAR(soft_weights(t).gain(t), 1.0, 1e-14) << t;
    EXPECT_NEAR(paper_weights(t).gain(t), 1.0, 1e-14) << t;
    for (const Pins& pins : kPins) {
      EXPECT_NEAR(soft_weights(t, pins.at(t)).gain(t), 1.0, 1e-14) << t;
    }
  }
}

TEST(EditWeights, R22_WeightsAreContinuousAndBounded) {
  expect_continuous([](double t) { return soft_weights(t); });
  expect_continuous([](double t) { return paper_weights(t); });
  for (const Pins& pins : kPins) {
    expect_continuous([&](double t) { return soft_weights(t, pins.at(t)); });
  }
}

TEST(EditWeights, SoftIsAsSpecified) {
  const EditWeights middle = soft_weights(0.5);
  EXPECT_NEAR(middle.w[0], 0.64, 1e-12);
  EXPECT_NEAR(middle.w[1], 1.12, 1e-12);
  EXPECT_NEAR(middle.w[2], 1.12, 1e-12);
  EXPECT_NEAR(middle.w[3], 0.64, 1e-12);
  double largest = 0.0, overshoot = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const EditWeights w = soft_weights(0.001 * i);
    for (const double x : w.w) largest = std::max(largest, x);
    for (int k = 0; k <= 1000; ++k) overshoot = std::max(overshoot, w.gain(0.001 * k));
  }
  EXPECT_NEAR(largest, 1.375, 0.001);
  EXPECT_NEAR(overshoot, 1.026, 0.001);
}

TEST(EditWeights, R25_CasesOfThePaper) {
  const auto expect = [](const EditWeights& got, const std::array<double, 4>& want) {
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(got.w[k], want[k], 1e-13);
  };
  expect(paper_weights(0.0), {1, 1, 0, 0});
  expect(paper_weights(1.0), {0, 0, 1, 1});
  for (const double t : {0.25, 0.3, 0.5, 0.62, 0.75}) {
    const double c = 1.0 / (3.0 * t * (1.0 - t));
    expect(paper_weights(t), {0, c, c, 0});
  }
  // At the joints, soft weights are the same as the paper's cases.
  expect(soft_weights(0.0), {1, 1, 0, 0});
  expect(soft_weights(1.0), {0, 0, 1, 1});
}

TEST(EditWeights, Eq7AsPrintedFallsShort) {
  // docs/design/errata.md#e1: B4 by t, not t^3. docs/design/errata.md#e2: the point moves 0.3417 of
  // the displacement at t = .39, all of it at the ends.
  const EditWeights w = printed_weights(0.5);
  EXPECT_EQ(w.w, (std::array<double, 4>{0.125, 0.375, 0.375, 0.5}));
  double smallest = 1.0, where = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double t = 0.01 * i, gain = printed_weights(t).gain(t);
    if (gain < smallest) where = t;
    smallest = std::min(smallest, gain);
  }
  EXPECT_NEAR(smallest, 0.3417, 1e-3);
  EXPECT_NEAR(where, 0.39, 0.011);
  EXPECT_EQ(printed_weights(0.0).gain(0.0), 1.0);
  EXPECT_EQ(printed_weights(1.0).gain(1.0), 1.0);
}

TEST(EditWeights, APinnedJointStaysUnlessItIsNear) {
  for (const double t : {0.25, 0.5, 0.9}) {
    const EditWeights w = soft_weights(t, {.left_joint = pinned_compliance(t)});
    EXPECT_EQ(w.w[0], 0.0);
    EXPECT_GT(w.w[1], soft_weights(t).w[1] - soft_weights(t).w[0]);
  }
  EXPECT_EQ(soft_weights(0.0, {.left_joint = pinned_compliance(0.0)}).w[0], 1.0);
  // If no part may move, all weights are zero.
  EXPECT_EQ(soft_weights(0.5, {0, 0, 0, 0}).w, (std::array<double, 4>{}));
}

}  // namespace
}  // namespace felt::edit_weights_test
