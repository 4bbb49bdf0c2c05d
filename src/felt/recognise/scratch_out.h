#pragma once

#include <optional>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/geometry/rect.h"

namespace felt {

/// What is measured of a path that may cross something out.
struct ScratchFeatures {
  int passes = 0;  ///< runs to and fro along the main axis of the path
  /// Share of the path's direction that is along the main axis: the mean of cos^2 of the angle.
  double along = 0.0;
  /// The shortest pass between the first and the last one, divided by the longest pass.
  double evenness = 0.0;
  double straightness = 0.0;       ///< chord divided by length, for the most curved inner pass
  double overlap = 0.0;            ///< the smallest share of a pass that is beside the next one
  double path_per_diagonal = 0.0;  ///< length of the path divided by the diagonal of its box
};

/// A path that crosses something out: it goes to and fro over the same area. The gesture is known
/// as scratch-out from Windows for Pen Computing (1991), and as the deletion of Rubine, "Specifying
/// gestures by example", DOI 10.1145/122718.122753.
class ScratchOut {
 public:
  /// Limits of the features. A path with a value outside them does not cross anything out. A
  /// written "m" has five passes, so it takes six. The other limits were chosen with `./dev bench
  /// gestures`: written letters are less straight and less parallel than crossing out.
  static constexpr int kMinPasses = 6;
  static constexpr double kMinAlong = 0.85, kMinEvenness = 0.35, kMinStraightness = 0.85;
  static constexpr double kMinOverlap = 0.5, kMinPathPerDiagonal = 2.5;
  /// From this number of passes on, the limits of single passes are wider, because no letter has so
  /// many: a small scribble of a trembling hand is uneven.
  static constexpr int kSurePasses = 7;
  static constexpr double kSureEvenness = 0.15, kSureStraightness = 0.65, kSureOverlap = 0.25;
  /// Smallest and largest length of the longest pass, in mm. A shorter scribble is a dot.
  static constexpr double kMinPassMm = 3.0, kMaxPassMm = 150.0;
  /// A line is covered if this share of its length is in the area between the passes.
  static constexpr double kCoveredShare = 0.75;
  /// A line of which less is in the area is covered, too, if this number of passes cross it and
  /// this share is in the area: a long line that is scribbled over at an angle. At a small angle,
  /// fewer passes cross it, but more of it is in the area.
  static constexpr int kMinCrossings = 4, kMinFlatCrossings = 3;
  static constexpr double kCrossedShare = 0.4, kFlatCrossedShare = 0.55;
  /// The covered lines together reach over at least this share of the length of the area: a user
  /// who shades a face does not cross out an eye.
  static constexpr double kMinReach = 0.4;
  /// Lines this near to the area count as inside.
  static constexpr double kMarginMm = 0.8;

  /// Returns the features of a path; passes = 0 if it has no extent.
  static ScratchFeatures features(std::span<const Point> path);
  /// Returns the area that the path crosses out, or nullopt if a feature is outside its limits.
  static std::optional<ScratchOut> find(std::span<const Point> path);

  /// Returns true if a point is between two passes that follow each other, or near them.
  [[nodiscard]] bool contains(Point p) const noexcept;
  /// Returns the share of a line, given by points, that is in the area.
  [[nodiscard]] double covered_share(std::span<const Point> line) const;
  /// Returns how many passes cross a line. Passes count as straight.
  [[nodiscard]] int crossings(std::span<const Point> line) const;
  /// Returns true if the path crosses out a line.
  [[nodiscard]] bool covers(std::span<const Point> line) const;
  /// Returns true if lines with these bounds together reach over enough of the area.
  [[nodiscard]] bool is_about(const Rect& covered) const noexcept;
  [[nodiscard]] const Rect& bounds() const noexcept { return bounds_; }

 private:
  std::vector<Point> turns_;  // the ends of the passes
  Rect bounds_;
};

}  // namespace felt
