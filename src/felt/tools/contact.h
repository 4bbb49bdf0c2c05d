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
class Contact {
 public:
  static constexpr double kLiftMm = 0.5;
  static constexpr std::int64_t kLiftNs = 25'000'000;
  static constexpr int kMaxGapSamples = 256;

  /// The effect of a sample on the contact.
  enum class Change {
    kAir,      ///< still above the surface
    kTouched,  ///< a contact begins
    kDown,     ///< still in contact
    kGap,      ///< out of contact, possibly a bounce
    kBack,     ///< the gap was a bounce; this sample is in contact again
    kLifted,   ///< the contact ended at the first sample of the gap
  };

  /// Handles the next sample. Requires a finite position.
  Change update(const PenSample& sample) noexcept {
    if (in_contact(sample)) {
      const Phase before = phase_;
      phase_ = Phase::kDown;
      if (before == Phase::kAir) return Change::kTouched;
      return before == Phase::kGap ? Change::kBack : Change::kDown;
    }
    if (phase_ == Phase::kAir) return Change::kAir;
    if (phase_ == Phase::kDown) {
      phase_ = Phase::kGap;
      gap_since_ns_ = sample.time_ns;
      gap_samples_ = 0;
    }
    // Computed in double, because the difference of two invalid times may overflow 64 bits.
    const double gap_ns = static_cast<double>(sample.time_ns) - static_cast<double>(gap_since_ns_);
    if (sample.position.z < kLiftMm && gap_ns < static_cast<double>(kLiftNs) &&
        ++gap_samples_ < kMaxGapSamples) {
      return Change::kGap;
    }
    phase_ = Phase::kAir;
    return Change::kLifted;
  }

  /// Returns true from kTouched until kLifted.
  [[nodiscard]] bool is_down() const noexcept { return phase_ != Phase::kAir; }

 private:
  enum class Phase { kAir, kDown, kGap };

  Phase phase_ = Phase::kAir;
  std::int64_t gap_since_ns_ = 0;
  int gap_samples_ = 0;
};

}  // namespace felt
