#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/stroke/fit/ink_fit.h"

namespace felt {

/// Samples whose u differs by at most this are treated as one position, because a profile has
/// exactly one width at each u.
inline constexpr double kSameWidthPlace = 1e-9;

/// Fits the width profile of a stroke [Paper eq. 3] while it is drawn: continuous, linear between
/// knots, within the tolerance of every sample, with knots that need not be Bezier joints (R16).
///
/// Use, for each stroke: `begin()`; `push()` for each sample, in order; `finish()`; `knots()`. The
/// object can be reused. It keeps its buffer, so it does not allocate after warm-up.
///
/// Each segment of the profile starts at the end (u1, W1) of the previous one
/// [docs/design/errata.md#e10] and has one unknown, its slope a. A sample (u, w) is within the
/// tolerance if a lies in
///   [(w - tol - W1) / (u - u1), (w + tol - W1) / (u - u1)].
/// So the intersection of these intervals shows exactly, and in O(1), whether one more sample fits.
/// This is the swing filter of Elmeleegy, Elmagarmid, Cecchet, Aref, Zwaenepoel, "Online piece-wise
/// linear approximation of numerical streams with precision guarantees", VLDB 2009, section 3. The
/// slope is the least-squares slope
///   a = sum (u - u1)(w - W1) / sum (u - u1)^2
/// clamped to the intersection (docs/design/errata.md#e11). If the intersection becomes empty, the
/// segment ends at the previous sample.
///
/// Samples that share a position (the pen stands still while the pressure changes) count as one
/// condition. If their widths spread by more than twice the tolerance, no function can meet them
/// all. Then the profile goes through the middle of the spread, which minimises the largest error.
///
/// If samples have their own tone, it is fitted by the same filter as the width, on the same knots:
/// width and tone each have a slope, and the segment ends as soon as either intersection is empty.
/// If the samples have no tone of their own, the tone at each knot is computed from its width
/// (tone_of_width()), which needs no additional knots.
class WidthFitter {
 public:
  explicit WidthFitter(const WidthFitOptions& options = {});

  /// Discards the previous stroke and starts a new one.
  void begin() noexcept;
  /// Adds the width of the next sample, at stroke parameter `u`. A `u` below the previous one
  /// counts as equal to the previous one. Ignores a sample that is not finite.
  void push(double u, double width_mm);
  /// Adds a width and a tone, which is clamped to 0..1. Requires that either all samples of a
  /// stroke have a tone or none.
  void push(double u, double width_mm, double tone);
  /// Ends the profile at `u_end` > 0, the number of Bezier segments. Its width there is that of the
  /// last sample, or as near to that as the tolerance allows (docs/design/errata.md#e11). Call at
  /// pen-up. Samples past u_end count as samples at u_end. If no sample was added, the profile is
  /// constant at min_mm.
  void finish(double u_end);
  /// Returns the knots so far, with u strictly increasing from 0; after finish() they end exactly
  /// at u_end.
  [[nodiscard]] std::span<const WidthKnot> knots() const noexcept { return knots_; }
  /// Returns the end of the segment that is still open, as if it ended at the last position that it
  /// covers. Requires that knots() is not empty and finish() was not called.
  [[nodiscard]] WidthKnot open_end() const noexcept;

 private:
  struct Range {
    double low, high;
  };
  // The values at one position.
  struct Values {
    double smallest = 0.0, largest = 0.0, sum = 0.0, last = 0.0;

    void start(double value) noexcept { *this = {value, value, 0.0, value}; }
    void add(double value) noexcept;
  };
  // A quantity that is linear between knots: the width or the tone.
  struct Channel {
    double min, max, tolerance;
    Values here{};      // values at the position that still collects samples
    double from = 0.0;  // value at the start of the open segment
    Range slopes{};     // feasible slopes of the open segment
    double sum_uw = 0.0;

    [[nodiscard]] Range allowed() const noexcept;
    [[nodiscard]] Range slopes_through(double du) const noexcept;
    [[nodiscard]] bool can_reach(double du) const noexcept;
    [[nodiscard]] double first(double count) const noexcept;
    [[nodiscard]] double end_at_best(double du, double sum_uu) const noexcept;
    [[nodiscard]] double end_at_last(double du) const noexcept;
    void start(double value) noexcept;
    void take(double du, double count) noexcept;
  };

  void collect(double u, double width_mm, double tone);
  void take_place();
  void forget_from(double u);
  void start_segment(WidthKnot knot);
  [[nodiscard]] WidthKnot knot(double u, double width_mm, double tone) const noexcept;

  Channel width_, tone_;
  bool has_tone_ = false;         // the samples have their own tone
  std::vector<WidthKnot> knots_;  // the last one is the start of the open segment
  double place_u_ = 0.0;          // position of the samples that are still collected
  double count_ = 0.0;            // number of these samples
  double sum_uu_ = 0.0;
  double reach_ = 0.0;  // u of the last position added to the open segment
};

}  // namespace felt
