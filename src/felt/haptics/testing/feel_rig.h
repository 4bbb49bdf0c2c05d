#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "felt/haptics/capabilities.h"
#include "felt/haptics/force_model.h"
#include "felt/haptics/pen_sample.h"

/// Test helper: a bench that tests the forces of this layer in the same way as when they were
/// designed (docs/design/simulation.md#model). It simulates a point mass in 20 us steps, a hand
/// that pulls it towards a target, Coulomb friction of the device, a position sensor with steps of
/// 0.03 mm, and a force that is some ticks late and is held for one tick. The bench has no safety
/// chain, because a force law must be calm by itself.
///
/// It is small and intentionally independent of devices/simulated, because two independent
/// simulations that agree are stronger evidence.
namespace felt::rig {

/// Returns a sample of a pen at a position.
inline PenSample pen_at(const Vec3& position_mm, const Vec3& velocity_mm_per_s = {},
                        double time_s = 0.0) {
  PenSample sample;
  sample.time_ns = std::llround(1e9 * time_s);
  sample.position = position_mm;
  sample.velocity = velocity_mm_per_s;
  return sample;
}

struct Hand {
  const char* name;
  double mass_kg, stiffness_n_per_m, damping_n_s_per_m;
};
inline constexpr std::array<Hand, 4> kHands{{{"light", 0.000, 30, 0.3},
                                             {"soft", 0.020, 100, 1.0},
                                             {"typical", 0.030, 300, 3.0},
                                             {"firm", 0.050, 800, 8.0}}};

struct Stylus {
  const char* name;
  double mass_kg, friction_n;
};
inline constexpr std::array<Stylus, 3> kStyluses{
    {{"worst", 0.045, 0.0}, {"touch-like", 0.045, 0.26}, {"premium-like", 0.075, 0.04}}};

/// One combination of a hand, a device and a loop.
struct Setup {
  Hand hand = kHands[2];
  Stylus stylus = kStyluses[0];
  double period_s = 0.001;
  int delay_ticks = 1;
  double step_mm = 0.03;

  [[nodiscard]] std::string name() const {
    return std::string(hand.name) + " hand, " + stylus.name + ", T " +
           std::to_string(1e3 * period_s) + " ms, delay " + std::to_string(delay_ticks);
  }
  [[nodiscard]] Capabilities capabilities() const {
    return {.max_force_n = 8.0,
            .period_ns = static_cast<std::int64_t>(std::llround(1e9 * period_s)),
            .delay_ticks = delay_ticks};
  }
};

/// Calls `visit` with every combination of hand and stylus.
template <class Visit>
void for_each_grip(double period_s, int delay_ticks, const Visit& visit) {
  for (const Hand& hand : kHands) {
    for (const Stylus& stylus : kStyluses) visit(Setup{hand, stylus, period_s, delay_ticks});
  }
}

/// Measures the part of a force above 30 Hz with a Butterworth high-pass filter of the fourth
/// order. The result is the RMS since begin() of the axis on which it is largest (the bench of
/// docs/design/simulation.md#measures had only one or two axes). The force is held between ticks,
/// so one value per tick suffices.
class HighFrequency {
 public:
  explicit HighFrequency(double period_s) {
    // Uses the bilinear transform for both second-order sections, with the Q values of a
    // fourth-order filter.
    const double k = std::tan(3.14159265358979323846 * 30.0 * period_s);
    const std::array<double, 2> q{0.54119610, 1.3065630};
    for (std::size_t i = 0; i < 2; ++i) {
      const double norm = 1.0 / (1.0 + k / q[i] + k * k);
      sections_[i] = {norm, 2.0 * (k * k - 1.0) * norm, (1.0 - k / q[i] + k * k) * norm, {}, {}};
    }
  }
  void begin() {
    squares_ = {};
    count_ = 0;
  }
  void push(const Force& f) {
    const std::array<double, 3> in{f.x, f.y, f.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double x = in[axis];
      for (Section& s : sections_) {
        const double y = s.b0 * x + s.z1[axis];
        s.z1[axis] = -2.0 * s.b0 * x - s.a1 * y + s.z2[axis];
        s.z2[axis] = s.b0 * x - s.a2 * y;
        x = y;
      }
      squares_[axis] += x * x;
    }
    ++count_;
  }
  [[nodiscard]] double rms_n() const {
    const double largest = std::max({squares_[0], squares_[1], squares_[2]});
    return count_ > 0 ? std::sqrt(largest / static_cast<double>(count_)) : 0.0;
  }

 private:
  struct Section {
    double b0, a1, a2;
    std::array<double, 3> z1, z2;
  };
  std::array<Section, 2> sections_{};
  std::array<double, 3> squares_{};
  std::int64_t count_ = 0;
};

/// Results measured since `begin_measuring`.
struct Figures {
  double hf_n = 0.0;       ///< RMS above 30 Hz, of the worst axis
  double energy_mj = 0.0;  ///< work done on the hand; passive if <= 0
  Force mean_force;        ///< mean of the force that acted
  double mean_size_n = 0.0;
  double max_size_n = 0.0;
};

/// A held stylus under a force model.
class Bench {
 public:
  static constexpr double kStepS = 20e-6;

