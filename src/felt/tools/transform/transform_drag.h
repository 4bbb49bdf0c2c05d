#pragma once

#include <cstdint>
#include <string>

#include "felt/geometry/affine.h"

namespace felt {

enum class TransformKind : std::uint8_t {
  kMove,      ///< by the way of the pen
  kRotate,    ///< about the centre, counted on beyond full turns
  kScale,     ///< both axes alike, by the distance from the centre
  kStretch,   ///< each axis by itself
  kStretchX,  ///< along x only
  kStretchY,  ///< along y only
};

/// What a pen that took hold at one place and is now at another does to the sheet: a map from the
/// state at the touch (specification 5e; E15, E16). Turns and factors are those of
/// haptics/tether.h, so that the hand feels what the eye sees.
///
/// Factors keep to 0.05..20. Scaling goes by the distance from the centre on whichever side; an
/// axis that is stretched through the centre stays at the least factor, nothing is mirrored.
class TransformDrag {
 public:
  static constexpr double kLeastScale = 0.05;

  TransformDrag() = default;
  /// `least_scale`: no factor below this, for what would become shorter than a segment may be.
  TransformDrag(TransformKind kind, Point centre, Point grab,
                double least_scale = kLeastScale) noexcept;

  /// The pen is here now. Constrained: moves along one axis, turns in steps of kTurnStepRad; kScale
  /// stretches both axes, kStretch only the one along which it was grabbed farther out.
  void update(Point pen, bool constrained) noexcept;

  [[nodiscard]] const Affine& map() const noexcept { return map_; }
  [[nodiscard]] bool is_identity() const noexcept { return map_ == Affine{}; }
  /// By which widths grow: the root of the area's factor.
  [[nodiscard]] double width_factor() const noexcept;
  /// What it is now, after the constraint: for the force, the label and the name of the edit.
  [[nodiscard]] TransformKind kind() const noexcept { return now_; }
  [[nodiscard]] Point centre() const noexcept { return centre_; }
  [[nodiscard]] Point grab() const noexcept { return grab_; }
  /// Whether the last update was constrained.
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
  double least_scale_ = kLeastScale;
  bool constrained_ = false;
  double turn_rad_ = 0.0;  // unwrapped, unconstrained
  Affine map_;
  Vec way_;
  double shown_turn_rad_ = 0.0;
  double factor_x_ = 1.0, factor_y_ = 1.0;
};

/// An axis is not stretched from nearer than this to the centre.
inline constexpr double kNoAxisMm = 0.5;

/// Whether a stretch of this kind acts along x, along y, when grabbed there.
bool stretches_x(TransformKind kind, Point centre, Point grab) noexcept;
bool stretches_y(TransformKind kind, Point centre, Point grab) noexcept;

}  // namespace felt
