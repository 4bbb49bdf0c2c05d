#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "felt/stroke/stroke.h"
#include "felt/tools/eraser/parameter_set.h"
#include "felt/tools/eraser/swept.h"

namespace felt {

/// Erases the part of a stroke's ink that the eraser has covered. Because ink is a union of discs,
/// some of the remaining ink must be erased too, but as little as possible (R39).
///
/// The ink of a stroke is the union of the discs with centre f(u) and diameter W(u). The clearance
/// at u is the distance from f(u) to the nearest point that was covered. The disc around f(u) with
/// the clearance as its radius is the largest one that covers no erased point:
///   - If the eraser covered only the rim, the line becomes narrower: W(u) = 2 clearance.
///   - If the eraser reached the centre line, or less than kThinnestMm would be left, the line is
///     cut.
///   - Towards a cut, the ink would taper to a point. The cut end moves back to the first point
///     whose round cap covers this taper, except for at most kLostTipMm of the taper's tip. So a
///     line crossed at right angles ends in a cap of its own width that touches the edge of the
///     covered area.
///
/// The centre line never moves.
///
/// The clearance is sampled along the touched parts of the curve. Each sample is the minimum over
/// all capsules, so the result depends neither on the order of the capsules nor on how many of them
/// a path is divided into.
class InkNarrowing {
 public:
  static constexpr double kThinnestMm = 0.1;
  static constexpr double kLostTipMm = 0.1;
  /// Maximum error of the narrowed width between its breakpoints, mm.
  static constexpr double kWidthErrorMm = 0.01;
  /// Maximum error of the tone between its breakpoints.
  static constexpr double kToneError = 0.05;

  /// All capsules passed to add() must have this radius.
  InkNarrowing(std::shared_ptr<const Stroke> stroke, double radius_mm);

  /// Adds a capsule that covers these parts of the ink of a segment (add_swept with
  /// adds_half_width). Returns true if this changes the result.
  bool add(int segment, const ParameterSet& covered, const Capsule& capsule);

  struct Result {
    ParameterSet holes;             ///< the line is cut here
    std::vector<WidthKnot> widths;  ///< the new profile of the whole stroke; empty: unchanged
    ParameterSet touched;           ///< elsewhere, the ink is unchanged
  };
  [[nodiscard]] Result result() const;
  /// Returns the maximum number of points that result() processes.
  [[nodiscard]] std::size_t place_count() const noexcept { return clear_.size(); }

 private:
  /// A sample in touched ink. On a closed stroke u may exceed n if the part crosses the seam.
  struct Place {
    double u = 0.0;
    Point point;
    double half_mm = 0.0;   // half width of the ink
    double clear_mm = 0.0;  // half width that may remain, at most half_mm
    double tone = 0.0;
  };
  /// A touched part of the stroke. A free end is an end of the stroke, with no ink beyond it.
  struct Part {
    std::vector<Place> places;
    bool free_start = false;
    bool free_end = false;
  };
  using Run = std::pair<std::size_t, std::size_t>;  // indices of places, both inclusive
  using Sample = std::pair<int, double>;            // segment and parameter on it, in [0, 1]

  [[nodiscard]] int steps_of(int segment) const noexcept;
  bool add_sample(Sample at, const Cubic& curve, const Capsule& capsule);
  [[nodiscard]] Place place_at(double u, double clear_mm) const noexcept;
  [[nodiscard]] std::vector<Part> parts() const;
  [[nodiscard]] Part part_between(double from, double to) const;
  void append_samples(double from, double to, double add_u, std::vector<Place>& places) const;
  [[nodiscard]] static bool stays(const Place& place) noexcept;
  /// Returns the run without the tips that the round caps of the remaining ink cover.
  [[nodiscard]] static Run trimmed(const Part& part, Run run);
  /// Adds the cuts of a part to `holes`; returns the breakpoints of its narrowed ink.
  [[nodiscard]] std::vector<WidthKnot> cut(const Part& part, ParameterSet& holes) const;
  void add_hole(double from, double to, ParameterSet& holes) const;

  std::shared_ptr<const Stroke> stroke_;
  double step_mm_;
  ParameterSet touched_;
  std::map<Sample, double> clear_;
};

}  // namespace felt
