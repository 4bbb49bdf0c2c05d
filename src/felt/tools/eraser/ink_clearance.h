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

/// Erases the ink of one stroke that the eraser covered, and as little else as round ink allows
/// (R39).
///
/// The ink of a stroke is a union of discs: at u, of diameter W(u). The clearance of u is the
/// distance from f(u) to the nearest place that was covered. Discs as large as their clearance
/// cover nothing that was erased, and they are the largest ones that do:
///   * where the eraser only bit into the rim, the line becomes narrower: W(u) = 2 clearance;
///   * where it reached the middle, or less than kThinnestMm would be left, the line is cut;
///   * a cut end goes back to the place from which one round cap covers what is left of the taper,
///     to kLostTipMm: a line crossed at right angles ends in a cap of its own width that touches
///     the edge of what was covered.
/// The centre line never moves.
///
/// The clearance is kept at steps along the curve where the ink was touched. It is the least over
/// all capsules, so the result does not depend on their order or number.
class InkClearance {
 public:
  static constexpr double kThinnestMm = 0.1;
  static constexpr double kLostTipMm = 0.1;
  /// Largest difference between the narrowed width and what its breakpoints say.
  static constexpr double kWidthErrorMm = 0.01;
  /// The same of the tone.
  static constexpr double kToneError = 0.05;

  /// All capsules must have this radius.
  InkClearance(std::shared_ptr<const Stroke> stroke, double radius_mm);

  /// The capsule covers these parts of the ink of a segment (add_swept with adds_half_width).
  /// Returns true if that is anything new.
  bool add(int segment, const ParameterSet& covered, const Capsule& capsule);

  struct Result {
    ParameterSet holes;             ///< the line is cut here
    std::vector<WidthKnot> widths;  ///< the new profile of the whole stroke; empty: unchanged
  };
  [[nodiscard]] Result result() const;
  /// The number of places that result() goes through, at most.
  [[nodiscard]] std::size_t place_count() const noexcept { return clear_.size(); }

 private:
  /// A place where the ink was touched. On a closed stroke u may exceed n: through the seam.
  struct Place {
    double u = 0.0;
    Point point;
    double half_mm = 0.0;   // of the ink
    double clear_mm = 0.0;  // what may stay, at most half_mm
    double tone = 0.0;
  };
  /// A part of the stroke that was touched; a free end has nothing beyond it to hold on to.
  struct Part {
    std::vector<Place> places;
    bool free_start = false;
    bool free_end = false;
  };
  using Run = std::pair<std::size_t, std::size_t>;  // indices of places, both included

  [[nodiscard]] int steps_of(int segment) const noexcept;
  [[nodiscard]] Place place_at(double u, double clear_mm) const noexcept;
  [[nodiscard]] std::vector<Part> parts() const;
  [[nodiscard]] Part part_between(double from, double to) const;
  void append_samples(double from, double to, double add_u, std::vector<Place>& places) const;
  [[nodiscard]] static bool stays(const Place& place) noexcept;
  /// The run without the tips that the round caps of what is left cover.
  [[nodiscard]] static Run trimmed(const Part& part, Run run);
  /// Adds the cuts of a part; returns the breakpoints of what is narrowed in it.
  [[nodiscard]] std::vector<WidthKnot> cut(const Part& part, ParameterSet& holes) const;
  void add_hole(double from, double to, ParameterSet& holes) const;

  std::shared_ptr<const Stroke> stroke_;
  double step_mm_;
  ParameterSet touched_;
  std::map<std::pair<int, int>, double> clear_;  // by segment and step
};

}  // namespace felt
