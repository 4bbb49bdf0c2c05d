#include "felt/document/symmetry_group.h"

#include <algorithm>

#include "felt/base/constants.h"
#include "felt/document/drawing_guide.h"

namespace felt {
namespace {

bool is_within(double value, double largest) noexcept {
  return value >= -largest && value <= largest;  // false for NaN
}

}  // namespace

Result<void> check_symmetry_group(const SymmetryGroup& group) {
  using G = DrawingGuide;
  if (!is_within(group.center.x, G::kMaxCoordinateMm) ||
      !is_within(group.center.y, G::kMaxCoordinateMm) ||
      !is_within(group.angle_rad, G::kMaxAngleRad)) {
    return invalid_data("the symmetry has an invalid centre or angle");
  }
  if (group.axes < G::kMinAxes || group.axes > G::kMaxAxes) {
    return invalid_data("the symmetry does not have 1 to 16 axes");
  }
  if (group.images.size() < 2) return invalid_data("the symmetry has fewer than two images");
  std::vector<StrokeId> strokes;
  int last = -1;
  for (const SymmetryImage& image : group.images) {
    if (image.image <= last || image.image >= 2 * group.axes) {
      return invalid_data("the symmetry has an invalid image");
    }
    last = image.image;
    strokes.push_back(image.stroke);
  }
  std::sort(strokes.begin(), strokes.end());
  if (!strokes.front() || std::adjacent_find(strokes.begin(), strokes.end()) != strokes.end()) {
    return invalid_data("the symmetry has an invalid stroke");
  }
  return {};
}

Affine image_map(const SymmetryGroup& group, int image) noexcept {
  const double step_rad = kTau / group.axes;
  if (image < group.axes) {
    return image == 0 ? Affine{} : rotation(step_rad * image, group.center);
  }
  // The reflection at the axis of angle t has the linear part [cos 2t, sin 2t; sin 2t, -cos 2t].
  const double twice_rad = 2.0 * group.angle_rad + step_rad * (image - group.axes);
  const double cosine = std::cos(twice_rad), sine = std::sin(twice_rad);
  return about(group.center, cosine, sine, sine, -cosine);
}

Affine image_map(const SymmetryGroup& group, int from, int to) noexcept {
  // Multiplies in the group first, so that the map is exact to one rounding: with rotations r and
  // reflections s, to * from^-1 is again an element of the group.
  const int n = group.axes;
  const int a = from % n, b = to % n;
  const bool reflects_from = from >= n, reflects_to = to >= n;
  if (reflects_from == reflects_to) {
    // A rotation; two reflections at axes a and b make a rotation by (b - a) steps.
    return image_map(group, ((b - a) % n + n) % n);
  }
  // A reflection is its own inverse. Rotation b after reflection a: axis a + b. Reflection b after
  // the rotation by -a: axis a + b, too.
  return image_map(group, n + (a + b) % n);
}

}  // namespace felt
