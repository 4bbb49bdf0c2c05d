#pragma once

#include <span>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// How far `ProfileBuilder::follow` lets a tone go astray: far less than an eye can tell, and more
/// than any width tolerance in use lets it where the tone is that of the width.
inline constexpr double kFollowedTone = 0.01;

/// Makes the width profile of a stroke that shows the same ink by another parameter, from its start
/// to its end, a stretch at a time. Old parameters are called u, new ones v.
///
///   ProfileBuilder profile(old.widths());
///   profile.shift(0.0, 2.0, 0.0);         // segments 0 and 1 as they are
///   profile.stretch(2.0, 2.5, 2.0, 3.0);  // half of segment 2 is a segment now
///   ...
///   data.widths = std::move(profile).finish(n);
class ProfileBuilder {
 public:
  /// The pair of parameters of one place on the ink.
  struct Match {
    double u = 0.0, v = 0.0;
  };

  /// `old` must outlive this.
  explicit ProfileBuilder(std::span<const WidthKnot> old) noexcept : old_(old) {}

  /// [u0, u1] keeps its parameter, but for a whole number: breakpoints are copied.
  void shift(double u0, double u1, double by);
  /// [u0, u1] becomes [v0, v1] linearly, without loss.
  void stretch(double u0, double u1, double v0, double v1);
  /// A part whose parameters belong together as `matches` say, at least two, ascending in both:
  /// widths at these places stay within tolerance_mm > 0 and tones within kFollowedTone, with as
  /// few breakpoints as that needs.
  void follow(std::span<const Match> matches, double tolerance_mm);
  /// The profile up to the new end of the stroke.
  [[nodiscard]] std::vector<WidthKnot> finish(double end) &&;

 private:
  void append(double v, const WidthKnot& ink);
  void append_knots(double u0, double u1, double v0, double scale);

  std::span<const WidthKnot> old_;
  std::vector<WidthKnot> knots_;
  bool was_shifted_ = true;  // no breakpoint is needed where the parameter goes on as it was
};

}  // namespace felt
