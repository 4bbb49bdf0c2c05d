#include "felt/tools/transform/transform_drag.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "felt/haptics/bricks/tether.h"

namespace felt {
namespace {

template <class... Numbers>
std::string print(const char* format, Numbers... numbers) {
  std::array<char, 96> text{};
  std::snprintf(text.data(), text.size(), format, numbers...);
  return text.data();
}

}  // namespace

bool stretches_x(TransformKind kind, Point centre, Point grab) noexcept {
  return kind != TransformKind::kStretchY && std::fabs(grab.x - centre.x) >= kNoAxisMm;
}

bool stretches_y(TransformKind kind, Point centre, Point grab) noexcept {
  return kind != TransformKind::kStretchX && std::fabs(grab.y - centre.y) >= kNoAxisMm;
}

TransformDrag::TransformDrag(TransformKind kind, Point centre, Point grab,
                             double min_scale) noexcept
    : kind_(kind),
      now_(kind),
      centre_(centre),
      grab_(grab),
      fixed_(centre),
      min_scale_(std::clamp(min_scale, kMinScale, 1.0)) {}

void TransformDrag::update(Point pen, bool constrained, bool about_centre) noexcept {
  now_ = kind_;
  constrained_ = constrained;
  const bool turns = kind_ == TransformKind::kMove || kind_ == TransformKind::kRotate;
  fixed_ = turns || about_centre ? centre_ : opposite_.value_or(centre_);
  const Vec first = grab_ - fixed_;
  if (constrained && kind_ == TransformKind::kScale) now_ = TransformKind::kStretch;
  if (constrained && kind_ == TransformKind::kStretch) {
    now_ = std::fabs(first.x) >= std::fabs(first.y) ? TransformKind::kStretchX
                                                    : TransformKind::kStretchY;
  }
  // The turn is updated for every kind, so that full turns are still counted after a button changes
  // the kind.
  turn_rad_ = unwrapped_turn_rad(first, pen - fixed_, turn_rad_);
  switch (now_) {
    case TransformKind::kMove:
      return move(pen - grab_, constrained);
    case TransformKind::kRotate:
      return rotate(pen, constrained);
    case TransformKind::kScale: {
      const double factor = std::max(min_scale_, scale_factor(first, pen - fixed_));
      return scale(factor, factor);
    }
    case TransformKind::kStretch:
    case TransformKind::kStretchX:
    case TransformKind::kStretchY: {
      const bool x = stretches_x(now_, fixed_, grab_), y = stretches_y(now_, fixed_, grab_);
      return scale(x ? axis_factor(first.x, pen.x - fixed_.x) : 1.0,
                   y ? axis_factor(first.y, pen.y - fixed_.y) : 1.0);
    }
  }
}

void TransformDrag::move(Vec way, bool constrained) noexcept {
  if (constrained) (std::fabs(way.x) >= std::fabs(way.y) ? way.y : way.x) = 0.0;
  way_ = way;
  map_ = translation(way);
}

void TransformDrag::rotate(Point pen, bool constrained) noexcept {
  // If the pen is at the grab, the map must be exactly the identity, without a rounding error in
  // the angle.
  const double turn = pen == grab_ && std::fabs(turn_rad_) < 1e-12 ? 0.0 : turn_rad_;
  shown_turn_rad_ = constrained ? kTurnStepRad * std::round(turn / kTurnStepRad) : turn;
  map_ = shown_turn_rad_ == 0.0 ? Affine{} : rotation(shown_turn_rad_, fixed_);
}

void TransformDrag::scale(double factor_x, double factor_y) noexcept {
  factor_x_ = factor_x;
  factor_y_ = factor_y;
  map_ = factor_x == 1.0 && factor_y == 1.0 ? Affine{} : scaling(factor_x, factor_y, fixed_);
}

double TransformDrag::axis_factor(double grab, double pen) const noexcept {
  const double way = std::max(0.0, std::copysign(1.0, grab) * pen);
  return std::max(min_scale_, scale_factor({grab, 0.0}, {way, 0.0}));
}

double TransformDrag::width_factor() const noexcept {
  return std::sqrt(std::fabs(determinant(map_)));
}

std::string TransformDrag::text() const {
  switch (now_) {
    case TransformKind::kMove:
      return print("%.1f, %.1f mm", way_.x + 0.0, way_.y + 0.0);
    case TransformKind::kRotate:
      return print("%.1f deg", shown_turn_rad_ * 180.0 / std::numbers::pi);
    case TransformKind::kScale:
      return print("x %.2f", factor_x_);
    case TransformKind::kStretch:
    case TransformKind::kStretchX:
    case TransformKind::kStretchY:
      break;
  }
  return print("x %.2f, %.2f", factor_x_, factor_y_);
}

std::string TransformDrag::label() const {
  switch (now_) {
    case TransformKind::kMove:
      return "Move";
    case TransformKind::kRotate:
      return "Rotate";
    case TransformKind::kScale:
      return "Scale";
    case TransformKind::kStretch:
    case TransformKind::kStretchX:
    case TransformKind::kStretchY:
      break;
  }
  return "Stretch";
}

}  // namespace felt
