#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/geometry/point.h"
#include "felt/trial/line_tree.h"
#include "felt/trial/trial_metrics.h"

namespace felt {

/// The path of a trial, without repeated points. A closed path repeats its first point at the end.
class TrialPath {
 public:
  TrialPath(std::span<const Point> path, TrialPathEnds ends);

  [[nodiscard]] bool empty() const noexcept { return line_.empty(); }
  [[nodiscard]] std::span<const Point> line() const noexcept { return line_; }
  [[nodiscard]] bool closed() const noexcept { return closed_; }
  [[nodiscard]] double length_mm() const noexcept { return length_mm_; }
  /// True for an open path that leads straight from its first to its last point.
  [[nodiscard]] bool straight() const noexcept;
  [[nodiscard]] PolylineNearest nearest(Point p) const noexcept { return tree_.nearest(p); }
  /// Returns the unit direction at a nearest point; at a corner, the mean direction of both lines.
  /// (0, 0) if the path has no length.
  [[nodiscard]] Vec tangent(const PolylineNearest& at) const noexcept;
  /// True if `at` is the first or the last point of an open path.
  [[nodiscard]] bool is_end(const PolylineNearest& at) const noexcept;

 private:
  [[nodiscard]] Vec direction(std::size_t index) const noexcept;

  std::vector<Point> line_;
  LineTree tree_;
  double length_mm_ = 0.0;
  bool closed_ = false;
};

/// A range of samples in contact, [begin, end).
struct TrialTouch {
  std::size_t begin = 0, end = 0;
};

/// The valid samples of a trial, and where the pen touches the surface.
struct TrialInk {
  std::vector<TrialSample> samples;
  std::vector<TrialTouch> touches;
  std::vector<Point> points;  ///< the samples in contact, in order

  /// The samples from the first to the last in contact, including those between two touches.
  [[nodiscard]] std::span<const TrialSample> movement() const noexcept;
};

/// Returns b - a in seconds. Requires a <= b.
double seconds_between(const TrialSample& a, const TrialSample& b) noexcept;

// Each of these sets some metrics. Requires at least one touch.
void measure_errors(const TrialInk& ink, const TrialPath& path, const TrialGeometry& geometry,
                    TrialMetrics& metrics);
void measure_frechet(const TrialInk& ink, const TrialPath& path, TrialMetrics& metrics);
void measure_straight(const TrialInk& ink, const TrialPath& path, const TrialGeometry& geometry,
                      TrialMetrics& metrics);
void measure_smoothness(const TrialInk& ink, TrialMetrics& metrics);
void measure_forces(const TrialInk& ink, TrialMetrics& metrics);
void measure_pressure(const TrialInk& ink, TrialMetrics& metrics);

}  // namespace felt
