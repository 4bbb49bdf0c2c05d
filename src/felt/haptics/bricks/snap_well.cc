#include "felt/haptics/bricks/snap_well.h"

#include <algorithm>

#include "felt/haptics/pen_sample.h"

namespace felt {
namespace {

/// The lengths of a shape, adjusted so that 0 <= core <= rim_start <= radius.
struct Lengths {
  double core;
  double rim_start;
  double radius;
};

Lengths lengths(const WellShape& shape) noexcept {
  const double radius = std::max(shape.radius_mm, 0.0);
  const double core = std::clamp(shape.core_mm, 0.0, radius);
  return {core, std::max(core, radius - std::max(shape.rim_mm, 0.0)), radius};
}

}  // namespace

double WellShape::force_at_n(double distance_mm) const noexcept {
  const auto [core, rim_start, radius] = lengths(*this);
  if (!(distance_mm > 0.0) || distance_mm >= radius) return 0.0;
  if (form == LawForm::kPaper) return force_n * kEditLaw.level_n(distance_mm);
  if (distance_mm < core) return force_n * (distance_mm / core);
  return force_n * damped_share(distance_mm);
}

double WellShape::damped_share(double distance_mm) const noexcept {
  const auto [core, rim_start, radius] = lengths(*this);
  if (distance_mm <= rim_start) return 1.0;
  if (distance_mm >= radius) return 0.0;
  const double x = (distance_mm - rim_start) / (radius - rim_start);
  return 1.0 - x * x * (3.0 - 2.0 * x);
}

double WellShape::potential_mj(double distance_mm) const noexcept {
  const auto [core, rim_start, radius] = lengths(*this);
  const double d = std::clamp(distance_mm, 0.0, radius);
  if (form == LawForm::kPaper) {
    return ForceLaw{.gain = force_n, .form = LawForm::kPaper}.potential_mj(d);
  }
  if (d < core) return 0.5 * force_n * d * d / core;
  double energy = force_n * (0.5 * core + (std::min(d, rim_start) - core));
  if (d > rim_start) {
    const double rim = radius - rim_start;
    const double x = (d - rim_start) / rim;
    energy += force_n * rim * (x - x * x * x + 0.5 * x * x * x * x);
  }
  return energy;
}

double WellShape::core_slope_n_per_m() const noexcept {
  const double core = lengths(*this).core;
  return core > 0.0 && form == LawForm::kFelt ? 1e3 * force_n / core : 0.0;
}

WellShape WellShape::softened(double share) const noexcept {
  const auto [core, rim_start, radius] = lengths(*this);
  WellShape soft = *this;
  if (form == LawForm::kPaper) return soft;
  if (!(core > 0.0)) {
    soft.force_n *= share;
    return soft;
  }
  soft.core_mm = share * rim_start > core ? core / share : rim_start;
  soft.force_n *= share * soft.core_mm / core;
  return soft;
}

WellShape WellShape::printed(double gain) const noexcept {
  WellShape shape = *this;
  shape.form = LawForm::kPaper;
  shape.force_n = force_n > 0.0 ? gain : 0.0;
  shape.damping_n_s_per_m = 0.0;
  return shape;
}

SnapWells::SnapWells(std::span<const Point> targets, const WellShape& shape) noexcept
    : shape_(shape), count_(std::min(targets.size(), kMax)) {
  std::copy_n(targets.begin(), count_, targets_.begin());
}

Force SnapWells::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const bool is_alone = count_ == 1;
  const double share = memory.scale.lateral;
  // The share is squared for the same reason as in Tether: the core has a long range.
  const WellShape shape = is_alone ? shape_.softened(share * share) : shape_;
  const double scale = is_alone ? 1.0 : share;
  Vec sum{};
  double damped = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const Vec to_target = targets_[i] - on_page(sample.position);
    const double distance = norm(to_target);
    if (distance > 1e-12) sum += (shape.force_at_n(distance) / distance) * to_target;
    damped = std::max(damped, shape.damped_share(distance));
  }
  if (shape_.force_n > 0.0) {
    sum -=
        1e-3 * (is_alone ? share : 1.0) * damped * shape.damping_n_s_per_m * known_velocity(sample);
  }
  const Force force = scale * Force{sum.x, sum.y, 0.0};
  memory.terms.add("snap", force);
  return force;
}

Slopes SnapWells::slopes() const noexcept {
  double steepest = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    double slope = shape_.core_slope_n_per_m();
    for (std::size_t j = 0; j < count_; ++j) {
      // If the pen is nearest to target i, its distance d from any other target is at least half
      // the distance between the two targets. The force of that target turns with the pen by at
      // most F/d.
      const double away = 0.5 * distance(targets_[i], targets_[j]);
      if (j == i || away >= shape_.radius_mm) continue;
      slope += away > shape_.core_mm ? 1e3 * shape_.force_n / away : shape_.core_slope_n_per_m();
    }
    steepest = std::max(steepest, slope);
  }
  return {.lateral_n_per_m = steepest};
}

}  // namespace felt
