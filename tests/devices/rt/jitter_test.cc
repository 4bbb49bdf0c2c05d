// Replays measured scheduler jitter on the virtual clock while a simulated hand is in contact
// (R49; docs/design/loop.md#what-is-proven). The force stays limited and returns without a kick.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "felt/base/constants.h"
#include "felt/haptics/bricks/plane.h"
#include "felt/rt/servo.h"
#include "felt/rt/virtual_clock.h"
#include "tests/devices/rt/recorded_lateness.h"

namespace felt::rt_test::jitter_test {
namespace {

constexpr double kRiseNPerMs = 0.3;
constexpr double kTiny = 1e-9;

// A stylus of 45 g, held by a hand of 100 g, 300 N/m and 3 N s/m. It moves in z only. The last
// force acts until the next one is written, because a stalled loop does that to a real hand.
class HeldPen final : public Device {
 public:
  HeldPen() {
    capabilities_.max_force_n = 3.3;
    capabilities_.continuous_force_n = 3.3;
    capabilities_.max_stiffness_n_per_m = 1000.0;
    capabilities_.max_damping_n_s_per_m = 5.0;
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "held pen"; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override { return capabilities_; }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override {
    constexpr std::int64_t kStep = 50'000;
    while (time_ns_ + kStep <= now_ns) {
      time_ns_ += kStep;
      const double wanted_mm = target_mm(1e-9 * static_cast<double>(time_ns_));
      const double hand_n = 0.001 * (300.0 * (wanted_mm - z_mm_) - 3.0 * vz_mm_per_s_);
      vz_mm_per_s_ += 1e3 * (hand_n + force_.z) / 0.145 * (1e-9 * kStep);
      z_mm_ += vz_mm_per_s_ * (1e-9 * kStep);
      fastest_mm_per_s = std::max(fastest_mm_per_s, std::abs(vz_mm_per_s_));
    }
    return PenSample{now_ns, {0.0, 0.0, z_mm_}, {0.0, 0.0, vz_mm_per_s_}, {}, 0};
  }
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override {
    force_ = force;
    return {};
  }
  void stop() noexcept override { force_ = {}; }

  /// Returns the height that the hand aims for, in mm: `resting_mm` if set, otherwise tapping.
  [[nodiscard]] double target_mm(double t_s) const noexcept {
    return resting_mm.value_or(2.0 - 3.5 * (1.0 - std::cos(6.28318 * taps_hz * t_s)));
  }

  double taps_hz = 1.0;
  std::optional<double> resting_mm;
  double fastest_mm_per_s = 0.0;

 private:
  Capabilities capabilities_;
  Force force_;
  std::int64_t time_ns_ = 0;
  double z_mm_ = 2.0;
  double vz_mm_per_s_ = 0.0;
};

// A loop with a plane of 500 N/m, and a user who re-arms it 50 ms after it has latched.
class ContactLoop {
 public:
  ContactLoop(double rate_hz, const std::vector<std::int64_t>& lateness) {
    ServoOptions options;
    options.period_ns = static_cast<std::int64_t>(1e9 / rate_hz);
    options.limits = limits_for(pen.capabilities());
    servo = std::make_unique<Servo>(pen, options);
    clock.emplace(*servo, lateness);
    servo->publish(ForceModel(Plane()));
    servo->arm();
  }

  // Runs the loop until `until_ns` and checks each tick.
  void run(std::int64_t until_ns) {
    while (clock->next_ns() <= until_ns) {
      const std::int64_t last_ns = std::max<std::int64_t>(clock->now_ns(), 0);
      if (changes_stiffness && ++ticks_ % 97 == 0) {
        // The fade id is unchanged, so that the model is replaced without a cross-fade and only the
        // limit of the rise protects the hand.
        servo->publish(ForceModel(Plane({.stiffness_n_per_m = ticks_ % 2 == 0 ? 500.0 : 100.0})));
      }
      const TickReport& report = clock->tick();
      check(report, 1e-6 * static_cast<double>(clock->now_ns() - last_ns));
      if (report.safety.state == SafetyState::kLatched) {
        if (latched_at_ns_ < 0) latched_at_ns_ = clock->now_ns();
        if (clock->now_ns() - latched_at_ns_ > 50 * kMs) servo->arm();
      } else {
        latched_at_ns_ = -1;
      }
      if (::testing::Test::HasFailure()) return;
    }
  }

  HeldPen pen;
  std::unique_ptr<Servo> servo;
  std::optional<VirtualClock> clock;
  bool changes_stiffness = false;
  int touching_ticks = 0;  ///< with a force on the hand
  int limited_ticks = 0;   ///< in which the rise of the force was limited
  std::uint32_t faults = 0;

 private:
  void check(const TickReport& report, double elapsed_ms) {
    const double force_n = norm(report.sent);
    const double peak_n = servo->options().limits.peak_force_n;
    ASSERT_TRUE(is_finite(report.sent));
    ASSERT_LE(force_n, peak_n + kTiny);
    ASSERT_LE(force_n, last_n_ + kRiseNPerMs * std::min(elapsed_ms, 5.0) + kTiny)
        << "a kick after " << elapsed_ms << " ms";
    ASSERT_GE(report.sent.z, -2.0) << "pulled in by more than the brake may";
    if (elapsed_ms > 21.0 + 1e-6 * static_cast<double>(servo->options().period_ns)) {
      ASSERT_EQ(force_n, 0.0) << "not silent after a stall of " << elapsed_ms << " ms";
    }
    limited_ticks += (report.safety.limited_by & kLimitedByRise) != 0 ? 1 : 0;
    touching_ticks += force_n > 0.0 ? 1 : 0;
    faults = report.safety.soft_faults + report.safety.hard_faults;
    last_n_ = force_n;
  }

