#pragma once

#include <span>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// The tone tolerance of `ProfileBuilder::follow`: much smaller than a visible difference, and
/// larger than the error that any width tolerance in use gives to a tone computed from the width.
inline constexpr double kFollowedTone = 0.01;

/// Makes the width profile of a stroke that has the same ink but another parametrisation. Call its
/// functions part by part from the start to the end of the stroke. Old parameters are called u, new
/// ones v.
///
///   ProfileBuilder profile(old.widths());
///   profile.shift(0.0, 2.0, 0.0);         // segments 0 and 1 stay as they are
///   profile.stretch(2.0, 2.5, 2.0, 3.0);  // the first half of segment 2 becomes a segment
///   ...
///   data.widths = std::move(profile).finish(n);
class ProfileBuilder {
 public:
  /// The old and the new parameter of the same point.
  struct Match {
    double u = 0.0, v = 0.0;
  };

  /// Requires that `old` outlives this object.
  explicit ProfileBuilder(std::span<const WidthKnot> old) noexcept : old_(old) {}

  /// Appends [u0, u1] with its parameter shifted by `by`, a whole number. Copies the breakpoints.
  void shift(double u0, double u1, double by);
  /// Appends [u0, u1], mapped linearly to [v0, v1], without loss.
  void stretch(double u0, double u1, double v0, double v1);
  /// Appends a part whose parameters correspond as given by `matches`. Adds as few breakpoints as
  /// possible such that widths at these points are within tolerance_mm > 0 and tones within
  /// kFollowedTone. Requires at least two matches, ascending in u and v.
  void follow(std::span<const Match> matches, double tolerance_mm);
  /// Returns the profile up to the new end of the stroke.
  [[nodiscard]] std::vector<WidthKnot> finish(double end) &&;

 private:
  void append(double v, const WidthKnot& ink);
  void append_knots(double u0, double u1, double v0, double scale);

  std::span<const WidthKnot> old_;
  std::vector<WidthKnot> knots_;
  bool was_shifted_ = true;  // the last part was shift(): another one needs no breakpoint between
};

}  // namespace felt
