#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "felt/document/document.h"
#include "felt/document/drawing_guide.h"
#include "felt/geometry/rect.h"
#include "felt/tools/guide_shape.h"

namespace felt {

/// The geometry of the guides of a drawing: which guide holds the pen, and along which line. All
/// functions accept any guide; a guide that has no valid geometry holds nothing.

/// A guide within this distance of the touch is preferred to guides that pass through every point.
inline constexpr double kGuideCaptureMm = 3.0;

/// The bounds of the paths of traces and teachers, so that only paths near the pen are searched.
/// Each is computed once for each stroke or guide, because these do not change.
class GuideBounds {
 public:
  /// Returns the bounds of the path of a trace or a teacher; an empty rectangle for other kinds and
  /// for a stroke that does not exist.
  Rect of(const DrawingGuidePtr& guide, const Document& document);

  /// Counts a search for the nearest point of a path, which takes time linear in its length.
  void count_search() noexcept { ++searches_; }
  [[nodiscard]] std::size_t searches() const noexcept { return searches_; }

 private:
  std::map<std::shared_ptr<const void>, Rect> known_;
  std::size_t searches_ = 0;
};

/// Returns the index of the guide that holds a pen that touches at a point, or nullopt:
///   1. the nearest guide with a shape of its own (ruler, line, set square, ellipse, trace,
///   teacher)
///      within kGuideCaptureMm;
///   2. otherwise the last guide that acts everywhere (parallels, compass, ellipses, perspective,
///      grids) or whose protractor the pen is on;
///   3. otherwise the nearest guide with a shape of its own.
/// A symmetry holds no pen. Use the same `bounds` for all touches of a drawing.
std::optional<std::size_t> choose_guide(std::span<const DrawingGuidePtr> guides,
                                        const Document& document, Point touch, GuideBounds& bounds);

/// Returns the line, circle or ellipse along which the guide holds a pen that touches at a point:
/// the nearest leg of a set square, the line, circle or ellipse through the point for parallels,
/// compass and ellipses. Returns nullopt for other kinds, and if the shape would be degenerate.
std::optional<GuideShape> guide_shape(const DrawingGuide& guide, Point touch);

/// Returns the centre line of a stroke as points at most 0.25 mm apart. Of a very long stroke, the
/// points are further apart, or the end is left out, so that there are at most kMaxGuidePoints.
std::vector<Point> stroke_path(const Stroke& stroke);
/// Returns true if the stroke is closed and its path ends where it begins. The path of a very long
/// stroke does not.
bool is_closed_path(const Stroke& stroke, std::span<const Point> path);

/// Returns the path of a trace (the centre line of its stroke) or a teacher; empty for other kinds,
/// if the stroke does not exist, or if the path is not finite.
std::vector<Point> guide_path(const DrawingGuide& guide, const Document& document);

/// Returns the lines that a perspective offers to a stroke that begins at a point: to each
/// vanishing point, with one vanishing point also the horizontal and the vertical, with two the
/// vertical.
std::vector<GuideStraight> perspective_lines(const DrawingGuide& guide, Point touch);
/// Returns the line whose direction is nearest to that of the movement, or nullopt without lines or
/// movement. Requires finite vectors.
std::optional<GuideStraight> line_along(std::span<const GuideStraight> lines, Vec movement);

/// A ray of a protractor or a node of a grid, and the radius within which it attracts the pen, so
/// that neighbours do not overlap.
struct GuideRay {
  GuideStraight line;
  int number = 0;          ///< multiples of the step, from 0 to ray_count() - 1
  double radius_mm = 0.0;  ///< 0 at the centre
};
struct GuideNode {
  Point at{};
  double radius_mm = 0.0;
};
/// Returns the number of rays of a protractor: as many whole steps as fit into a full turn.
int ray_count(const DrawingGuide& guide) noexcept;
/// Returns the ray nearest to a point; requires a protractor.
GuideRay nearest_ray(const DrawingGuide& guide, Point pen) noexcept;
/// Returns the node nearest to a point; requires a grid.
GuideNode nearest_node(const DrawingGuide& guide, Point pen) noexcept;

}  // namespace felt
