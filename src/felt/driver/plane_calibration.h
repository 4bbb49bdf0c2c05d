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

/// The position and orientation of the drawing plane in front of a device, stored as a map from the
/// device's frame to the page's frame (R55). The map consists of a rotation, an offset, and one
/// scale for all directions. The page's frame (x right, y down, z towards the hand) is left-handed,
/// and most devices' frames are right-handed, so the map usually contains a reflection.
///
/// With the rotation R and the scale s (mm on the page per mm of the hand, 0.5..2, usually 1), the
/// position p, velocity u and force f at the hand become x, v and F on the page:
///
///   position  x = s R p + o        velocity  v = s R u        force  f = R^T F, so |f| = |F|
///
/// Forces are not scaled: a newton that a tool requests is a newton at the hand, and every limit in
/// newtons holds at the motors. This has these effects at the hand:
///   - a stiffness K and damping B on the page are k = s K and b = s B at the hand, because 1 mm of
///     the hand is s mm on the page. If the device can render k, the page may request at most k/s,
///     and limits_for() lowers its budgets accordingly;
///   - a force F = K d lets the pen sink in by d/s at the hand;
///   - the speed of the hand is |v|/s: with s < 1 the hand is faster than the pen on the page, so
///     the speed limits are multiplied by s;
///   - the power is f u = F v / s: a force model that is passive on the page (it never gives out
///     more work than was put in) is also passive at the hand, because the factor 1/s is positive
///     and constant.
///
/// A trivially copyable value type. The mapping functions are real-time safe.
class PlaneCalibration {
 public:
  /// Makes the identity map, for a device that already reports positions in the frame of the page.
  constexpr PlaneCalibration() noexcept = default;
  /// Restores a map from stored rows(), offset() and scale(). Returns nullopt if the axes do not
  /// have length 1 or are not at right angles (both within 1e-6), if a number is not finite or
  /// exceeds 1e6 mm, or if the scale is not within 0.5..2.
  static std::optional<PlaneCalibration> from(const std::array<Vec3, 3>& rows, const Vec3& offset,
                                              double scale = 1.0);

  /// Maps a position from the device's frame to the page's, mm.
  [[nodiscard]] constexpr Vec3 to_page(const Vec3& device_mm) const noexcept {
    return turn_to_page(device_mm) + offset_;
  }
  [[nodiscard]] constexpr Vec3 to_device(const Vec3& page_mm) const noexcept {
    return turn_to_device(page_mm - offset_);
  }
  /// Maps a displacement or a velocity from the device's frame to the page's.
  [[nodiscard]] constexpr Vec3 turn_to_page(const Vec3& v) const noexcept {
    return {scale_ * dot(rows_[0], v), scale_ * dot(rows_[1], v), scale_ * dot(rows_[2], v)};
  }
  [[nodiscard]] constexpr Vec3 turn_to_device(const Vec3& v) const noexcept {
    const double share = 1.0 / scale_;
    return (share * v.x) * rows_[0] + (share * v.y) * rows_[1] + (share * v.z) * rows_[2];
  }
  /// Maps a force from the page's frame to the device's. Rotates it, but does not scale it.
  [[nodiscard]] constexpr Force turn_to_device(const Force& f) const noexcept {
    const Vec3 v = f.x * rows_[0] + f.y * rows_[1] + f.z * rows_[2];
    return {v.x, v.y, v.z};
  }
  [[nodiscard]] constexpr Force turn_to_page(const Force& f) const noexcept {
    const Vec3 v{f.x, f.y, f.z};
    return {dot(v, rows_[0]), dot(v, rows_[1]), dot(v, rows_[2])};
  }
  /// Returns the device's capabilities in the frame of the surface: the bounding box of its
  /// workspace, its maximum stiffness and damping divided by the scale, and its resolution
  /// multiplied by the scale.
  [[nodiscard]] Capabilities to_page(const Capabilities& device) const noexcept;

  /// Returns the axes of the surface in the device's frame, each of length 1.
  [[nodiscard]] constexpr const std::array<Vec3, 3>& rows() const noexcept { return rows_; }
  /// Returns millimetres on the page per millimetre of the hand.
  [[nodiscard]] constexpr double scale() const noexcept { return scale_; }
  /// Returns the position of the device's origin on the page, mm.
  [[nodiscard]] constexpr const Vec3& offset() const noexcept { return offset_; }
  /// Returns true if the map turns a left-handed frame into a right-handed one, or the reverse.
  [[nodiscard]] bool mirrors() const noexcept;
  /// Returns the angle between the drawing plane and the device's own x-y plane, degrees, 0..90.
  [[nodiscard]] double tilt_deg() const noexcept;

  friend constexpr bool operator==(const PlaneCalibration&,
                                   const PlaneCalibration&) noexcept = default;

 private:
  std::array<Vec3, 3> rows_{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 offset_{};
  double scale_ = 1.0;
};

/// A position that the pen touched: in the device's frame, and on the page.
struct PlaneTouch {
  Vec3 device_mm;
  Point page_mm;
};

/// Handedness of a frame.
enum class Handedness { kRight, kLeft };

struct PlaneFit {
  PlaneCalibration calibration;
  double rms_mm = 0.0;  ///< RMS distance between the mapped touches and their positions on the page
  double worst_mm = 0.0;  ///< the largest of these distances
};

/// Makes three touches for fit_plane() from three touched corners of the wanted drawing area, so
/// that the user need not measure any distance. The upper left corner of the area gets the position
/// `origin` on the page. The farther the angle at this corner is from a right angle, the larger is
/// the residual of the fit.
std::array<PlaneTouch, 3> corner_touches(const Vec3& upper_left, const Vec3& upper_right,
                                         const Vec3& lower_left, Point origin);

/// Returns the rigid map that fits the touches best. It consists of the least-squares plane and of
/// the least-squares rotation within that plane (Procrustes). `device` is the handedness of the
/// device's frame. It is needed because three touches do not show which side of the plane faces the
/// hand.
///
/// Fails if there are fewer than three touches, a coordinate is not finite or exceeds 1e6 mm, two
/// touches are closer together than kMinApartMm, or all touches are within kMinBesideMm of one
/// line.
Result<PlaneFit> fit_plane(std::span<const PlaneTouch> touches,
                           Handedness device = Handedness::kRight);
inline constexpr double kMinApartMm = 15.0;
inline constexpr double kMinBesideMm = 10.0;

}  // namespace felt
