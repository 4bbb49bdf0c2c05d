#pragma once

#include <array>
#include <optional>
#include <span>

#include "felt/base/result.h"
#include "felt/geometry/point.h"
#include "felt/geometry/vec3.h"
#include "felt/haptics/capabilities.h"
#include "felt/haptics/force.h"

namespace felt {

/// Where the drawing plane lies in front of a device: the map from the device's frame into that of
/// the sheet (R55: "a driver maps into it"), a turn, a shift, and one scale for all directions. The
/// sheet's frame (x right, y down, z towards the hand) is left-handed; that of most devices is not,
/// so that the map mirrors as a rule.
///
/// With the turn R and the scale s (mm of the sheet for one of the hand, 0.5..2, 1 as a rule):
///
///   place     x = s R p + o        velocity  v = s R u        force  f = R^T F, so |f| = |F|
///
/// Forces are handed over as they are: a newton that a tool asks for is a newton at the hand, and
/// every limit in newtons holds where the motors are. What follows from that, at the hand:
///   - stiffness k = s K and damping b = s B, since a way of the hand is s of it on the sheet: the
///     sheet may ask for K <= k/s, and limits_for() lowers its budgets likewise;
///   - depth: a force F = K d bends the sheet by d/s at the hand;
///   - speed u = V/s: with s < 1 the hand is faster than the pen, so the bounds of speed are
///     multiplied by s;
///   - work f u = F V / s: what is passive on the sheet (no more work out of it than into it, over
///     any time) is passive at the hand, as the factor 1/s is positive and does not change.
///
/// A value; trivially copyable; the maps are real-time safe.
class PlaneCalibration {
 public:
  /// Device and sheet have the same frame.
  constexpr PlaneCalibration() noexcept = default;
  /// From rows(), offset() and scale() as they were stored. Nothing when that is no such map: axes
  /// that are not of length 1 and at right angles within 1e-6, numbers that are not finite or
  /// beyond 1e6 mm, or a scale that is not within 0.5..2.
  static std::optional<PlaneCalibration> from(const std::array<Vec3, 3>& rows, const Vec3& offset,
                                              double scale = 1.0);

  /// A place, mm.
  [[nodiscard]] constexpr Vec3 to_sheet(const Vec3& device_mm) const noexcept {
    return turn_to_sheet(device_mm) + offset_;
  }
  [[nodiscard]] constexpr Vec3 to_device(const Vec3& sheet_mm) const noexcept {
    return turn_to_device(sheet_mm - offset_);
  }
  /// A displacement or a velocity.
  [[nodiscard]] constexpr Vec3 turn_to_sheet(const Vec3& v) const noexcept {
    return {scale_ * dot(rows_[0], v), scale_ * dot(rows_[1], v), scale_ * dot(rows_[2], v)};
  }
  [[nodiscard]] constexpr Vec3 turn_to_device(const Vec3& v) const noexcept {
    const double share = 1.0 / scale_;
    return (share * v.x) * rows_[0] + (share * v.y) * rows_[1] + (share * v.z) * rows_[2];
  }
  /// A force: turned, never made longer or shorter.
  [[nodiscard]] constexpr Force turn_to_device(const Force& f) const noexcept {
    const Vec3 v = f.x * rows_[0] + f.y * rows_[1] + f.z * rows_[2];
    return {v.x, v.y, v.z};
  }
  [[nodiscard]] constexpr Force turn_to_sheet(const Force& f) const noexcept {
    const Vec3 v{f.x, f.y, f.z};
    return {dot(v, rows_[0]), dot(v, rows_[1]), dot(v, rows_[2])};
  }
  /// What the device can do, as the sheet sees it: the box around its workspace, its caps of
  /// stiffness and damping divided by the scale, its resolution times the scale.
  [[nodiscard]] Capabilities to_sheet(const Capabilities& device) const noexcept;

  /// The sheet's axes as the device sees them, each of length 1.
  [[nodiscard]] constexpr const std::array<Vec3, 3>& rows() const noexcept { return rows_; }
  /// Millimetres of the sheet for one of the hand.
  [[nodiscard]] constexpr double scale() const noexcept { return scale_; }
  /// Where the device's origin lies on the sheet, mm.
  [[nodiscard]] constexpr const Vec3& offset() const noexcept { return offset_; }
  /// Left becomes right-handed or the other way round.
  [[nodiscard]] bool mirrors() const noexcept;
  /// How far the plane leans away from the device's own horizontal or whichever plane is its x-y,
  /// degrees, 0..90.
  [[nodiscard]] double tilt_deg() const noexcept;

  friend constexpr bool operator==(const PlaneCalibration&,
                                   const PlaneCalibration&) noexcept = default;

 private:
  std::array<Vec3, 3> rows_{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 offset_{};
  double scale_ = 1.0;
};

/// A place that the pen touched, and where that is on the sheet.
struct PlaneTouch {
  Vec3 device_mm;
  Point sheet_mm;
};

/// Which hand's fingers a frame's axes are like.
enum class Handedness { kRight, kLeft };

struct PlaneFit {
  PlaneCalibration calibration;
  double rms_mm = 0.0;    ///< distance between where touches come to lie and where they should
  double worst_mm = 0.0;  ///< the largest of them
};

/// The touches of a person who does not measure: three corners of what shall be the drawing area,
/// which then lies with its upper left corner at `origin`. How far its corner is from a right angle
/// becomes the fit's residual.
std::array<PlaneTouch, 3> corner_touches(const Vec3& upper_left, const Vec3& upper_right,
                                         const Vec3& lower_left, Point origin);

/// The rigid map that fits touches best: the plane with the least squares of distances, and in it
/// the turn with the least squares (Procrustes). `device` says which way up its frame is, since
/// three touches cannot tell above from below.
///
/// Error: fewer than three touches, not finite or beyond 1e6 mm, two closer than kLeastApartMm, or
/// all of them closer than kLeastBesideMm to one line.
Result<PlaneFit> fit_plane(std::span<const PlaneTouch> touches,
                           Handedness device = Handedness::kRight);
inline constexpr double kLeastApartMm = 15.0;
inline constexpr double kLeastBesideMm = 10.0;

}  // namespace felt
