#pragma once

#include <cmath>
#include <cstdint>

#include "felt/geometry/point.h"
#include "felt/haptics/pen_sample.h"

namespace felt {

/// Returns true if the position is valid for a pen. Samples at other positions are dropped before
/// any other processing.
inline bool is_pen_position(const Vec3& at) noexcept {
  return is_in_range(Point{at.x, at.y}) && std::fabs(at.z) <= kMaxCoordinateMm;
}

/// Decides when a pen touches the surface and when it has left it, so that a bounce of the pen does
/// not split the gesture in two. The session calls update() once per sample and passes the result
/// to the tool.
///
/// Contact begins with the first sample in contact, so a single tap makes a dot. It ends when the
/// pen is kLiftMm above the surface, or has been out of contact for kLiftNs, or for kMaxGapSamples
/// samples (in case the clock stands still). Until contact ends, samples out of contact neither
/// draw nor end the gesture; the caller buffers them.
///   - kLiftMm is more than the resolution of a sensor (0.03 mm), the height of grain (0.1 mm) and
///     a bounce of the tip (0.3 mm), but a hand that lifts the pen (50 mm/s and more) reaches this
///     height in 10 ms.
///   - During kLiftNs, a 133 Hz tablet sends three reports, so one may be lost. The shortest lift
///     between two strokes of handwriting takes twice as long.
///
/// A pen that lands on a plane of a force device is thrown back, higher and for longer than that
/// (docs/design/loop.md#landing). Until it has stayed on the surface for kLandedNs, a gap is such a
/// bounce if the surface alone can have thrown the pen: it rises no faster than it landed and no
/// faster than it left the surface, it stays below kBounceMm, and it is back within kBounceNs, or
/// within kLowBounceNs if it stays below kLowBounceMm, where the friction of a device can hold it.
/// A hand that lifts the pen accelerates it after it has left the surface, so the contact ends at
/// once. This rule holds only for pens whose depth tells contact (no pressure), and not for a pen
/// that jumps to the surface (kMaxLandingMmPerS), like that of a mouse or a script.
class Contact {
 public:
  static constexpr double kLiftMm = 0.5;
  static constexpr std::int64_t kLiftNs = 25'000'000;
  static constexpr int kMaxGapSamples = 256;
  static constexpr std::int64_t kLandedNs = 200'000'000;
  static constexpr double kBounceMm = 2.5;
  static constexpr std::int64_t kBounceNs = 350'000'000;
  static constexpr double kLowBounceMm = 0.7;
  static constexpr std::int64_t kLowBounceNs = 1'000'000'000;
  static constexpr double kMinLandingMmPerS = 10.0;
  static constexpr double kMaxLandingMmPerS = 400.0;
  /// Maximum number of samples of a bounce: kLowBounceNs at the fastest loop, 5 kHz.
  static constexpr int kMaxBounceSamples = 5000;

  /// The effect of a sample on the contact.
  enum class Change {
    kAir,      ///< still above the surface
    kTouched,  ///< a contact begins
    kDown,     ///< still in contact
    kGap,      ///< out of contact, possibly a bounce
    kBack,     ///< the gap was a bounce; this sample is in contact again
    kLifted,   ///< the contact ended at the first sample of the gap
  };

  /// Sets the time on the surface after which a pen has landed (kLandedNs); 0 switches the rule for
  /// landing pens off. Recordings of earlier versions need their own time to draw the same strokes.
  void set_landed_ns(std::int64_t landed_ns) noexcept { landed_ns_ = landed_ns; }
  /// Forgets all samples: the pen is above the surface.
  void reset() noexcept;

  /// Handles the next sample. Requires a finite position.
  Change update(const PenSample& sample) noexcept;

  /// Returns true from kTouched until kLifted.
  [[nodiscard]] bool is_down() const noexcept { return phase_ != Phase::kAir; }

 private:
  enum class Phase { kAir, kDown, kGap };

  /// The filter's error for one step of a position sensor (0.03 mm) is at most 6 mm/s.
  static constexpr double kSpeedHz = 40.0;

  Change touch(const PenSample& sample) noexcept;
  [[nodiscard]] bool is_chatter(const PenSample& sample) const noexcept;
  [[nodiscard]] bool is_bounce(const PenSample& sample) const noexcept;

  Phase phase_ = Phase::kAir;
  VelocityFilter speed_{kSpeedHz};
  std::int64_t last_ns_ = 0;
  std::int64_t landed_ns_ = kLandedNs;
  bool lands_ = false;             // the pen may still bounce
  double fall_mm_per_s_ = 0.0;     // downwards, at the last sample in the air
  double leaving_mm_per_s_ = 0.0;  // upwards, at the first sample of the gap
  double gap_from_mm_ = 0.0;       // height of that sample
  std::int64_t down_since_ns_ = 0;
  std::int64_t gap_since_ns_ = 0;
  int gap_samples_ = 0;
};

}  // namespace felt
