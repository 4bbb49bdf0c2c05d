#pragma once

#include <optional>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt {

/// What is measured of a path that may go around something twice. All values are about the mean
/// position of the path.
struct LoopFeatures {
  double turns = 0.0;       ///< winding number about the middle, without sign
  double steadiness = 0.0;  ///< winding divided by the sum of all turning, 0..1
  /// Mean distance between the first and the second time around, divided by the mean radius.
  double apart = 1.0;
  double gap = 1.0;        ///< distance between both ends, divided by the mean radius
  double flatness = 0.0;   ///< the smallest radius divided by the mean one
  double radius_mm = 0.0;  ///< mean radius
};

/// A closed loop that is drawn twice in one stroke: it selects what it encloses.
class DoubleLoop {
 public:
  /// Limits of the features, chosen with `./dev bench gestures`.
  static constexpr double kMinTurns = 1.75, kMaxTurns = 2.4, kMinSteadiness = 0.94;
  static constexpr double kMaxApart = 0.22, kMaxGap = 1.0, kMinFlatness = 0.3;
  static constexpr double kMinRadiusMm = 4.0;
  /// A line is enclosed if this share of its length is inside.
  static constexpr double kEnclosedShare = 0.95;
  /// The enclosed lines reach over at least this share of the loop: who circles a drawing circles
  /// it closely.
  static constexpr double kMinReach = 0.35;

  /// Returns the features of a path; turns = 0 if it has no extent.
  static LoopFeatures features(std::span<const Point> path);
  /// Returns the loop, or nullopt if a feature is outside its limits.
  static std::optional<DoubleLoop> find(std::span<const Point> path);

  /// Returns true if enough of a line, given by points, is inside.
  [[nodiscard]] bool encloses(std::span<const Point> line) const;
  /// Returns true if lines with these bounds together reach over enough of the loop.
  [[nodiscard]] bool is_about(const Rect& enclosed) const noexcept;
  [[nodiscard]] const Rect& bounds() const noexcept { return bounds_; }

 private:
  std::vector<Point> outline_;
  Rect bounds_;
};

}  // namespace felt
