#include "felt/devices/hapticmaster/motion_check.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "felt/base/constants.h"
#include "felt/base/random.h"
#include "felt/devices/hapticmaster/machine_watch.h"

namespace felt::hapticmaster::motion_check_test {
namespace {

constexpr std::int64_t kPeriodNs = 4 * kMs;
constexpr std::int64_t kFineNs = kMs / 4;
// The hands below do not get farther than this from the middle.
constexpr Box kReach{{-800, -800, -800}, {800, 800, 800}};

// A hand that rests, draws slowly or fast, or scribbles, and trembles all the time (8 to 12 Hz).
class Hand {
 public:
  explicit Hand(Random& random) : random_(random) { choose(); }

  void move() {
    at_s_ += 1e-9 * static_cast<double>(kFineNs);
    if (at_s_ > until_s_) choose();
    const double share = 1e-9 * static_cast<double>(kFineNs) / lag_s_;
    velocity_ += share * (aim_ - velocity_);
    position_ += 1e-9 * static_cast<double>(kFineNs) * velocity_;
    newest_ = (newest_ + 1) % kPast;
    const double phase = kTau * tremor_hz_ * at_s_;
    const Vec3 along{1, 0.6, -0.4};
    past_[newest_] = {position_ + tremor_mm_ * std::sin(phase) * along,
                      velocity_ + kTau * tremor_hz_ * tremor_mm_ * std::cos(phase) * along};
  }
  struct Motion {
    Vec3 position_mm, mm_per_s;
  };
  /// Returns the motion `steps` fine steps ago.
  [[nodiscard]] const Motion& ago(std::size_t steps) const {
    return past_[(newest_ + kPast - steps) % kPast];
  }

 private:
  static constexpr std::size_t kPast = 64;

  void choose() {
    const double kind = random_.between(0, 1);
    const double speed = kind < 0.4   ? 0.0
                         : kind < 0.7 ? random_.between(3, 60)
                                      : random_.between(60, 1200);
    until_s_ = at_s_ + random_.between(0.05, kind < 0.4 ? 2.0 : 0.5);
    Vec3 way{random_.normal(), random_.normal(), random_.normal()};
    if (norm(position_) > 150.0) way = -1.0 * position_;
    aim_ = speed / std::max(1e-6, norm(way)) * way;
    lag_s_ = random_.between(0.015, 0.1);
  }

  Random& random_;
  double at_s_ = 0.0, until_s_ = 0.0, lag_s_ = 0.1;
  double tremor_hz_ = random_.between(8, 12), tremor_mm_ = random_.between(0, 0.2);
  Vec3 position_, velocity_, aim_;
  std::array<Motion, kPast> past_{};
  std::size_t newest_ = 0;
};

double rounded(double v, double step) {
  return step * std::round(v / step);
}

// A controller whose positions have noise and steps, and lag behind the velocities, which have
// noise and an offset.
struct Controller {
  explicit Controller(Random& random)
      : step_mm(random.between(0.002, 0.05)),
        noise_mm(random.between(0, 0.03)),
        noise_mm_per_s(random.between(0, 4)),
        offset{random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)},
        lag_steps(random.bits() % 40) {}

  [[nodiscard]] MotionReport report(const Hand& hand, Random& random, std::int64_t asked_ns) const {
    // Both were measured within the round trip, not at the same time.
    const std::size_t ahead = random.bits() % 5;
    const Vec3 at = hand.ago(lag_steps + ahead).position_mm;
    const auto shown = [&](double v) { return rounded(v + noise_mm * random.normal(), step_mm); };
    const auto speed = [&](double v) { return v + noise_mm_per_s * random.normal(); };
    const Vec3 v = hand.ago(random.bits() % 5).mm_per_s + offset;
    return {Vec3{shown(at.x), shown(at.y), shown(at.z)}, Vec3{speed(v.x), speed(v.y), speed(v.z)},
            asked_ns};
  }

