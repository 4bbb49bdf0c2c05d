#include "felt/driver/page_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt {
namespace {

/// Returns the distance from the centre of a box to its boundary in this direction.
double half_way(const Vec3& direction, const Vec3& half) noexcept {
  double way = std::numeric_limits<double>::infinity();
  const auto bound = [&way](double share, double largest) {
    if (std::fabs(share) > 1e-9) way = std::min(way, largest / std::fabs(share));
  };
  bound(direction.x, half.x);
  bound(direction.y, half.y);
  bound(direction.z, half.z);
  return way;
}

double ratio(double page, double area) noexcept {
  return page > 0.0 && area > 0.0 ? page / area : 1.0;
}

}  // namespace

DrawingArea reach_of(const PlaneCalibration& plane, const Capabilities& device) noexcept {
  const Vec3 half = 0.5 * (device.workspace_max - device.workspace_min);
  return {0.5 * (device.workspace_min + device.workspace_max),
          2.0 * half_way(plane.rows()[0], half), 2.0 * half_way(plane.rows()[1], half)};
}

PlaneCalibration fit_to_page(const PlaneCalibration& plane, const DrawingArea& area,
                             const Rect& page, std::optional<double> scale) noexcept {
  double wanted = scale.value_or(
      std::max(ratio(page.width(), area.width_mm), ratio(page.height(), area.height_mm)));
  if (!std::isfinite(wanted)) wanted = 1.0;
  wanted = std::clamp(wanted, kMinPageScale, kMaxPageScale);
  const auto turned = PlaneCalibration::from(plane.rows(), {}, wanted);
  if (!turned) return plane;
  const Vec3 middle = turned->to_page(area.middle_mm);
  // Heights above the page are scaled like all other lengths.
  const Vec3 offset{0.5 * (page.x0 + page.x1) - middle.x, 0.5 * (page.y0 + page.y1) - middle.y,
                    plane.offset().z * wanted / plane.scale()};
  return PlaneCalibration::from(plane.rows(), offset, wanted).value_or(plane);
}

}  // namespace felt
