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

constexpr double kClickS = 0.03;
constexpr double kClickMmPerS = 10.0;  // speed at which the brake of a click has half of its force
constexpr double kEdgeDampMm = 0.3;    // the damping of an edge begins over this distance

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

GuideLaw GuideLaw::line(double strength, const GuideSpring& spring) noexcept {
  GuideLaw law = groove(strength);
  law.well.core_mm = std::min(law.well.core_mm, 800.0 / std::max(spring.n_per_m, 1.0));
  law.well.damping_n_s_per_m = strength * spring.damping_n_s_per_m;
  return law;
}

GuideLaw GuideLaw::tick(double strength, double radius_mm) noexcept {
  const double radius = std::clamp(radius_mm, 0.0, kTickMm);
  return {.well = {.radius_mm = radius,
                   .core_mm = 0.5 * radius,
                   .rim_mm = 0.4 * radius,
                   .force_n = kTickN * strength * radius / kTickMm,
                   .damping_n_s_per_m = strength},
          .rise_s = 0.03};
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
  if (count == 1) return {.distance_mm = std::sqrt(nearest), .offset = pen - piece_.points[0]};
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

Point Guide::nearest(Point pen) const noexcept {
  return pen - near(pen).offset;
}

double Guide::pull_n(Point pen) const noexcept {
  const double reach = reach_mm(near(pen));
  const double pull = law_.well.force_at_n(reach - law_.dead_mm);
  return piece_.gain * (std::isfinite(pull) ? pull : 0.0);
}

/// Returns the distance that counts for the force: D, or, at an edge, how far the pen has come from
/// the free side; 0 on the free side.
double Guide::reach_mm(const Near& near) const noexcept {
  if (!law_.is_edge) return near.distance_mm;
  if (piece_.count == 0) return 0.0;
  const double free_mm = dot(near.offset, normalized(perp(near.along))) * piece_.free_side;
  return std::max(0.0, GuideLaw::kEdgeMm - free_mm);
}

/// Returns the share of the force that acts while the pen is held, and updates it for this tick.
double Guide::held_share(bool is_down, double reach_mm, ForceMemory& memory) const noexcept {
  GuideHold& hold = memory.guide;
  if (hold.number != piece_.hold) hold = {.number = piece_.hold};
  const bool keeps = hold.is_held || law_.pushes_away;
  const double limit = keeps          ? law_.well.radius_mm
                       : law_.is_edge ? std::numeric_limits<double>::min()
                                      : capture_mm(law_.well);
  hold.is_held = is_down && reach_mm < limit;
  hold.share += hold.is_held ? memory.dt_s / std::max(law_.rise_s, 1e-3) : -memory.dt_s / kFallS;
  hold.share = std::clamp(hold.share, 0.0, 1.0);
  return hold.share;
}

Vec Guide::across_n(const Near& near, Vec velocity, double share) const noexcept {
  if (law_.is_edge) return edge_n(near, velocity, share);
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
  const Vec across = piece_.count == 1 ? velocity : dot(velocity, normal) * normal;
  return -pull * near.offset - damping * across;
}

Vec Guide::edge_n(const Near& near, Vec velocity, double share) const noexcept {
  const WellShape well = law_.well.softened(share * share);
  const Vec out = piece_.free_side * normalized(perp(near.along));
  const double reach = reach_mm(near);
  const double damping = 1e-3 * share * well.damping_n_s_per_m * well.damped_share(reach) *
                         std::min(1.0, reach / kEdgeDampMm);
  return (well.force_at_n(reach) - damping * dot(velocity, out)) * out;
}

/// Returns the brake of a click, which fades while the share of the force grows from zero.
Vec Guide::click_n(Vec velocity, double share) const noexcept {
  const double left = 1.0 - share * std::max(law_.rise_s, 1e-3) / kClickS;
  if (!(law_.click_n > 0.0) || !(left > 0.0)) return {};
  return -law_.click_n * left / (norm(velocity) + kClickMmPerS) * velocity;
}

Vec Guide::lead_n(const Near& near, Vec velocity) const noexcept {
  const double lag = near.speed_mm_per_s - dot(velocity, near.along);
  const double push = std::clamp(1e-3 * law_.lead_n_s_per_m * lag, 0.0, law_.lead_n);
  return push * law_.well.damped_share(near.distance_mm) * near.along;
}

Force Guide::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  Force force;
  const Near near = this->near(on_page(sample.position));
  const double reach = reach_mm(near);
  const double held = held_share(in_contact(sample), reach, memory);
  const double share = piece_.gain * held;
  // On the free side of an edge, reach is 0.
  const bool acts = !law_.is_edge || reach > 0.0;
  if (share > 0.0 && acts && reach < law_.well.radius_mm) {
    const Vec velocity = known_velocity(sample);
    const Vec sum = across_n(near, velocity, memory.scale.lateral) + lead_n(near, velocity);
    const Vec click = memory.guide.is_held ? piece_.gain * click_n(velocity, held) : Vec{};
    const Vec bounded = at_most(share * at_most(sum, law_.well.force_n) + click, law_.well.force_n);
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
