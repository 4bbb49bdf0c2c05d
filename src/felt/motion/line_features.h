#pragma once

#include <utility>
#include <vector>

#include "felt/stroke/stroke.h"

namespace felt {

/// The arc length of a stroke at its joints and between them, by straight lines between even steps
/// of the parameter.
class StepLengths {
 public:
  explicit StepLengths(const Stroke& stroke);

  [[nodiscard]] double length_mm() const noexcept { return lengths_.back(); }
  /// Returns the arc length at u in mm.
  [[nodiscard]] double length_at(double u) const noexcept;
  /// Returns the parameter at an arc length, clamped to the stroke.
  [[nodiscard]] double u_at(double length_mm) const noexcept;

 private:
  std::vector<double> lengths_;  // at each step
};

/// A place where a line turns: a corner, or a bend that is tight for the size of the line.
struct LineFeature {
  double share = 0.0;  ///< arc length from the start, as a share of the whole length, 0..1
  double turn_rad = 0.0;
};

/// Returns the features of a stroke, in the order along it, without its ends.
std::vector<LineFeature> line_features(const Stroke& stroke, const StepLengths& lengths);

/// Returns pairs of features that correspond to each other, as indices: the sequence alignment with
/// the least cost (Needleman and Wunsch, 1970, doi:10.1016/0022-2836(70)90057-4).
std::vector<std::pair<std::size_t, std::size_t>> align_features(const std::vector<LineFeature>& a,
                                                                const std::vector<LineFeature>& b);

}  // namespace felt
