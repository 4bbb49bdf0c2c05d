#pragma once

#include <cstdint>
#include <string>

#include "felt/geometry/affine.h"

namespace felt {

enum class TransformKind : std::uint8_t {
  kMove,      ///< by the displacement of the pen
  kRotate,    ///< around the centre, beyond full turns
  kScale,     ///< both axes equally, by the distance from the centre
  kStretch,   ///< each axis independently
  kStretchX,  ///< along x only
  kStretchY,  ///< along y only
};

/// The map, relative to the state at the touch, for a pen that grabbed at one point and is now at
/// another (docs/design/editing.md#transform). Turns and factors are those of haptics/tether.h, so
/// that the user feels what they see.
///
/// Factors stay within 0.05..20. Scaling depends on the distance from the centre, on either side.
/// An axis that is stretched through the centre stays at the smallest factor; nothing is mirrored.
class TransformDrag {
 public:
  static constexpr double kMinScale = 0.05;

  TransformDrag() = default;
  /// `least_scale` is the lower limit of factors, so that no segment gets too short.
  TransformDrag(TransformKind kind, Point centre, Point grab,
                double least_scale = kMinScale) noexcept;

  /// Updates the map. If constrained, moves along one axis and turns in steps of kTurnStepRad;
  /// kScale stretches both axes, kStretch only the axis along which the grab is farther from the
  /// centre.
  void update(Point pen, bool constrained) noexcept;

  [[nodiscard]] const Affine& map() const noexcept { return map_; }
  [[nodiscard]] bool is_identity() const noexcept { return map_ == Affine{}; }
  /// Returns the factor of the widths: the square root of the area factor.
  [[nodiscard]] double width_factor() const noexcept;
  /// Returns the kind after the constraint: for the force, the label and the name of the edit.
  [[nodiscard]] TransformKind kind() const noexcept { return now_; }
  [[nodiscard]] Point centre() const noexcept { return centre_; }
  [[nodiscard]] Point grab() const noexcept { return grab_; }
  /// Returns true if the last update was constrained.
  [[nodiscard]] bool is_constrained() const noexcept { return constrained_; }
  [[nodiscard]] double least_scale() const noexcept { return least_scale_; }
  /// "12.5, -3.0 mm", "37 deg", "x 1.25", "x 1.25, 0.80".
  [[nodiscard]] std::string text() const;
  /// "Move", "Rotate", "Scale", "Stretch".
  [[nodiscard]] std::string label() const;

 private:
  void move(Vec way, bool constrained) noexcept;
  void rotate(Point pen, bool constrained) noexcept;
  void scale(double factor_x, double factor_y) noexcept;
  [[nodiscard]] double axis_factor(double grab, double pen) const noexcept;

  TransformKind kind_ = TransformKind::kMove, now_ = TransformKind::kMove;
  Point centre_, grab_;
  double least_scale_ = kMinScale;
  bool constrained_ = false;
  double turn_rad_ = 0.0;  // unwrapped, unconstrained
  Affine map_;
  Vec way_;
  double shown_turn_rad_ = 0.0;
  double factor_x_ = 1.0, factor_y_ = 1.0;
};

/// An axis is not stretched if the grab is nearer than this to the centre along it.
inline constexpr double kNoAxisMm = 0.5;

/// Return whether a stretch of this kind, grabbed there, acts along x or y.
bool stretches_x(TransformKind kind, Point centre, Point grab) noexcept;
bool stretches_y(TransformKind kind, Point centre, Point grab) noexcept;

}  // namespace felt