  int ticks_ = 0;
  double last_n_ = 0.0;
  std::int64_t latched_at_ns_ = -1;
};

// Moves the pen from the air into contact. The force must return and be steady.
void expect_recovery(ContactLoop& loop) {
  const std::int64_t now_ns = loop.clock->now_ns();
  loop.pen.resting_mm = 3.0;
  loop.run(now_ns + 1500 * kMs);
  loop.pen.resting_mm = -3.0;
  loop.run(now_ns + 4000 * kMs);
  if (::testing::Test::HasFailure()) return;
  // The springs of hand and plane act in series over 3 mm. R56 limits the plane's stiffness if the
  // loop is slow: 900 N/m up to 2 ms of delay, 225 N/m for the 8 ms of delay at 250 Hz.
  const double plane = loop.servo->options().period_ns > 2 * kMs ? 225.0 : 500.0;
  EXPECT_NEAR(loop.servo->latest().sent.z, 0.003 * 300.0 * plane / (300.0 + plane), 0.01);
  EXPECT_EQ(loop.servo->latest().safety.state, SafetyState::kActive);
}

TEST(Jitter, GeneratorsReproduceTheRecordedPercentiles) {
  for (const RecordedLateness& row : recorded_lateness()) {
    for (const std::size_t burst : {std::size_t{1}, std::size_t{10}}) {
      auto drawn = draw_lateness(row, 20'000, 7, burst);
      std::sort(drawn.begin(), drawn.end());
      const auto at_us = [&](double q) {
        return 1e-3 * static_cast<double>(drawn[static_cast<std::size_t>(q * 20'000.0) - 1]);
      };
      SCOPED_TRACE(std::string(row.name) + ", bursts of " + std::to_string(burst));
      EXPECT_NEAR(at_us(0.5), row.p50_us, 0.02 * row.p50_us + 0.6);
      EXPECT_NEAR(at_us(0.99), row.p99_us, 0.08 * row.p99_us);
      EXPECT_NEAR(at_us(0.999), row.p999_us, 0.08 * row.p999_us);
      EXPECT_NEAR(at_us(1.0), row.max_us, 0.001);
    }
  }
}

TEST(Jitter, SameSeedSameLateness) {
  const RecordedLateness& row = recorded_lateness()[0];
  EXPECT_EQ(draw_lateness(row, 1000, 3, 4), draw_lateness(row, 1000, 3, 4));
  EXPECT_NE(draw_lateness(row, 1000, 3, 4), draw_lateness(row, 1000, 4, 4));
}

TEST(Jitter, R49_RecordedSchedulersNeitherExceedLimitsNorKick) {
  int touching_ticks = 0;
  int limited_ticks = 0;
  for (const RecordedLateness& row : recorded_lateness()) {
    for (const std::size_t burst : {std::size_t{1}, std::size_t{10}}) {
      for (const std::uint64_t seed : {1U, 2U}) {
        SCOPED_TRACE(std::string(row.name) + ", bursts of " + std::to_string(burst) + ", seed " +
                     std::to_string(seed));
        const auto lateness = draw_lateness(row, 10'000, seed, burst);
        ContactLoop loop(row.rate_hz, lateness);
        loop.pen.taps_hz = seed == 1 ? 1.0 : 6.0;
        loop.changes_stiffness = true;
        loop.run(6000 * kMs);
        ASSERT_FALSE(HasFailure());
        EXPECT_LT(loop.pen.fastest_mm_per_s, 600.0) << "the hand was thrown";
        touching_ticks += loop.touching_ticks;
        limited_ticks += loop.limited_ticks;
      }
    }
  }
  EXPECT_GT(touching_ticks, 100'000);  // forces were in fact sent
  EXPECT_GT(limited_ticks, 100);
}

TEST(Jitter, R49_AStallOf29MsSilencesTheForceAndItComesBackSlowly) {
  for (const double rate_hz : {250.0, 1000.0, 4000.0, 5000.0}) {
    const auto period_ns = static_cast<std::int64_t>(1e9 / rate_hz);
    for (const std::int64_t stall_at_ms : {900, 1100, 1250, 1333, 1500, 1700}) {
      SCOPED_TRACE(std::to_string(rate_hz) + " Hz, at " + std::to_string(stall_at_ms) + " ms");
      std::vector<std::int64_t> lateness(static_cast<std::size_t>(10 * rate_hz), 0);
      lateness[static_cast<std::size_t>(stall_at_ms * kMs / period_ns)] = 29 * kMs;
      ContactLoop loop(rate_hz, lateness);
      loop.run(2000 * kMs);
      EXPECT_GT(loop.touching_ticks, 0);
      expect_recovery(loop);
      ASSERT_FALSE(HasFailure());
    }
  }
}

TEST(Jitter, R49_BurstsOfStallsLatchAndTheUserGetsTheForceBack) {
  for (const std::int64_t stall_ms : {4, 6, 12, 25, 29, 500}) {
    SCOPED_TRACE(std::to_string(stall_ms) + " ms");
    std::vector<std::int64_t> lateness(20'000, 0);
    for (int i = 0; i < 12; ++i) {  // three bursts of four
      lateness[static_cast<std::size_t>(1100 + 900 * (i / 4) + 13 * (i % 4))] = stall_ms * kMs;
    }
    ContactLoop loop(1000.0, lateness);
    loop.run((4500 + 12 * stall_ms) * kMs);
    EXPECT_EQ(loop.faults > 0, stall_ms > 5);
    expect_recovery(loop);
    ASSERT_FALSE(HasFailure());
  }
}

}  // namespace
}  // namespace felt::rt_test::jitter_test
