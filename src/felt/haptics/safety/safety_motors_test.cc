#include "felt/haptics/safety/safety_guards.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>

namespace felt::safety_motors_test {
namespace {

SafetyLimits touch() {
  SafetyLimits limits;
  limits.peak_force_n = 2.5;
  limits.continuous_force_n = 0.8 * 0.88;
  return limits;
}

/// Runs the guard with a requested force. Returns the largest plain RMS over any 10 s.
template <class Wish, class Each>
double worst_rms(MotorGuard& guard, double seconds, const Wish& wish, const Each& each) {
  std::deque<double> window;
  double sum = 0.0;
  double worst = 0.0;
  for (int i = 0; i < seconds * 1000; ++i) {
    const double t = 0.001 * i;
    const double sent = std::min(wish(t), guard.allowed_n());
    each(t, sent);
    guard.heat(sent, 0.001);
    window.push_back(sent * sent);
    sum += window.back();
    if (window.size() > 10000) {
      sum -= window.front();
      window.pop_front();
    }
    worst = std::max(worst, std::sqrt(std::max(sum, 0.0) / 10000.0));
  }
  return worst;
}

TEST(MotorGuard, R49_RmsOverAny10SecondsIsUnder80PercentOfTheRating) {
  const auto ignore = [](double, double) {};
  for (double on_s : {0.05, 0.5, 2.0, 1e9}) {
    for (double off_s : {0.0, 0.1, 1.0, 6.0}) {
      for (double n : {0.7, 1.0, 2.5}) {
        MotorGuard guard(touch());
        const auto wish = [&](double t) { return std::fmod(t, on_s + off_s) < on_s ? n : 0.0; };
        EXPECT_LE(worst_rms(guard, 40.0, wish, ignore), 0.8 * 0.88 * (1.0 + 1e-9))
            << on_s << " s on, " << off_s << " s off, " << n << " N";
      }
    }
  }
}

TEST(MotorGuard, ALongPressSoftensOnceWithinASecondAndStays) {
  MotorGuard guard(touch());
  double begins = -1.0;
  double ends = -1.0;
  double last = 1.0;
  const double sustained = 0.8 * 0.88 * std::sqrt(10.0 / 15.0);
  worst_rms(
      guard, 60.0, [](double) { return 1.0; },
      [&](double t, double sent) {
        EXPECT_LE(last - sent, 0.004) << "no step at " << t;
        EXPECT_LE(sent, last + 1e-12) << "no swing at " << t;
        if (sent < 1.0 && begins < 0.0) begins = t;
        if (sent < 1.02 * sustained && ends < 0.0) ends = t;
        last = sent;
      });
  EXPECT_GT(begins, 1.0) << "a stroke of a second is not touched";
  EXPECT_LT(ends - begins, 1.5);
  EXPECT_NEAR(last, sustained, 0.01);
}

TEST(MotorGuard, TheNoticeHasHysteresisAndNoRatingMeansNoBound) {
  MotorGuard guard(touch());
  EXPECT_FALSE(guard.is_warm(false));
  guard.heat(2.0, 0.4);
  EXPECT_TRUE(guard.is_warm(true));
  EXPECT_TRUE(guard.is_warm(false)) << "still warm";
  guard.heat(0.0, 10.0);
  EXPECT_FALSE(guard.is_warm(false));
  MotorGuard none(SafetyLimits{});
  none.heat(3.0, 1000.0);
  EXPECT_TRUE(std::isinf(none.allowed_n()));
  EXPECT_NEAR(none.rms_n(), 3.0, 0.1);
}

}  // namespace
}  // namespace felt::safety_motors_test