  double step_mm, noise_mm, noise_mm_per_s;
  Vec3 offset;
  std::size_t lag_steps;
};

Signs signs_of(MotionVerdict verdict) {
  const auto sign = [](bool is) { return is ? Sign::kPresent : Sign::kAbsent; };
  Signs signs{};
  signs[static_cast<std::size_t>(Condition::kImpossiblePosition)] =
      sign(verdict == MotionVerdict::kImpossible);
  signs[static_cast<std::size_t>(Condition::kInconsistentPosition)] =
      sign(verdict == MotionVerdict::kInconsistent);
  return signs;
}

std::int64_t next_step(Random& random) {
  const double kind = random.between(0, 1);
  if (kind < 0.01) return static_cast<std::int64_t>(random.between(4, 45) * 1e6);
  return kPeriodNs + static_cast<std::int64_t>(random.between(-0.4, 0.4) * 1e6);
}

// 100 hands of 3,000 ticks each.
RC_GTEST_PROP(MotionCheck, R49_NoHandIsAFaultNorDoesItReachALimit, (std::uint64_t seed)) {
  Random random(seed);
  Hand hand(random);
  const Controller controller(random);
  MotionCheck check(kReach);
  MachineWatch watch;
  std::int64_t now_ns = 0, moved_ns = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::int64_t ns = next_step(random);
    now_ns += ns;
    for (; moved_ns < now_ns; moved_ns += kFineNs) hand.move();
    const MotionVerdict verdict = check.judge(controller.report(hand, random, now_ns));
    RC_ASSERT(verdict != MotionVerdict::kImpossible);
    RC_ASSERT(watch.tick(ns, signs_of(verdict)) == nullptr);
  }
}

/// A handle that moves steadily, or around a circle.
struct Path {
  Vec3 along, across;
  double mm_per_s = 0.0, radius_mm = 0.0;  // radius 0: straight

  [[nodiscard]] MotionReport at(std::int64_t now_ns, Random& random) const {
    const double t = 1e-9 * static_cast<double>(now_ns);
    const double angle = radius_mm > 0.0 ? mm_per_s / radius_mm * t : 0.0;
    const Vec3 way = radius_mm > 0.0
                         ? radius_mm * (std::sin(angle) * along - std::cos(angle) * across)
                         : mm_per_s * t * along;
    const Vec3 noise{random.normal(), random.normal(), random.normal()};
    return {way, mm_per_s * (std::cos(angle) * along + std::sin(angle) * across) + 2.0 * noise,
            now_ns};
  }
};

enum class Broken { kPosition, kVelocity };

MotionReport broken_report(MotionReport report, const MotionReport& last, Broken broken) {
  if (broken == Broken::kPosition) report.position_mm = last.position_mm;
  if (broken == Broken::kVelocity) report.velocity_mm_per_s = Vec3{};
  return report;
}

// Returns the time from the fault to the limit, or a long time.
std::int64_t noticed_after_ns(const Path& path, Broken broken, Random& random) {
  MotionCheck check(kReach);
  MachineWatch watch;
  MotionReport last;
  std::int64_t now_ns = 0;
  for (; now_ns < 200 * kMs; now_ns += kPeriodNs) {
    last = path.at(now_ns, random);
    if (watch.tick(kPeriodNs, signs_of(check.judge(last))) != nullptr) return -1;
  }
  const std::int64_t since_ns = now_ns;
  for (; now_ns < 10 * kSecond; now_ns += kPeriodNs) {
    const MotionReport report = broken_report(path.at(now_ns, random), last, broken);
    const Signs signs = signs_of(check.judge(report));
    const Limit* const limit = watch.tick(kPeriodNs, signs);
    if (limit != nullptr) return now_ns - since_ns;
  }
  return 10 * kSecond;
}

Path any_path(Random& random) {
  Vec3 along{random.normal(), random.normal(), random.normal()};
  along = 1.0 / norm(along) * along;
  const Vec3 other = std::abs(along.x) < 0.8 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 across = other - dot(other, along) * along;
  return {along, 1.0 / norm(across) * across, random.between(20, 300), 0.0};
}

