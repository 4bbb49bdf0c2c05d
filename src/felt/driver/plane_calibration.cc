#include "felt/driver/plane_calibration.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace felt {
namespace {

constexpr double kMaxCornerMm = 1e6;
constexpr double kRigid = 1e-6;

Vec3 cross(const Vec3& a, const Vec3& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double determinant(const std::array<Vec3, 3>& rows) noexcept {
  return dot(rows[0], cross(rows[1], rows[2]));
}

bool is_near(const Vec3& a) noexcept {
  return is_finite(a) && std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(a.z)}) <= kMaxCornerMm;
}

/// The eigenvectors and eigenvalues of a symmetric matrix, by Jacobi rotations. The largest value
/// comes first.
struct Axes {
  std::array<Vec3, 3> vectors;
  std::array<double, 3> values;
};

Axes principal_axes(std::array<std::array<double, 3>, 3> m) noexcept {
  std::array<std::array<double, 3>, 3> v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int sweep = 0; sweep < 30; ++sweep) {
    for (std::size_t turn = 0; turn < 3; ++turn) {
      const std::size_t p = turn == 2 ? 1 : 0, q = turn == 0 ? 1 : 2;
      if (m[p][q] == 0.0) continue;
      const double theta = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
      const double t = std::copysign(1.0, theta) / (std::fabs(theta) + std::hypot(theta, 1.0));
      const double c = 1.0 / std::hypot(t, 1.0), s = t * c;
      for (auto& row : m) {
        const double a = row[p], b = row[q];
        row[p] = c * a - s * b;
        row[q] = s * a + c * b;
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const double a = m[p][k], b = m[q][k];
        m[p][k] = c * a - s * b;
        m[q][k] = s * a + c * b;
      }
      for (auto& row : v) {
        const double a = row[p], b = row[q];
        row[p] = c * a - s * b;
        row[q] = s * a + c * b;
      }
    }
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return m[a][a] > m[b][b]; });
  Axes axes;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t k = order[i];
    axes.vectors[i] = {v[0][k], v[1][k], v[2][k]};
    axes.values[i] = m[k][k];
  }
  return axes;
}

Axes spread_of(std::span<const PlaneTouch> touches, const Vec3& middle) noexcept {
  std::array<std::array<double, 3>, 3> sum{};
  for (const PlaneTouch& touch : touches) {
    const Vec3 d = touch.device_mm - middle;
    const std::array<double, 3> a{d.x, d.y, d.z};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) sum[i][k] += a[i] * a[k];
    }
  }
  return principal_axes(sum);
}

Result<void> check(std::span<const PlaneTouch> touches) {
  if (touches.size() < 3) {
    return fail(ErrorCode::kInvalidArgument,
                "a plane needs at least three touches, but there are only " +
                    std::to_string(touches.size()));
  }
  for (const PlaneTouch& touch : touches) {
    if (!is_near(touch.device_mm) || !is_near({touch.page_mm.x, touch.page_mm.y, 0.0})) {
      return fail(ErrorCode::kInvalidArgument, "the position of a touch is invalid");
    }
  }
  for (std::size_t i = 0; i < touches.size(); ++i) {
    for (std::size_t k = i + 1; k < touches.size(); ++k) {
      if (norm(touches[i].device_mm - touches[k].device_mm) >= kMinApartMm) continue;
      return fail(ErrorCode::kInvalidArgument,
                  "touches " + std::to_string(i + 1) + " and " + std::to_string(k + 1) +
                      " are closer than 15 mm: touch points farther apart");
    }
  }
  return {};
}

/// The best rotation within the plane, in its own axes u and v: page = turn * (u, v), with or
/// without a reflection.
struct Turn {
  double a = 1.0, b = 0.0;  // cosine and sine
  double gain = 0.0;        // sum of products; a larger sum means a smaller residual
};

Turn best_turn(std::span<const PlaneTouch> touches, const Vec3& middle, Point page_middle,
               const Vec3& u, const Vec3& v) noexcept {
  double along = 0.0, across = 0.0;
  for (const PlaneTouch& touch : touches) {
    const Vec3 d = touch.device_mm - middle;
    const Vec s = touch.page_mm - page_middle;
    const double x = dot(u, d), y = dot(v, d);
    along += x * s.x + y * s.y;
    across += x * s.y - y * s.x;
  }
  const double length = std::hypot(along, across);
  if (!(length > 0.0)) return {};
  return {along / length, across / length, length};
}

}  // namespace

