#pragma once

#include <cstdint>
#include <optional>

#include "felt/driver/evdev_port.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// The axes and buttons of a stick, and what each is used for.
struct StickLayout {
  std::uint16_t x = evdev::kAbsX;
  std::optional<std::uint16_t> y = evdev::kAbsY;  ///< nullopt for a wheel
  std::optional<std::uint16_t> pressure = {};     ///< a lever or pedal for the pressure
  std::uint16_t contact = evdev::kButtonTrigger;  ///< the pen is down while this button is held
  double half_way_mm = 45.0;                      ///< travel of the grip from the centre to an end
};

/// State of axes and buttons, as reported by the kernel.
struct StickStand {
  int error = 0;  ///< errno if the state could not be read; EINVAL if an axis has no range
  EvdevAxis x, y, pressure;
  bool touches = false;
  std::uint32_t buttons = 0;
};

/// Asks the kernel for the state of axes and buttons. Must not be called on the haptic thread,
/// because the kernel answers only when no upload is in progress.
StickStand ask_stick(EvdevPort& port, const StickLayout& layout) noexcept;

/// Converts the events of an input device into pen samples. The pen's position is the grip's, in
/// mm, with x to the right, y towards the user, and (0, 0) at the centre.
///
/// The pen is down while the contact button is held. Its z is then -2 mm times the pressure; while
/// the pen is up, z is 0.8 mm. The pressure is the position of the lever, but at least
/// kMinPressure; if the device has no lever, it is kUsualPressure. The two buttons after the
/// contact button set bits 0 and 1 of PenSample::buttons (kFirstModifier and kSecondModifier of the
/// tools).
///
/// Sticks usually report every 8 ms, so their position changes in jumps. To avoid jumps of the pen,
/// the pen moves at constant speed to a reported position within kGlideNs. The buttons of the
/// report take effect when the pen arrives there. So position, contact and velocity are consistent,
/// but about 8 ms late.
///
/// If the kernel reports that events were lost, needs_asking() returns true. After that, no more
/// events are read until another thread has called ask_stick(), and its result has been passed to
/// take().
///
/// After begin(), the object is used on the haptic thread. Its functions do not allocate, and their
/// only kernel call is to read the next event, which never waits.
class StickAxes {
 public:
  static constexpr std::int64_t kGlideNs = 8'000'000;
  static constexpr double kUsualPressure = 0.5;
  static constexpr double kMinPressure = 0.02;
  static constexpr double kDepthMm = 2.0;  ///< depth below the surface at full pressure
  static constexpr double kHoverMm = 0.8;  ///< height of the lifted pen: clearly in the air, but
                                           ///< near enough that lifting is not a jump
  static constexpr int kMaxEvents = 64;    ///< events handled in one call; the others wait
  static constexpr double kCutoffHz = 30.0;
  static constexpr std::int64_t kStaleNs = 50'000'000;

  explicit StickAxes(const StickLayout& layout) noexcept : layout_(layout) {}

  /// Sets the initial state, before the first sample. Fails with stand.error.
  tl::expected<void, int> begin(const StickStand& stand) noexcept;
  /// Reads the events since the last call. Fails with errno.
  tl::expected<void, int> listen(EvdevPort& port, std::int64_t now_ns) noexcept;
  /// Returns true if events were lost and ask_stick() must be called.
  [[nodiscard]] bool needs_asking() const noexcept { return loss_ == Loss::kAsks; }
  /// Returns true if needs_asking() has been true for so long that the last position must no longer
  /// be used.
  [[nodiscard]] bool is_stale(std::int64_t now_ns) const noexcept;
  /// Sets the state after events were lost, and lets listen() read events again. Fails with
  /// stand.error if the state could not be read; listen() then still reads no events.
  tl::expected<void, int> take(const StickStand& stand, std::int64_t now_ns) noexcept;
  /// Returns the pen sample at this time.
  PenSample sample(std::int64_t now_ns) noexcept;

  /// Returns the smallest step of the position along x, mm.
  [[nodiscard]] double step_mm() const noexcept;

 private:
  struct Axis {
    std::int32_t minimum = -32767, maximum = 32767, flat = 0, value = 0;

    void take(const EvdevAxis& axis) noexcept {
      minimum = axis.minimum, maximum = axis.maximum, flat = axis.flat, value = axis.value;
    }
    /// Returns the value as -1..1, with 0 in the dead zone around the centre.
    [[nodiscard]] double centered() const noexcept;
    /// Returns the value as a part of the range, 0..1.
    [[nodiscard]] double share() const noexcept;
  };
  struct Said {
    double x_mm = 0.0, y_mm = 0.0, pressure = 0.0;
    bool touches = false;
    std::uint32_t buttons = 0;
  };

  /// The progress after events were lost: kSkips until the incomplete report ends, then kAsks until
  /// take() has set the state.
  enum class Loss : std::uint8_t { kNone, kSkips, kAsks };

  void receive(const EvdevEvent& event) noexcept;
  void put(const StickStand& stand) noexcept;
  void report(std::int64_t now_ns) noexcept;
  [[nodiscard]] Said said() const noexcept;
  void glide_to(std::int64_t now_ns) noexcept;

  StickLayout layout_;
  Axis x_, y_, lever_;
  bool touches_ = false;
  std::uint32_t buttons_ = 0;
  Loss loss_ = Loss::kNone;
  std::int64_t lost_ns_ = 0;
  Said from_, to_, now_;
  std::int64_t from_ns_ = 0;
  std::int64_t sampled_ns_ = 0;
  bool has_sampled_ = false;
  VelocityFilter velocity_{kCutoffHz};
};

}  // namespace felt
