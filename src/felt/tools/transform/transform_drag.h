#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "felt/geometry/affine.h"

namespace felt {

enum class TransformKind : std::uint8_t {
  kMove,      ///< by the displacement of the pen
  kRotate,    ///< around the centre, by any number of turns
  kScale,     ///< both axes equally, by the distance from the fixed point
  kStretch,   ///< each axis independently
  kStretchX,  ///< along x only
  kStretchY,  ///< along y only
};

/// Computes the map, relative to the state at the touch, from the point that the pen grabbed and
/// its current position (docs/design/editing.md#transform). Turns and factors are computed as in
/// haptics/bricks/tether.h, so that the force agrees with the picture.
///
/// Factors stay within 0.05..20. Scaling depends only on the distance of the pen from the fixed
/// point, not on the side of it on which the pen is. If the pen crosses the fixed point along a
/// stretched axis, the factor of that axis stays at its minimum, so nothing is mirrored.
class TransformDrag {
 public:
  static constexpr double kMinScale = 0.05;

  TransformDrag() = default;
  /// `min_scale` is the lower limit of factors, so that no segment gets too short.
  TransformDrag(TransformKind kind, Point centre, Point grab,
                double min_scale = kMinScale) noexcept;
  /// Sets the point about which kScale and the stretches act instead of the centre: that opposite
  /// the grabbed handle.
  void set_opposite(Point opposite) noexcept { opposite_ = opposite; }

  /// Updates the map. If `constrained` is true, kMove moves along one axis, kRotate turns in steps
  /// of kTurnStepRad, kScale stretches both axes independently, and kStretch stretches only the
  /// axis along which the grab is farther from the fixed point. If `about_centre` is true, the
  /// point opposite the handle is ignored.
  void update(Point pen, bool constrained, bool about_centre = false) noexcept;

  [[nodiscard]] const Affine& map() const noexcept { return map_; }
  [[nodiscard]] bool is_identity() const noexcept { return map_ == Affine{}; }
  /// Returns the factor by which widths change: the square root of the area factor.
  [[nodiscard]] double width_factor() const noexcept;
  /// Returns the kind after the constraint is applied. The force, the label and the name of the
  /// edit use it.
  [[nodiscard]] TransformKind kind() const noexcept { return now_; }
  /// Returns the point that the last update left in place: the centre, or the point opposite the
  /// handle.
  [[nodiscard]] Point centre() const noexcept { return fixed_; }
  [[nodiscard]] Point grab() const noexcept { return grab_; }
  /// Returns true if the last update was constrained.
  [[nodiscard]] bool is_constrained() const noexcept { return constrained_; }
  [[nodiscard]] double min_scale() const noexcept { return min_scale_; }
  /// Returns the amount as a text: "12.5, -3.0 mm", "37 deg", "x 1.25", "x 1.25, 0.80".
  [[nodiscard]] std::string text() const;
  /// Returns the name of the edit: "Move", "Rotate", "Scale" or "Stretch".
  [[nodiscard]] std::string label() const;

 private:
  void move(Vec way, bool constrained) noexcept;
  void rotate(Point pen, bool constrained) noexcept;
  void scale(double factor_x, double factor_y) noexcept;
  [[nodiscard]] double axis_factor(double grab, double pen) const noexcept;

  TransformKind kind_ = TransformKind::kMove, now_ = TransformKind::kMove;
  Point centre_, grab_;
  std::optional<Point> opposite_;
  Point fixed_;  // centre_ or opposite_
  double min_scale_ = kMinScale;
  bool constrained_ = false;
  double turn_rad_ = 0.0;  // turn of the pen, unwrapped, before the constraint
  Affine map_;
  Vec way_;
  double shown_turn_rad_ = 0.0;
  double factor_x_ = 1.0, factor_y_ = 1.0;
};

/// Minimum distance between grab and centre along an axis, mm. If it is less, that axis is not
/// stretched.
inline constexpr double kNoAxisMm = 0.5;

/// Return true if a stretch of this kind, grabbed at `grab`, acts along x or along y, respectively.
bool stretches_x(TransformKind kind, Point centre, Point grab) noexcept;
bool stretches_y(TransformKind kind, Point centre, Point grab) noexcept;

}  // namespace felt
