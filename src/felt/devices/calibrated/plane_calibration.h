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

/// Where the drawing plane lies in front of a device: the rigid map from the device's frame into
/// that of the sheet (R55: "a driver maps into it"). Lengths stay as they are, so that a millimetre
/// of the hand is one of the sheet, and F v is the same in both frames. The sheet's frame (x right,
/// y down, z towards the hand) is left-handed; that of most devices is not, so that the map mirrors
/// as a rule.
///
/// A value; trivially copyable; the maps are real-time safe.
class PlaneCalibration {
 public:
  /// Device and sheet have the same frame.
  constexpr PlaneCalibration() noexcept = default;
  /// From rows() and offset() as they were stored. Nothing when that is no rigid map: axes that are
  /// not of length 1 and at right angles within 1e-6, or numbers that are not finite or beyond 1e6
  /// mm.
  static std::optional<PlaneCalibration> from(const std::array<Vec3, 3>& rows, const Vec3& offset);

  /// A place, mm.
  [[nodiscard]] constexpr Vec3 to_sheet(const Vec3& device_mm) const noexcept {
    return turn_to_sheet(device_mm) + offset_;
  }
  [[nodiscard]] constexpr Vec3 to_device(const Vec3& sheet_mm) const noexcept {
    return turn_to_device(sheet_mm - offset_);
  }
  /// A displacement or a velocity.
  [[nodiscard]] constexpr Vec3 turn_to_sheet(const Vec3& v) const noexcept {
    return {dot(rows_[0], v), dot(rows_[1], v), dot(rows_[2], v)};
  }
  [[nodiscard]] constexpr Vec3 turn_to_device(const Vec3& v) const noexcept {
    return v.x * rows_[0] + v.y * rows_[1] + v.z * rows_[2];
  }
  [[nodiscard]] constexpr Force turn_to_device(const Force& f) const noexcept {
    const Vec3 v = turn_to_device(Vec3{f.x, f.y, f.z});
    return {v.x, v.y, v.z};
  }
  /// The workspace of the device becomes the box around what it is in the sheet's frame; all else
  /// is the same in every direction and stays.
  [[nodiscard]] Capabilities to_sheet(const Capabilities& device) const noexcept;

  /// The sheet's axes as the device sees them, each of length 1.
  [[nodiscard]] constexpr const std::array<Vec3, 3>& rows() const noexcept { return rows_; }
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
