#include "felt/haptics/bricks/guide.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace felt {
namespace {

constexpr double kRootTau = 2.5066282746310002;  // sqrt(2 pi)

// Largest stiffness between two parts of the path that both push the pen away, divided by the
// force; 1/m. Measured on random paths (guide_test.cc).
constexpr double kAwaySlopePerM = 900.0;

/// S of docs/design/forces.md.
double smooth_fall(double x) noexcept {
  const double t = std::clamp(x, 0.0, 1.0);
  return 1.0 - t * t * (3.0 - 2.0 * t);
}

double capture_mm(const WellShape& well) noexcept {
  return well.radius_mm - well.rim_mm;
}

Vec at_most(Vec v, double longest) noexcept {
  const double length = norm(v);
  return length > longest ? (longest / length) * v : v;
}

}  // namespace

GuideLaw GuideLaw::groove(double strength) noexcept {
  const double force_n = 0.8 * strength;
  return {.well = {.radius_mm = 5.0,
                   .core_mm = 0.8 / 0.3,
                   .rim_mm = 2.0,
                   .force_n = force_n,
                   .damping_n_s_per_m = strength}};
}

GuideLaw GuideLaw::error_amplifying(double strength) noexcept {
  return {.well = {.radius_mm = 6.0,
                   .core_mm = 3.0,
                   .rim_mm = 3.0,
                   .force_n = 0.2 * strength,
                   .damping_n_s_per_m = strength},
          .pushes_away = true,
          .blur_mm = 1.5,
          .window_mm = 5.0};
}

GuideLaw GuideLaw::teacher(double strength) noexcept {
  GuideLaw law = groove(strength);
  law.lead_n = 0.2 * strength;
  law.lead_n_s_per_m = 2.0 * strength;
  return law;
}

double GuideLaw::potential_mj(double distance_mm) const noexcept {
  const double energy = well.potential_mj(std::max(0.0, distance_mm - dead_mm));
  return pushes_away ? -energy : energy;
}

double Guide::window(std::size_t i) const noexcept {
  const double along = std::fabs(static_cast<double>(i) * piece_.spacing_mm - piece_.at_mm);
  return smooth_fall(2.0 * along / law_.window_mm - 1.0);
}

Guide::Near Guide::near(Point pen) const noexcept {
  // The smallest distance is subtracted from all exponents, so that far points do not all become 0.
  double nearest = std::numeric_limits<double>::infinity();
  const std::size_t count = std::min(piece_.count, GuidePiece::kPoints);
  for (std::size_t i = 0; i < count; ++i) {
    if (window(i) > 0.0) nearest = std::min(nearest, distance_squared(piece_.points[i], pen));
  }
  if (!(nearest < 1e6)) return {.distance_mm = std::numeric_limits<double>::infinity()};
  const double per_mm2 = 0.5 / (law_.blur_mm * law_.blur_mm);
  double sum = 0.0;
  Near near{.distance_mm = 0.0};
  for (std::size_t i = 0; i < count; ++i) {
    const Vec offset = pen - piece_.points[i];
    const double weight = window(i) * std::exp(per_mm2 * (nearest - norm_squared(offset)));
    const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, count - 1);
    sum += weight;
    near.offset += weight * offset;
    near.along += weight * normalized(piece_.points[after] - piece_.points[before]);
    near.speed_mm_per_s += weight * static_cast<double>(piece_.speeds_mm_per_s[i]);
  }
  if (!(sum > 0.0)) return {.distance_mm = std::numeric_limits<double>::infinity()};
  near.offset = near.offset / sum;
  near.along = near.along / sum;
  near.speed_mm_per_s /= sum;
  const double density = sum * piece_.spacing_mm / (law_.blur_mm * kRootTau);
  near.distance_mm = std::sqrt(std::max(0.0, nearest - std::log(density) / per_mm2));
  return near;
}

double Guide::distance_mm(Point pen) const noexcept {
  return near(pen).distance_mm;
}

/// Returns the share of the force that acts while the pen is held, and updates it for this tick.
double Guide::held_share(bool is_down, double distance_mm, ForceMemory& memory) const noexcept {
  GuideHold& hold = memory.guide;
  if (hold.number != piece_.hold) hold = {.number = piece_.hold};
  const bool keeps = hold.is_held || law_.pushes_away;
  hold.is_held = is_down && distance_mm < (keeps ? law_.well.radius_mm : capture_mm(law_.well));
  hold.share += hold.is_held ? memory.dt_s / kRiseS : -memory.dt_s / kFallS;
  hold.share = std::clamp(hold.share, 0.0, 1.0);
  return hold.share;
}

Vec Guide::across_n(const Near& near, Vec velocity, double share) const noexcept {
  // The share of the stiffness budget is squared for the same reason as in SnapWells.
  const WellShape well = law_.pushes_away ? law_.well : law_.well.softened(share * share);
  // On the path, f(D)/D is the slope of the core, unless there is no force near the path.
  const double away = near.distance_mm - law_.dead_mm;
  double pull = away > 0.0 ? well.force_at_n(away) / near.distance_mm : 0.0;
  if (near.distance_mm < 1e-9 && law_.dead_mm <= 0.0) pull = 1e-3 * well.core_slope_n_per_m();
  if (law_.pushes_away) pull *= -share;
  const Vec normal = perp(near.along);
  const double damping =
      1e-3 * share * well.damping_n_s_per_m * well.damped_share(near.distance_mm);
  return -pull * near.offset - damping * dot(velocity, normal) * normal;
}

Vec Guide::lead_n(const Near& near, Vec velocity) const noexcept {
  const double lag = near.speed_mm_per_s - dot(velocity, near.along);
  const double push = std::clamp(1e-3 * law_.lead_n_s_per_m * lag, 0.0, law_.lead_n);
  return push * law_.well.damped_share(near.distance_mm) * near.along;
}

Force Guide::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  Force force;
  const Near near = this->near(on_page(sample.position));
  const double share = piece_.gain * held_share(in_contact(sample), near.distance_mm, memory);
  if (share > 0.0 && near.distance_mm < law_.well.radius_mm) {
    const Vec velocity = known_velocity(sample);
    const Vec sum = across_n(near, velocity, memory.scale.lateral) + lead_n(near, velocity);
    const Vec bounded = share * at_most(sum, law_.well.force_n);
    force = {bounded.x, bounded.y, 0.0};
  }
  memory.terms.add("guide", force);
  return force;
}

Slopes Guide::slopes() const noexcept {
  if (piece_.count == 0) return {};
  if (!law_.pushes_away) return {.lateral_n_per_m = piece_.gain * law_.well.core_slope_n_per_m()};
  const double rim = 1.5e3 / std::max(law_.well.rim_mm, 1e-3);
  return {.lateral_n_per_m = piece_.gain * law_.well.force_n * std::max(rim, kAwaySlopePerM)};
}

}  // namespace felt
