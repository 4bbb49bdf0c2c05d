#include "felt/tools/picture_contours.h"

#include <string>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/geometry/cubic.h"
#include "felt/tools/guide_line.h"

namespace felt {
namespace {

// The width of a contour is not felt.
constexpr double kAnyWidthMm = 1.0;

/// Returns the points of a contour without those that are too near to the one before.
std::vector<Point> spaced(const std::vector<Point>& contour) {
  std::vector<Point> points;
  for (const Point& point : contour) {
    if (points.empty() || distance(points.back(), point) >= 2.0 * kMinSegmentMm) {
      points.push_back(point);
    }
  }
  const bool is_closed = contour.size() > 3 && contour.front() == contour.back();
  if (is_closed && points.size() > 3) points.back() = points.front();
  return points;
}

/// Returns a contour as a stroke of straight segments, or null if it is too short.
StrokePtr stroke_of(const std::vector<Point>& contour) {
  const std::vector<Point> points = spaced(contour);
  if (points.size() < 2) return nullptr;
  StrokeData data{.points = {points.front()}, .joints = {}, .widths = {}};
  data.closed = points.size() > 3 && points.front() == points.back();
  double length_mm = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    length_mm += distance(points[i - 1], points[i]);
    const Cubic piece = straight(points[i - 1], points[i]);
    data.points.insert(data.points.end(), piece.p.begin() + 1, piece.p.end());
    if (i > 1 || data.closed) data.joints.push_back(JointKind::kCorner);
  }
  data.widths = {{0.0, kAnyWidthMm}, {static_cast<double>(points.size() - 1), kAnyWidthMm}};
  if (length_mm < kMinGuideMm) return nullptr;
  Result<Stroke> stroke = Stroke::create(std::move(data));
  return stroke ? std::make_shared<const Stroke>(*std::move(stroke)) : nullptr;
}

}  // namespace

Result<std::unique_ptr<PictureContours>> PictureContours::create(
    const std::vector<std::vector<Point>>& contours) {
  Document document;
  EditBuilder edit(document);
  bool has_line = false;
  for (std::size_t i = 0; i < contours.size(); ++i) {
    for (const Point& point : contours[i]) {
      if (is_in_range(point)) continue;
      return fail(ErrorCode::kInvalidArgument,
                  "contours: [" + std::to_string(i) + "] has a point that is not on a page");
    }
    const StrokePtr stroke = stroke_of(contours[i]);
    if (!stroke) continue;
    edit.add(document.layers().front().id, stroke);
    has_line = true;
  }
  if (!has_line) return nullptr;
  if (Result<void> done = document.apply(std::move(edit).build("Contours")); !done) {
    return tl::unexpected(done.error());
  }
  return std::unique_ptr<PictureContours>(new PictureContours(std::move(document)));
}

Scene PictureContours::scene(const Scene& drawing) const {
  return {document_, index_, drawing.selection, drawing.layer, drawing.surface, drawing.device};
}

}  // namespace felt
