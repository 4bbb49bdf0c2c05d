#pragma once

#include <memory>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/stroke_index.h"
#include "felt/geometry/point.h"
#include "felt/tools/scene.h"

namespace felt {

/// The contours of pictures as lines of a document of their own, which is never seen, so that
/// Retrace holds the pen to them like to ink.
class PictureContours {
 public:
  /// Makes the lines of contours: polylines in mm, of which the last point of a closed one is its
  /// first. Leaves out those that are shorter than kMinGuideMm. Returns null if there are none.
  /// Fails if a point is out of range.
  static Result<std::unique_ptr<PictureContours>> create(
      const std::vector<std::vector<Point>>& contours);

  /// Returns a scene with the contours instead of the drawing. Valid as long as this object.
  [[nodiscard]] Scene scene(const Scene& drawing) const;

 private:
  explicit PictureContours(Document document) : document_(std::move(document)), index_(document_) {}

  Document document_;
  StrokeIndex index_;
};

}  // namespace felt
