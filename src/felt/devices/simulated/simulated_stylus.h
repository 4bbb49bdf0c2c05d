#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/haptics/pen_sample.h"
#include "felt/rt/device.h"

namespace felt {

class HeldBody;
struct StampedAim;

/// A simulated force-feedback stylus, held by a simulated hand that follows an aim (R18, R51, R55).
/// Users of a mouse or tablet draw with it; tests use it, too.
///
///   SimulatedStylus stylus(*find_stylus_preset("touch"), *find_hand("typical"));
///   stylus.aim({30, 40, -2}, {}, 0);            // from mouse, tablet or script
///   servo.step(now_ns);                         // read() moves the body up to now, write() pushes
///
/// read(now) integrates from the last time to now in steps of at most 0.25 ms. During this time the
/// force of the last write() acts, delayed by `delay_ticks` ticks and limited to the device's
/// maximum. The returned sample is like that of a real sensor: the position is rounded to the
/// device's steps, and the velocity is low-pass filtered.
///
/// A device without force out of the page (joystick) has no height: as with the driver of joysticks
/// (StickAxes), the pen is at the bottom of the workspace with full pressure, and at the top while
/// it is up. A preset with `force_hold_ns` accepts a new force only so
/// often, however fast the loop runs.
///
/// A device without force (mouse, tablet) has no body: the pen is exactly at the aim, and write()
/// has no effect. Aims with times are played with their original spacing (AimTrack). On a device
/// without a body, each aim gives one sample. The sample has the aim's position, and its time is
/// that of the aim plus the delay of the track. One read may give several such samples. On a device
/// with a body, the aims move the hand.
///
/// The simulation starts at the time of the first read(). If the time of a read is not later than
/// that of the last one, nothing moves. After a gap, at most 100 ms are simulated, to bound the
/// duration of a tick; the rest of the gap is skipped.
///
/// Call aim() from one thread; call everything else on the haptic thread, or on any thread while no
/// loop runs. Real-time safe. Deterministic: the same calls give the same bytes.
class SimulatedStylus final : public Device, public HandInput {
 public:
  static constexpr int kMaxDelayTicks = 7;
  /// Maximum number of aims that can wait for the next read. Aims beyond that are lost.
  static constexpr std::size_t kWaitingAims = 2048;
  static constexpr std::size_t kMaxSamples = 16;  ///< maximum number of samples in one read()

  /// `hand` holds the stylus initially; if it is nullopt, nobody holds the stylus. `delay_ticks` is
  /// clamped to 0..7. The pen starts 20 mm above the centre of the workspace; the first aim moves
  /// the pen to the position of that aim.
  explicit SimulatedStylus(const StylusPreset& preset,
                           const std::optional<SimulatedHand>& hand = typical_hand());

  ~SimulatedStylus() override;

  // Device
  [[nodiscard]] std::string_view name() const noexcept override { return preset_.name; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return preset_.capabilities;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  /// If the force is not finite, sets it to zero and fails with kBadData.
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override;
  std::optional<PenSample> between() noexcept override;

  /// Sets the hand's aim (HandInput). To press, aim below the surface. Targets are clamped to 100
  /// mm around the workspace; the pen itself does not leave the workspace. A target that is not
  /// finite is ignored; a pressure or tilt that is NaN counts as missing. If several untimed aims
  /// come between two reads, the second read uses only the newest. But if one of them begins or
  /// ends a contact (by pressure, buttons or depth), this aim and all later aims are left to the
  /// following read.
  using HandInput::aim;
  void aim(const Aim& aim) noexcept override;
  /// Sets the hand's aim at a time. An aim without a time discards all timed aims that were not
  /// played yet.
  void aim_at(std::int64_t time_ns, const Aim& aim) noexcept override;

  /// Lets another hand hold the stylus at its current position, or nobody (nullopt).
  void hold(const std::optional<SimulatedHand>& hand) noexcept;
  /// Moves the pen and the hand's aim to a position, at rest.
  void place(const Vec3& position_mm) noexcept;

  /// Returns the exact state of the simulation, without rounding and filtering, for tests and
  /// measurements.
  [[nodiscard]] const HeldBody& body() const noexcept;
  /// Returns the current position of the hand's aim.
  [[nodiscard]] Vec3 hand_aim() const noexcept;
  /// Returns the force that acted during the last read().
  [[nodiscard]] const Force& acting_force() const noexcept { return acting_; }

 private:
  struct Parts;

  void push_aim(const StampedAim& stamped) noexcept;
  void take_aims(std::int64_t now_ns, std::int64_t tick_ns) noexcept;
  void take_untimed(const Aim& next, std::optional<Aim>& taken) noexcept;
  [[nodiscard]] PenSample read_track(std::int64_t now_ns) noexcept;
  [[nodiscard]] PenSample sample_of(const Aim& aim, std::int64_t time_ns) noexcept;
  void move_to(std::int64_t now_ns) noexcept;
  [[nodiscard]] Force next_force(std::int64_t now_ns) noexcept;
  [[nodiscard]] PenSample sense(double dt_s) noexcept;

  StylusPreset preset_;
  bool has_body_;
  bool is_flat_;  // it has a body that does not move up and down
  std::unique_ptr<Parts> parts_;
  std::optional<Aim> waiting_;  // the oldest waiting aim, already removed from the queue
  bool is_timed_ = false;       // the newest aim had a time
  std::array<PenSample, kMaxSamples> between_{};
  std::size_t between_next_ = 0, between_end_ = 0;
  std::int64_t sampled_ns_ = 0;  // time of the last sample
  VelocityFilter velocity_;
  Force asked_, accepted_, acting_;
  std::int64_t accepted_ns_ = 0;
  std::array<Force, kMaxDelayTicks + 1>
      delayed_{};  // ring buffer: forces requested at the last reads
  std::size_t tick_ = 0;
  std::size_t delay_ticks_;
  bool started_ = false;
  std::int64_t now_ns_ = 0;
};

}  // namespace felt
