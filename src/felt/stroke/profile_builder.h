#pragma once

#include <span>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// The tolerance of tones in `ProfileBuilder::follow`. It is much smaller than a visible
/// difference, but larger than the error of a tone that is computed from a width, for every width
/// tolerance in use.
inline constexpr double kFollowedTone = 0.01;

/// Builds the width profile of a stroke whose parameters change while its ink stays the same. Call
/// shift(), stretch() or follow() for each part of the stroke, from its start to its end. The old
/// parameters are called u and the new ones v.
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

  /// Appends the part [u0, u1] and adds `by`, a whole number, to its parameters. Copies its
  /// breakpoints.
  void shift(double u0, double u1, double by);
  /// Appends the part [u0, u1], mapped linearly to [v0, v1]. Keeps all its breakpoints.
  void stretch(double u0, double u1, double v0, double v1);
  /// Appends the part from the first to the last of `matches`. Adds only breakpoints that are
  /// needed to keep the widths within tolerance_mm > 0 and the tones within kFollowedTone, at the
  /// matches and at the old breakpoints between them. Requires at least two matches, ascending in u
  /// and v.
  void follow(std::span<const Match> matches, double tolerance_mm);
  /// Ends the profile at `end`, the new end of the stroke, and returns it.
  [[nodiscard]] std::vector<WidthKnot> finish(double end) &&;

 private:
  void append(double v, const WidthKnot& ink);
  void append_knots(double u0, double u1, double v0, double scale);

  std::span<const WidthKnot> old_;
  std::vector<WidthKnot> knots_;
  // True if the last part came from shift(). A further shift() then needs no breakpoint between
  // the two parts.
  bool was_shifted_ = true;
};

}  // namespace felt