  Bench(const Setup& setup, const ForceModel& model, const Vec3& start_mm = {})
      : setup_(setup), model_(model), position_(start_mm), hf_(setup.period_s) {
    memory_.period_s = setup.period_s;
    late_.assign(static_cast<std::size_t>(setup.delay_ticks) + 1, Force{});
  }

  /// Runs the bench. The hand follows `target(t)`, t in s since the start. Calls each(bench) after
  /// each tick.
  template <class Target, class Each>
  void run(double seconds, const Target& target, const Each& each) {
    const auto steps_per_tick = std::llround(setup_.period_s / kStepS);
    const auto ticks = std::llround(seconds / setup_.period_s);
    for (std::int64_t i = 0; i < ticks; ++i) {
      tick();
      Vec3 aim = target(time_s_);
      for (std::int64_t s = 0; s < steps_per_tick; ++s) {
        time_s_ += kStepS;
        const Vec3 next = target(time_s_);
        move(next, (1.0 / kStepS) * (next - aim));
        aim = next;
      }
      each(*this);
    }
  }
  template <class Target>
  void run(double seconds, const Target& target) {
    run(seconds, target, [](const Bench&) {});
  }

  void begin_measuring() {
    hf_.begin();
    energy_mj_ = sum_size_ = max_size_ = 0.0;
    sum_ = {};
    ticks_ = 0;
  }
  [[nodiscard]] Figures figures() const {
    const double share = ticks_ > 0 ? 1.0 / static_cast<double>(ticks_) : 0.0;
    return {hf_.rms_n(), energy_mj_, share * sum_, share * sum_size_, max_size_};
  }

  void set_model(const ForceModel& model) { model_ = model; }
  [[nodiscard]] ForceMemory& memory() { return memory_; }
  [[nodiscard]] const ForceMemory& memory() const { return memory_; }
  [[nodiscard]] const Vec3& position() const { return position_; }
  [[nodiscard]] const Vec3& velocity() const { return velocity_; }
  [[nodiscard]] const Force& force() const { return acting_; }
  [[nodiscard]] const PenSample& sample() const { return sample_; }
  [[nodiscard]] double time_s() const { return time_s_; }

 private:
  [[nodiscard]] double stepped(double mm) const {
    return setup_.step_mm > 0.0 ? setup_.step_mm * std::round(mm / setup_.step_mm) : mm;
  }
  void tick() {
    sample_.time_ns = std::llround(1e9 * time_s_);
    sample_.position = {stepped(position_.x), stepped(position_.y), stepped(position_.z)};
    sample_.velocity = filter_.update(sample_.position, setup_.period_s);
    memory_.begin_tick(setup_.period_s);
    late_[static_cast<std::size_t>(tick_count_) % late_.size()] = model_(sample_, memory_);
    ++tick_count_;
    acting_ = late_[static_cast<std::size_t>(tick_count_) % late_.size()];
    hf_.push(acting_);
    const double size = norm(acting_);
    sum_ += acting_;
    sum_size_ += size;
    max_size_ = std::max(max_size_, size);
    ++ticks_;
  }
  void move(const Vec3& aim_mm, const Vec3& aim_velocity) {
    // Units: N/m mm = mN = kg mm/s^2.
    const double mass = setup_.hand.mass_kg + setup_.stylus.mass_kg;
    const Vec3 push = setup_.hand.stiffness_n_per_m * (aim_mm - position_) +
                      setup_.hand.damping_n_s_per_m * (aim_velocity - velocity_) +
                      1e3 * Vec3{acting_.x, acting_.y, acting_.z};
    Vec3 v = velocity_ + (kStepS / mass) * push;
    // Maximum speed that Coulomb friction removes in a step. It never reverses the motion.
    const double largest = kStepS * 1e3 * setup_.stylus.friction_n / mass;
    const double speed = norm(v);
    v = speed > largest ? ((speed - largest) / speed) * v : Vec3{};
    const Vec3 way = kStepS * v;
    energy_mj_ += work_mj(acting_, way);
    position_ += way;
    velocity_ = v;
  }

  Setup setup_;
  ForceModel model_;
  ForceMemory memory_;
  VelocityFilter filter_;
  PenSample sample_;
  Vec3 position_, velocity_;
  Force acting_;
  std::vector<Force> late_;  // ring of the forces of the last ticks
  HighFrequency hf_;
  std::int64_t tick_count_ = 0;
  std::int64_t ticks_ = 0;
  double time_s_ = 0.0;
  double energy_mj_ = 0.0;
  double sum_size_ = 0.0;
  double max_size_ = 0.0;
  Force sum_;
};

/// Returns the z, in mm, at which a hand must aim to press with `push_n` on a plane of stiffness
/// `plane_n_per_m`.
inline double aim_z_mm(const Hand& hand, double push_n, double plane_n_per_m) {
  return -1e3 * push_n * (1.0 / hand.stiffness_n_per_m + 1.0 / plane_n_per_m);
}

}  // namespace felt::rig