RC_GTEST_PROP(MotionCheck, R49_APositionThatFreezesWhileTheHandMovesIsNoticed,
              (std::uint64_t seed)) {
  Random random(seed);
  const Path path = any_path(random);
  const std::int64_t after_ns = noticed_after_ns(path, Broken::kPosition, random);
  RC_ASSERT(after_ns > 0);
  RC_ASSERT(after_ns < 400 * kMs);  // 20 mm/s: 5.4 mm after 0.31 s
  if (path.mm_per_s > 100.0) RC_ASSERT(after_ns < 110 * kMs);
}

RC_GTEST_PROP(MotionCheck, R49_APositionThatMovesWithoutAVelocityIsNoticed, (std::uint64_t seed)) {
  Random random(seed);
  const std::int64_t after_ns = noticed_after_ns(any_path(random), Broken::kVelocity, random);
  RC_ASSERT(after_ns > 0);
  RC_ASSERT(after_ns < 400 * kMs);
}

// The position comes back again and again, so its error stays small.
RC_GTEST_PROP(MotionCheck, R49_APositionThatFreezesWhileTheHandMovesToAndFroIsNoticed,
              (std::uint64_t seed)) {
  Random random(seed);
  Path path = any_path(random);
  path.radius_mm = random.between(1.0, 3.0);
  path.mm_per_s = random.between(40, 100);
  const std::int64_t after_ns = noticed_after_ns(path, Broken::kPosition, random);
  RC_ASSERT(after_ns > 0);
  RC_ASSERT(after_ns < kSecond);
}

TEST(MotionCheck, R49_WhatIsNotAPositionIsImpossible) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  MotionCheck check(kReach);
  EXPECT_EQ(check.judge({std::nullopt, Vec3{}, 0}), MotionVerdict::kImpossible);
  EXPECT_EQ(check.judge({Vec3{}, std::nullopt, 0}), MotionVerdict::kImpossible);
  EXPECT_EQ(check.judge({Vec3{nan, 0, 0}, Vec3{}, 0}), MotionVerdict::kImpossible);
  EXPECT_EQ(check.judge({Vec3{}, Vec3{0, nan, 0}, 0}), MotionVerdict::kImpossible);
  EXPECT_EQ(check.judge({Vec3{0, 0, kReach.max_mm.z + 51.0}, Vec3{}, 0}),
            MotionVerdict::kImpossible);
  EXPECT_EQ(check.judge({Vec3{}, Vec3{2e5, 0, 0}, 0}), MotionVerdict::kImpossible);
  EXPECT_EQ(check.judge({Vec3{}, Vec3{}, 0}), MotionVerdict::kGood);
}

TEST(MotionCheck, AJumpIsImpossibleAndAPauseBeginsAnew) {
  MotionCheck check(kReach);
  std::int64_t now_ns = 0;
  const auto judge = [&](double x_mm, std::int64_t ns) {
    now_ns += ns;
    return check.judge({Vec3{x_mm, 0, 0}, Vec3{}, now_ns});
  };
  for (int i = 0; i < 10; ++i) EXPECT_EQ(judge(0, kPeriodNs), MotionVerdict::kGood);
  EXPECT_EQ(judge(20, kPeriodNs), MotionVerdict::kImpossible);
  EXPECT_EQ(judge(0, kPeriodNs), MotionVerdict::kGood);
  EXPECT_EQ(judge(200, 80 * kMs), MotionVerdict::kGood) << "the loop stood still";
  EXPECT_EQ(judge(200, -1000 * kMs), MotionVerdict::kGood) << "the clock was set";
}

// A jump that is small enough to be believed is still not explained by the velocity.
TEST(MotionCheck, R49_AShiftOfTheOriginIsNoticed) {
  MotionCheck check(kReach);
  for (int i = 0; i < 20; ++i) static_cast<void>(check.judge({Vec3{}, Vec3{}, i * kPeriodNs}));
  EXPECT_EQ(check.judge({Vec3{5.9, 0, 0}, Vec3{}, 20 * kPeriodNs}), MotionVerdict::kInconsistent);
}

}  // namespace
}  // namespace felt::hapticmaster::motion_check_test
