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

/// A force-feedback stylus that exists only as its equations, in a simulated hand that goes where
/// it is told (R18, R51, R55): what mouse and tablet users draw with, and what the tests hold.
///
///   SimulatedStylus stylus(*find_stylus_preset("touch"), *find_hand("typical"));
///   stylus.aim({30, 40, -2}, {}, 0);            // any one thread: mouse, tablet or script
///   servo.step(now_ns);                         // read() moves the body up to now, write() pushes
///
/// read(now) integrates from the last time to now, the force that was written last held (through a
/// delay line of `delay_ticks` ticks, saturated at the device's maximum), in steps of at most
/// 0.25 ms. The sample is what the sensor sees: rounded to the device's steps, velocity low-passed.
///
/// A device without force (mouse, tablet) has no body: the pen is where the hand aims, and write()
/// is without effect. Aims that say when they were are played in their own spacing (AimTrack): on
/// such a device each of them is a sample, exactly there and at its own time (plus the delay of the
/// track), several between two reads if need be; a hand with a body is led by them.
///
/// Time: the first read() starts it. Where it stands still or runs backwards nothing moves. After a
/// gap, at most 100 ms are simulated, so that a tick is bounded; the rest of it did not happen.
///
/// aim() from one thread, everything else on the haptic thread (or where no loop runs). Real-time
/// safe. The same calls give the same bytes.
class SimulatedStylus final : public Device, public HandInput {
 public:
  static constexpr int kMostDelayTicks = 7;
  static constexpr std::size_t kWaitingAims = 2048;  ///< more between two reads are lost
  static constexpr std::size_t kMostSamples = 16;    ///< that a read takes out of a track

  /// `hand`: who holds it at first; nullopt is nobody. Delays are clamped to 0..7 ticks. The pen
  /// starts 20 mm above the middle of the workspace; the first aim puts it into place.
  explicit SimulatedStylus(const StylusPreset& preset,
                           const std::optional<SimulatedHand>& hand = typical_hand());

  ~SimulatedStylus() override;

  // Device
  [[nodiscard]] std::string_view name() const noexcept override { return preset_.name; }
  [[nodiscard]] const Capabilities& capabilities() const noexcept override {
    return preset_.capabilities;
  }
  tl::expected<PenSample, DeviceFault> read(std::int64_t now_ns) noexcept override;
  /// A force that is not finite is refused with kBadData, and none holds from then on.
  tl::expected<void, DeviceFault> write(const Force& force) noexcept override;
  void stop() noexcept override;
  std::optional<PenSample> between() noexcept override;

  /// HandInput. A hand that presses aims below what it touches; targets may lie up to 100 mm
  /// outside the workspace, which the pen itself does not leave, and are clamped to that. One that
  /// is not finite is ignored, pressure or lean that is NaN is none. Several aims between two
  /// reads: the newest counts, but no change of contact (pressure, buttons, in the plane or not) is
  /// skipped.
  using HandInput::aim;
  void aim(const Aim& aim) noexcept override;
  /// Likewise. While an untimed aim is the newest, timed ones that wait are forgotten.
  void aim_at(std::int64_t time_ns, const Aim& aim) noexcept override;

  /// Another hand takes the stylus where it is, or (nullopt) nobody holds it any more.
  void hold(const std::optional<SimulatedHand>& hand) noexcept;
  /// Puts the pen somewhere, at rest, and the hand's aim with it.
  void place(const Vec3& position_mm) noexcept;

  /// The truth behind the sensor, for tests and measurements.
  [[nodiscard]] const HeldBody& body() const noexcept;
  /// Where the hand's aim is now.
  [[nodiscard]] Vec3 hand_aim() const noexcept;
  /// The force that acted during the last read().
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
  std::optional<Aim> waiting_;  // the oldest one, out of the queue
  bool is_timed_ = false;       // by what came last
  std::array<PenSample, kMostSamples> between_{};
  std::size_t between_next_ = 0, between_end_ = 0;
  std::int64_t sampled_ns_ = 0;  // time of the last sample
  VelocityFilter velocity_;
  Force asked_, acting_;
  std::array<Force, kMostDelayTicks + 1> delayed_{};  // ring: what was asked at the last reads
  std::size_t tick_ = 0;
  std::size_t delay_ticks_;
  bool started_ = false;
  std::int64_t now_ns_ = 0;
};

}  // namespace felt
