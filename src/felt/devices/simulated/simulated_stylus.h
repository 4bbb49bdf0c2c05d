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

/// A simulated force-feedback stylus in a simulated hand that follows its aim (R18, R51, R55).
/// Mouse and tablet users draw with it; tests use it, too.
///
///   SimulatedStylus stylus(*find_stylus_preset("touch"), *find_hand("typical"));
///   stylus.aim({30, 40, -2}, {}, 0);            // from mouse, tablet or script
///   servo.step(now_ns);                         // read() moves the body up to now, write() pushes
///
/// read(now) integrates from the last time to now in steps of at most 0.25 ms. Meanwhile the force
/// of the last write() acts (delayed by `delay_ticks` ticks, limited to the device's maximum). The
/// sample is like a sensor's: its position is rounded to the device's steps, and its velocity is
/// low-pass filtered.
///
/// A device without force (mouse, tablet) has no body: the pen is exactly at the aim, and write()
/// has no effect. Aims with times are played with their original spacing (AimTrack). On a device
/// without a body, each aim gives a sample with its exact position and its own time (plus the delay
/// of the track), and one read may return several samples. On a device with a body, the aims move
/// the hand.
///
/// The first read() starts the time. If time stands still or goes back, nothing moves. After a gap,
/// at most 100 ms are simulated, to bound the duration of a tick; the rest is skipped.
///
/// Call aim() from one thread; call everything else on the haptic thread, or on any thread while no
/// loop runs. Real-time safe. Deterministic: the same calls give the same bytes.
class SimulatedStylus final : public Device, public HandInput {
 public:
  static constexpr int kMaxDelayTicks = 7;
  static constexpr std::size_t kWaitingAims =
      2048;                                       ///< if more come between two reads, they are lost
  static constexpr std::size_t kMaxSamples = 16;  ///< read from a track in one read()

  /// `hand` holds the stylus at first; with nullopt nobody holds it. Delays are clamped to 0..7
  /// ticks. The pen starts 20 mm above the centre of the workspace; the first aim moves it to its
  /// position.
  explicit SimulatedStylus(const StylusPreset& preset,
                           const std::optional<SimulatedHand>& hand = typical_hand());

  ~SimulatedStylus() override;

  // Device
  [[nodiscard]] std::string_view name() const noexcept override { return preset_.name; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return preset_.capabilities;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  /// Fails with kBadData if the force is not finite, and then sets it to zero.
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override;
  std::optional<PenSample> between() noexcept override;

  /// Sets the hand's aim (HandInput). To press, aim below the surface. Targets are clamped to 100
  /// mm around the workspace; the pen itself does not leave the workspace. A target that is not
  /// finite is ignored; a pressure or tilt that is NaN counts as missing. If several aims come
  /// between two reads, only the newest counts, except that every change of contact (pressure,
  /// buttons, above or below the surface) is kept.
  using HandInput::aim;
  void aim(const Aim& aim) noexcept override;
  /// Sets the hand's aim at a time. An aim without a time discards the timed aims that still wait.
  void aim_at(std::int64_t time_ns, const Aim& aim) noexcept override;

  /// Gives the stylus to another hand at its current position, or to nobody (nullopt).
  void hold(const std::optional<SimulatedHand>& hand) noexcept;
  /// Moves the pen and the hand's aim to a position, at rest.
  void place(const Vec3& position_mm) noexcept;

  /// Returns the true state behind the sensor, for tests and measurements.
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
  [[nodiscard]] Force next_force() noexcept;
  [[nodiscard]] PenSample sense(double dt_s) noexcept;

  StylusPreset preset_;
  bool has_body_;
  std::unique_ptr<Parts> parts_;
  std::optional<Aim> waiting_;  // the oldest waiting aim, already removed from the queue
  bool is_timed_ = false;       // the newest aim had a time
  std::array<PenSample, kMaxSamples> between_{};
  std::size_t between_next_ = 0, between_end_ = 0;
  std::int64_t sampled_ns_ = 0;  // time of the last sample
  VelocityFilter velocity_;
  Force asked_, acting_;
  std::array<Force, kMaxDelayTicks + 1> delayed_{};  // ring: forces requested at the last reads
  std::size_t tick_ = 0;
  std::size_t delay_ticks_;
  bool started_ = false;
  std::int64_t now_ns_ = 0;
};

}  // namespace felt
