#include "felt/haptics/bricks/texture.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

/// The modulation leaves at least a fifth of the friction.
constexpr double kDeepest = 0.8;
/// Grain of less force cannot be felt: a wave has the amplitude sqrt(2) rms.
constexpr double kFeltRmsN = 0.02;

/// Returns about x if x is small; always within -1 and 1, with a slope of at most 1.
double bounded(double x) noexcept {
  return x / std::sqrt(1.0 + x * x);
}

}  // namespace

double texture_stiffness_limit_n_per_m(double period_s) noexcept {
  const double period_ms = std::max(1e3 * period_s, 0.2);
  return period_ms <= 1.0 ? 400.0 + 500.0 * (1.0 - period_ms) : 400.0 / period_ms;
}

Texture::Texture(const HeightField* field, const TextureOptions& options) noexcept
    : field_(field),
      law_(options.law),
      friction_(options.friction),
      bristle_n_per_m_(options.bristle_n_per_m),
      wear_(options.wear),
      firm_push_n_(options.firm_push_n) {
  if (field_ == nullptr || !(field_->max_height_mm() > 0.0)) return;
  const double limit_n_per_mm = 1e-3 * texture_stiffness_limit_n_per_m(options.period_s);
  const double strength = std::clamp(options.strength, 0.0, 1.0);
  if (law_ == TextureLaw::kGradient) {
    const double steepest = kMaxCountedN * field_->max_curvature_per_mm();
    gain_ = std::min(strength, limit_n_per_mm / steepest);
    stiffness_n_per_m_ = 1e3 * gain_ * steepest;
  } else if (friction_ > 0.0) {
    const double wave_number = 6.283185307179586 / field_->spec().wavelength_mm;
    const double steepest = kMaxCountedN * friction_ * field_->max_slope();
    gain_ = std::min(strength * wave_number / friction_, limit_n_per_mm / steepest);
    stiffness_n_per_m_ = 1e3 * gain_ * steepest;
    const double rms = kDeepest * bounded(gain_ / kDeepest * 1e-3 * field_->spec().rms_um);
    if (friction_ * kMaxCountedN * rms >= kFeltRmsN) {
      valley_ = std::min(1.0, 2.0 * rms);
    } else if (options.own_friction_n > 0.0) {
      gain_ = stiffness_n_per_m_ = 0.0;
    }
  }
}

double Texture::share_at(double speed_mm_per_s, double period_s) const noexcept {
  if (field_ == nullptr) return 0.0;
  const double of_limit =
      4.0 * period_s * std::abs(speed_mm_per_s) / field_->shortest_wavelength_mm();
  const double x = std::clamp(2.0 * of_limit - 1.0, 0.0, 1.0);
  return 1.0 - x * x * (3.0 - 2.0 * x);
}

double Texture::counted_push_n(double push_n) const noexcept {
  if (!(push_n > 0.0)) return 0.0;
  const double firmness = firm_push_n_ > 0.0 ? push_n / firm_push_n_ : 1.0;
  return std::min(push_n, kMaxCountedN) * relief_left(wear_, firmness);
}

Force Texture::operator()(const PenSample& sample, ForceMemory& memory) const noexcept {
  const double push = memory.normal_force_n;
  if (!(gain_ > 0.0) || !(push > 0.0)) return {};
  const double share = share_at(norm(in_plane(sample.velocity)), memory.period_s);
  const HeightField::Sample grain = field_->at(on_page(sample.position));
  const double counted = counted_push_n(push);
  if (law_ == TextureLaw::kFriction) {
    const double modulation = kDeepest * bounded(gain_ / kDeepest * grain.height_mm);
    memory.friction_factor = 1.0 + share * (counted / push) * modulation;
    const double above_valley = valley_ > 0.0 ? std::max(0.0, valley_ + modulation) : 0.0;
    memory.friction_grain = share * (counted / push) * above_valley;
    return {};
  }
  const Vec force = -share * gain_ * counted * memory.scale.lateral * grain.slope;
  memory.terms.add("texture", {force.x, force.y, 0.0});
  return {force.x, force.y, 0.0};
}

Slopes Texture::slopes() const noexcept {
  if (law_ == TextureLaw::kGradient) return {.lateral_n_per_m = stiffness_n_per_m_};
  return {.friction_n_per_m = std::max(0.0, stiffness_n_per_m_ - bristle_n_per_m_)};
}

}  // namespace felt
