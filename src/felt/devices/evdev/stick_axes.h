#pragma once

#include <cstdint>
#include <optional>

#include "felt/driver/evdev_port.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Which axes and buttons of a stick are what.
struct StickLayout {
  std::uint16_t x = evdev::kAbsX;
  std::optional<std::uint16_t> y = evdev::kAbsY;  ///< none: a wheel
  std::optional<std::uint16_t> pressure = {};     ///< a lever or pedal that says how hard
  std::uint16_t contact = evdev::kButtonTrigger;  ///< the pen is down while it is held
  double half_way_mm = 45.0;                      ///< from the middle to an end
};

/// Axes and buttons as the kernel says that they stand.
struct StickStand {
  int error = 0;  ///< errno where it cannot be said; EINVAL where an axis has no way
  EvdevAxis x, y, pressure;
  bool touches = false;
  std::uint32_t buttons = 0;
};

/// Asks for axes and buttons as they are. Not on the haptic thread: the kernel answers when no
/// upload is under way.
StickStand ask_stick(EvdevPort& port, const StickLayout& layout) noexcept;

/// From what an input device says to a pen: the grip's place in mm, x to the right, y to the
/// person, the middle at (0, 0).
///
/// The pen is down while the contact button is held: then z is -2 mm times the pressure, else 0.8
/// mm. The pressure is that of the lever, at least kLeastPressure; kUsualPressure without one. The
/// button after the contact button is bit 0, the next bit 1 (tools: kFirstModifier,
/// kSecondModifier).
///
/// Sticks report each 8 ms as a rule, and jump from report to report. Here a report is a place to
/// go to within kGlideNs, evenly, and its buttons count when it is reached: places, contact and
/// velocity belong together, some 8 ms late.
///
/// Where the kernel says that events were lost, nothing more is listened to until another thread
/// has asked how axes and buttons stand: needs_asking(), then take(). What comes meanwhile waits.
///
/// Haptic thread, after begin(); no allocation, no call of the kernel but for the next event, which
/// waits for nothing.
class StickAxes {
 public:
  static constexpr std::int64_t kGlideNs = 8'000'000;
  static constexpr double kUsualPressure = 0.5;
  static constexpr double kLeastPressure = 0.02;
  static constexpr double kDepthMm = 2.0;  ///< at full pressure
  static constexpr double kHoverMm = 0.8;  ///< lifted for sure, and no jump away from the sheet
  static constexpr int kMostEvents = 64;   ///< taken at one read; the rest at the next
  static constexpr double kCutoffHz = 30.0;
  static constexpr std::int64_t kStaleNs = 50'000'000;

  explicit StickAxes(const StickLayout& layout) noexcept : layout_(layout) {}

  /// How it stands at first, before the first sample. Error: that of the answer.
  tl::expected<void, int> begin(const StickStand& stand) noexcept;
  /// What was said since the last call. Error: errno.
  tl::expected<void, int> listen(EvdevPort& port, std::int64_t now_ns) noexcept;
  /// Events were lost: it waits for ask_stick()'s answer, asked for from now on.
  [[nodiscard]] bool needs_asking() const noexcept { return loss_ == Loss::kAsks; }
  /// It has waited for so long that nobody should take the last place for the pen's.
  [[nodiscard]] bool is_stale(std::int64_t now_ns) const noexcept;
  /// The answer. Error: that of the answer; it waits on.
  tl::expected<void, int> take(const StickStand& stand, std::int64_t now_ns) noexcept;
  /// The pen at this time.
  PenSample sample(std::int64_t now_ns) noexcept;

  /// The smallest step of the place along x, mm.
  [[nodiscard]] double step_mm() const noexcept;

 private:
  struct Axis {
    std::int32_t minimum = -32767, maximum = 32767, flat = 0, value = 0;

    void take(const EvdevAxis& axis) noexcept {
      minimum = axis.minimum, maximum = axis.maximum, flat = axis.flat, value = axis.value;
    }
    /// -1..1 about the middle, 0 where it is flat.
    [[nodiscard]] double centered() const noexcept;
    /// 0..1.
    [[nodiscard]] double share() const noexcept;
  };
  struct Said {
    double x_mm = 0.0, y_mm = 0.0, pressure = 0.0;
    bool touches = false;
    std::uint32_t buttons = 0;
  };

  /// Of events: the report that was under way is skipped; then somebody must ask.
  enum class Loss : std::uint8_t { kNone, kSkips, kAsks };

  void hear(const EvdevEvent& event) noexcept;
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
