#pragma once

#include <cstddef>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/geometry/affine.h"
#include "felt/geometry/point.h"

namespace felt {

/// A stroke of a symmetry group, and which of the 2n images it is.
struct SymmetryImage {
  StrokeId stroke;
  int image = 0;

  friend bool operator==(const SymmetryImage&, const SymmetryImage&) noexcept = default;
};

/// Strokes that are mirror images of each other, and stay so while one of them is edited. The n
/// axes go through `center`; the first has the angle `angle_rad`, and neighbours differ by pi / n.
/// Image 0 to n - 1 are the rotations by multiples of 2 pi / n, and image n + i is the reflection
/// at axis i (the dihedral group of order 2n, https://en.wikipedia.org/wiki/Dihedral_group).
/// Immutable, like a stroke.
struct SymmetryGroup {
  Point center{};
  double angle_rad = 0.0;
  int axes = 1;
  /// At least two, by ascending image. A stroke belongs to at most one group of a document; groups
  /// of damaged files that break this are ignored for the stroke (Document::symmetry_of).
  std::vector<SymmetryImage> images = {};

  friend bool operator==(const SymmetryGroup&, const SymmetryGroup&) = default;
};

/// Checks the invariants: finite numbers within the limits of DrawingGuide, 1 to 16 axes, and two
/// or more different images of different strokes in ascending order. All readers call this.
Result<void> check_symmetry_group(const SymmetryGroup& group);

/// Returns the mapping of the plane that turns image 0 into this image. Requires
/// 0 <= image < 2 * axes.
Affine image_map(const SymmetryGroup& group, int image) noexcept;

/// Returns the mapping that turns image `from` into image `to`.
Affine image_map(const SymmetryGroup& group, int from, int to) noexcept;

}  // namespace felt
