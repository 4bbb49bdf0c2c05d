#include "felt/haptics/bricks/tether.h"

#include <algorithm>
#include <cmath>

#include "felt/haptics/pen_sample.h"

namespace felt {
namespace {

constexpr double kDampingNsPerM = 1.0;
constexpr double kCentreMm = 5.0;
constexpr double kNoArmMm = 1e-9;
constexpr double kMinScale = 0.05;
constexpr double kMaxScale = 20.0;

/// Returns the radius around the centre within which the forces of rotation and scale fade. At this
/// radius F/r, the slope of a full force that turns with the arm, is 2/3 of Kcap. The radius is 5
/// mm at 300 N/m, and larger for a softened force law.
double fade_radius_mm(const ForceLaw& law) noexcept {
  constexpr double kShareOfCap = 2.0 / 3.0;
  return std::max(kCentreMm, 1e3 * law.max_n / (kShareOfCap * std::max(law.cap_n_per_m, 1e-3)));
}

double centre_fade(const ForceLaw& law, double radius_mm) noexcept {
  return std::min(1.0, radius_mm / fade_radius_mm(law));
}

}  // namespace

double unwrapped_turn_rad(Vec first_arm, Vec arm, double last_rad) noexcept {
  if (norm(arm) < kNoArmMm || norm(first_arm) < kNoArmMm) return last_rad;
  const double turn = std::atan2(cross(first_arm, arm), dot(first_arm, arm));
  return last_rad + std::remainder(turn - last_rad, 2.0 * 3.14159265358979323846);
}

double scale_factor(Vec first_arm, Vec arm) noexcept {
  const double first = norm(first_arm);
  return first < kNoArmMm ? 1.0 : std::clamp(norm(arm) / first, kMinScale, kMaxScale);
}

Tether Tether::translation(Point grab, int anchors) noexcept {
  Tether tether;
  tether.kind_ = anchors > 0 ? Kind::kTranslation : Kind::kNone;
  tether.grab_ = grab;
  tether.sum_ = anchors;
  return tether;
}

Tether Tether::rotation(Point centre, Point grab, double sum_of_radii_mm,
                        std::uint32_t gesture) noexcept {
  Tether tether;
  tether.kind_ = sum_of_radii_mm > 0.0 ? Kind::kRotation : Kind::kNone;
  tether.centre_ = centre;
  tether.grab_ = grab;
  tether.sum_ = sum_of_radii_mm;
  tether.gesture_ = gesture;
  return tether;
}

Tether Tether::scale(Point centre, Point grab, double sum_of_radii_mm) noexcept {
  Tether tether = rotation(centre, grab, sum_of_radii_mm, 0);
  if (tether.kind_ != Kind::kNone) tether.kind_ = Kind::kScale;
  return tether;
}

Tether Tether::constrained() const noexcept {
  Tether tether = *this;
  tether.constrained_ = true;
  return tether;
}

Tether Tether::with_min_scale(double factor) const noexcept {
  Tether tether = *this;
  tether.min_scale_ = factor;
  return tether;
}

Tether Tether::with_law(const ForceLaw& law) const noexcept {
  Tether tether = *this;
  tether.law_ = law;
  return tether;
}

Tether Tether::printed(Point middle) const noexcept {
  Tether tether = *this;
  tether.law_.form = LawForm::kPaper;
  tether.middle_ = middle;
  return tether;
}

double Tether::size_n(double sum_mm, double way_mm) const noexcept {
  return law_.gain * std::min(law_.level_n(sum_mm), 1e-3 * law_.cap_n_per_m * way_mm);
}

Vec Tether::translation_pull(Point pen) const noexcept {
  Vec moved = pen - grab_;
  double limit_n = law_.gain * law_.max_n;
  if (constrained_) {
    const double x = std::abs(moved.x), y = std::abs(moved.y);
    (x >= y ? moved.y : moved.x) = 0.0;
    const double from_diagonal = std::abs(x - y) / std::sqrt(2.0);
    limit_n = std::min(limit_n, 1e-3 * law_.gain * law_.cap_n_per_m * from_diagonal);
  }
  const double way = norm(moved);
  if (way < kNoArmMm) return {};
  return -std::min(limit_n, size_n(sum_ * way, way)) / way * moved;
}

double Tether::turn_size_n(double turn_rad, double radius_mm) const noexcept {
  // Inside the fade radius, uses the distance along its rim. th/sqrt(1 + th^2) replaces th because
  // the force also turns with the arm, and this adds a slope of F/r. Both slopes together stay
  // within Kcap, because (1 + th^2)^-3 + th^2/(1 + th^2) <= 1.
  const double way =
      std::max(radius_mm, fade_radius_mm(law_)) * turn_rad / std::sqrt(1.0 + turn_rad * turn_rad);
  return centre_fade(law_, radius_mm) * size_n(sum_ * turn_rad, way);
}

double Tether::stepped_size_n(double turn_rad, double radius_mm) const noexcept {
  const double step = std::round(turn_rad / kTurnStepRad);
  if (step < 1.0) return 0.0;
  const double here = turn_size_n(step * kTurnStepRad, radius_mm);
  const double last = turn_size_n((step - 1.0) * kTurnStepRad, radius_mm);
  // As above, the slope may be at most Kcap minus the slope from the turning of the force.
  const double slope = 1e-3 * law_.gain * law_.cap_n_per_m * centre_fade(law_, radius_mm) /
                       std::sqrt(1.0 + turn_rad * turn_rad);
  const double since_mm =
      std::max(radius_mm, fade_radius_mm(law_)) * (turn_rad - (step - 0.5) * kTurnStepRad);
  return std::min(here, last + slope * since_mm);
}

/// Updates the angle of the gesture, which counts full turns.
double Tether::follow_turn(Vec arm, ForceMemory& memory) const noexcept {
  if (!memory.turn_is_set || memory.turn_gesture != gesture_) {
    memory.turn_rad = 0.0;
    memory.turn_gesture = gesture_;
    memory.turn_is_set = true;
  }
  memory.turn_rad = unwrapped_turn_rad(grab_ - centre_, arm, memory.turn_rad);
  return memory.turn_rad;
}

Vec Tether::rotation_pull(Point pen, ForceMemory& memory) const noexcept {
  const Vec arm = pen - centre_;
  const double radius = norm(arm);
  const double turned = follow_turn(arm, memory);
  if (radius < kNoArmMm) return {};
  const double turn = std::abs(turned);
  const double size = constrained_ ? stepped_size_n(turn, radius) : turn_size_n(turn, radius);
  return (turned > 0.0 ? -size : size) / radius * perp(arm);
}

Vec Tether::scale_pull(Point pen) const noexcept {
  const Vec arm = pen - centre_;
  const double radius = norm(arm);
  if (radius < kNoArmMm) return {};
  const double s = std::max(min_scale_, scale_factor(grab_ - centre_, arm));
  const double way = norm(grab_ - centre_) * (1.0 - std::min(s, 1.0 / s));
  const double size = centre_fade(law_, radius) * size_n(sum_ * std::abs(std::log(s)), way);
  return (s > 1.0 ? -size : size) / radius * arm;
}

Vec Tether::printed_pull(Point pen, ForceMemory& memory) const noexcept {
  Vec along{};
  double sum_mm = 0.0;
  switch (kind_) {
    case Kind::kNone:
      return {};
    case Kind::kTranslation:
      along = pen - middle_;
      sum_mm = sum_ * norm(along);
      break;
    case Kind::kRotation: {
      const double turned = follow_turn(pen - centre_, memory);
      along = std::copysign(1.0, turned) * perp(pen - centre_);
      sum_mm = sum_ * 2.0 * std::abs(std::sin(0.5 * turned));
      break;
    }
    case Kind::kScale: {
      const double s = std::max(min_scale_, scale_factor(grab_ - centre_, pen - centre_));
      along = std::copysign(1.0, s - 1.0) * (pen - centre_);
      sum_mm = sum_ * std::abs(s - 1.0);
      break;
    }
  }
  const double length = norm(along);
  if (length < kNoArmMm) return {};
  return -law_.force_n(sum_mm) / length * along;
}

Force Tether::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  if (law_.form == LawForm::kPaper && kind_ != Kind::kNone) {
    const Vec pull = printed_pull(on_page(sample.position), memory);
    const Force force{pull.x, pull.y, 0.0};
    memory.terms.add("tether", force);
    return force;
  }
  // The share of the stiffness budget softens the spring but keeps the force level of the force
  // law. The share is squared because the spring of many lines has a long range, and a slow loop
  // can render such a spring only if it is softer than its share.
  const double share = memory.scale.lateral;
  const Tether softened = with_law(law_.softened(share * share));
  const Point pen = on_page(sample.position);
  Vec pull{};
  switch (kind_) {
    case Kind::kNone:
      return {};
    case Kind::kTranslation:
      pull = softened.translation_pull(pen);
      break;
    case Kind::kRotation:
      pull = softened.rotation_pull(pen, memory);
      break;
    case Kind::kScale:
      pull = softened.scale_pull(pen);
      break;
  }
  pull -= 1e-3 * share * kDampingNsPerM * known_velocity(sample);
  const Force force{pull.x, pull.y, 0.0};
  memory.terms.add("tether", force);
  return force;
}

Slopes Tether::slopes() const noexcept {
  return {.lateral_n_per_m = kind_ == Kind::kNone ? 0.0 : law_.gain * law_.cap_n_per_m};
}

}  // namespace felt