std::optional<PlaneCalibration> PlaneCalibration::from(const std::array<Vec3, 3>& rows,
                                                       const Vec3& offset, double scale) {
  if (!is_near(offset)) return std::nullopt;
  if (!(scale >= kMinPageScale && scale <= kMaxPageScale)) return std::nullopt;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!is_near(rows[i]) || std::fabs(norm(rows[i]) - 1.0) > kRigid) return std::nullopt;
    if (std::fabs(dot(rows[i], rows[(i + 1) % 3])) > kRigid) return std::nullopt;
  }
  PlaneCalibration calibration;
  calibration.rows_ = rows;
  calibration.offset_ = offset;
  calibration.scale_ = scale;
  return calibration;
}

bool PlaneCalibration::mirrors() const noexcept {
  return determinant(rows_) < 0.0;
}

double PlaneCalibration::tilt_deg() const noexcept {
  const double cosine = std::min(1.0, std::fabs(rows_[2].z));
  return std::acos(cosine) * (180.0 / 3.14159265358979323846);
}

Capabilities PlaneCalibration::to_page(const Capabilities& device) const noexcept {
  Capabilities mapped = device;
  mapped.max_stiffness_n_per_m /= scale_;
  mapped.max_damping_n_s_per_m /= scale_;
  mapped.position_step_mm *= scale_;
  mapped.mass_kg /= scale_;
  mapped.page_scale = scale_;
  const Vec3 &low = device.workspace_min, &high = device.workspace_max;
  mapped.workspace_min = mapped.workspace_max = to_page(low);
  for (int corner = 1; corner < 8; ++corner) {
    const Vec3 p = to_page(Vec3{corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y,
                                corner & 4 ? high.z : low.z});
    Vec3 &smallest = mapped.workspace_min, &largest = mapped.workspace_max;
    smallest = {std::min(smallest.x, p.x), std::min(smallest.y, p.y), std::min(smallest.z, p.z)};
    largest = {std::max(largest.x, p.x), std::max(largest.y, p.y), std::max(largest.z, p.z)};
  }
  return mapped;
}

std::array<PlaneTouch, 3> corner_touches(const Vec3& upper_left, const Vec3& upper_right,
                                         const Vec3& lower_left, Point origin) {
  return {{{upper_left, origin},
           {upper_right, origin + Vec{norm(upper_right - upper_left), 0.0}},
           {lower_left, origin + Vec{0.0, norm(lower_left - upper_left)}}}};
}

// The plane goes through the mean of the touches. The two largest principal axes of the touches
// span the plane, and the third axis is its normal. The rotation within the plane is fitted twice,
// with and without a reflection, and the better fit is used. `device` chooses the sign of the
// normal. The scale is 1.
Result<PlaneFit> fit_plane(std::span<const PlaneTouch> touches, Handedness device) {
  if (Result<void> checked = check(touches); !checked) return tl::unexpected(checked.error());
  const double share = 1.0 / static_cast<double>(touches.size());
  Vec3 middle{};
  Vec page{};
  for (const PlaneTouch& touch : touches) {
    middle += share * touch.device_mm;
    page = page + share * (touch.page_mm - Point{});
  }
  const Point page_middle = Point{} + page;
  const Axes axes = spread_of(touches, middle);
  if (!(std::sqrt(std::max(0.0, axes.values[1])) >= kMinBesideMm)) {
    return fail(ErrorCode::kInvalidArgument,
                "the touches lie on one line: touch three corners of the drawing area");
  }
  const Vec3 &u = axes.vectors[0], &v = axes.vectors[1];
  const Vec3 normal = cross(u, v);
  const Turn plain = best_turn(touches, middle, page_middle, u, v);
  const Turn mirrored = best_turn(touches, middle, page_middle, u, -v);
  const bool flip = mirrored.gain > plain.gain;
  const Turn& turn = flip ? mirrored : plain;
  const Vec3 w = flip ? -v : v;
  // The frame of the surface is left-handed, so the map of a right-handed device must mirror.
  const double wanted = device == Handedness::kRight ? -1.0 : 1.0;
  const std::array<Vec3, 3> rows{turn.a * u - turn.b * w, turn.b * u + turn.a * w,
                                 (flip ? -wanted : wanted) * normal};
  const PlaneCalibration turned = *PlaneCalibration::from(rows, {});
  const Vec3 offset = Vec3{page_middle.x, page_middle.y, 0.0} - turned.to_page(middle);
  const auto calibration = PlaneCalibration::from(rows, offset);
  if (!calibration) return fail(ErrorCode::kInvalidArgument, "the touches are too far away");
  PlaneFit fit{*calibration};
  double sum = 0.0;
  for (const PlaneTouch& touch : touches) {
    const Vec3 at = calibration->to_page(touch.device_mm);
    const double off = norm(at - Vec3{touch.page_mm.x, touch.page_mm.y, 0.0});
    sum += off * off;
    fit.worst_mm = std::max(fit.worst_mm, off);
  }
  fit.rms_mm = std::sqrt(share * sum);
  return fit;
}

}  // namespace felt
