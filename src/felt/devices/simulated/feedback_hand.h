#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "felt/base/random.h"
#include "felt/devices/simulated/person.h"
#include "felt/devices/simulated/simulated_stylus.h"
#include "felt/devices/simulated/tones.h"

namespace felt {

/// A simulated person who holds a simulated stylus, sees and feels what the pen does, and corrects
/// it (docs/design/simulation.md#people). It takes the place of a SimulatedStylus: its aims are the
/// movement that the person plans, for example that of plan_movement().
///
/// The pen carries out each aim `Person::preview_s` later, because the person plans ahead: at any
/// time the person knows the movement up to the newest aim. Forces displace the pen and the arm
/// from the plan. Muscles act against this in three ways: at once by stiffness, then by a reflex,
/// and last by correcting the error that the person sees across the path.
///
/// Depth and pressure are those of the plan, with slow noise if the person has any: of the height
/// in the air, of the force while the pen feels a surface. Buttons and tilt are those of the plan;
/// forces along z act on the grip alone. Call everything from one thread. Allocates only when it is
/// made. Deterministic: the same person and the same calls give the same bytes, up to the digits of
/// the machine's libm.
class FeedbackHand final : public Device, public HandInput {
 public:
  FeedbackHand(const StylusPreset& preset, const Person& person);

  // Device
  [[nodiscard]] std::string_view name() const noexcept override { return stylus_.name(); }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return stylus_.capabilities();
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override { stylus_.stop(); }

  // HandInput
  using HandInput::aim;
  void aim(const Aim& aim) noexcept override;

  /// Sets the error that the person sees from the next read() on: how far the ink is from where it
  /// should be, mm; nullopt: how far the pen is from the nearest position of the plan, across the
  /// path. An error that is not finite is ignored. For ink that is not at the pen, such as that of
  /// a towed nib.
  void see(std::optional<Vec> error_mm) noexcept;

  [[nodiscard]] const Person& person() const noexcept { return person_; }
  /// Returns the stylus in the hand, for tests and measurements.
  [[nodiscard]] const SimulatedStylus& stylus() const noexcept { return stylus_; }

 private:
  struct Motion {
    Point position;
    Vec velocity, acceleration;
  };

  void start(std::int64_t now_ns) noexcept;
  void pick_up() noexcept;
  void step() noexcept;
  void correct(bool draws, const Motion& motion) noexcept;
  void learn_load(Vec load, Vec velocity) noexcept;
  [[nodiscard]] Vec expected_load(Vec velocity) const noexcept;
  [[nodiscard]] Vec load_at_pen() const noexcept;
  [[nodiscard]] Vec motor_noise(Vec muscles_n) noexcept;
  void feel_contact(bool presses) noexcept;
  void lead(Vec known_load) noexcept;
  [[nodiscard]] double depth_noise_mm(double t_s) const noexcept;
  [[nodiscard]] Vec error_across() noexcept;
  [[nodiscard]] const Aim& planned(std::size_t ticks_ago) const noexcept;
  [[nodiscard]] Point planned_point(std::size_t ticks_ago) const noexcept;
  [[nodiscard]] Motion planned_motion() const noexcept;

  Person person_;
  bool renders_surface_;  // StylusPreset
  SimulatedStylus stylus_;
  Random random_;
  Tones tremor_, wander_, depth_;
  bool started_ = false, holds_ = false;
  std::optional<Aim> newest_;
  double tick_s_ = 0.001;
  std::size_t preview_ = 0, eye_delay_ = 0, arm_delay_ = 0;  // ticks
  std::int64_t start_ns_ = 0, now_ns_ = 0;
  // Ring buffers, one entry a tick; that of tick_ is the newest.
  std::vector<Aim> plan_;
  std::vector<Vec> error_;      // what the eye will see, mm
  std::vector<Vec> deviation_;  // of the arm from the plan, mm
  std::size_t tick_ = 0;
  std::size_t match_ = 0;  // ticks ago of the planned position nearest to the pen
  std::optional<Vec> shown_error_;

  Point arm_;
  Vec arm_velocity_;                     // mm/s
  Vec offset_, offset_speed_, lagging_;  // correction of the plan, mm and mm/s
  Vec eye_noise_;                        // mm
  std::array<Vec, 2> muscle_{};          // N, after one lag and after two
  Vec load_;                             // N, learnt: x along the movement, y across it
  // How far the arm goes ahead of the plan, because the fingers yield to a known load: mm, mm/s,
  // mm/s^2.
  Vec lead_, lead_speed_, lead_acceleration_;
  double touch_ = 0.0;  // 1: the pen feels a surface; low-passed
};

}  // namespace felt
