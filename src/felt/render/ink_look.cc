#include "felt/render/ink_look.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "felt/render/dust.h"

namespace felt {
namespace {

/// At the rim of a soft edge the cut is this much higher than that of the lightest push, so that no
/// grain reaches it.
constexpr double kOutOfReach = 3.5;

constexpr int kHairs = 44;  // number of hairs of a dry brush

double smoothstep(double x) noexcept {
  const double y = std::clamp(x, 0.0, 1.0);
  return y * y * (3.0 - 2.0 * y);
}

/// Returns a pseudo-random number in -1..1 that is the same on every machine.
double noise(std::uint32_t n) noexcept {
  n = (n ^ (n >> 16U)) * 0x7FEB352DU;
  n = (n ^ (n >> 15U)) * 0x846CA68BU;
  return static_cast<double>(n ^ (n >> 16U)) / 2147483648.0 - 1.0;
}

/// Returns the height of the hairs at x in 0..1 across the line, about 1 RMS. The hairs have
/// different thicknesses.
double hair(double x) noexcept {
  const auto smooth = [](double at, std::uint32_t seed) {
    const double f = at - std::floor(at);
    const auto k = seed + static_cast<std::uint32_t>(std::floor(at));
    return noise(k) + (noise(k + 1) - noise(k)) * smoothstep(f);
  };
  return 1.35 * (smooth(kHairs * x, 1000U) + 0.8 * smooth(0.37 * kHairs * x, 2000U));
}

/// Adds the relief of the tip's hairs to `count` pixels.
inline void add_hairs(const InkLook& look, const std::int32_t* packed, int count, int* reliefs) {
  for (int i = 0; i < count; ++i) {
    reliefs[i] += look.hair_weight * look.hairs[PressureMap::across_of(packed[i])];
  }
}

/// Reduces the coverage of `count` pixels by the part that their relief and push leave bare.
inline void shade(const InkLook& look, const std::int32_t* packed, const int* reliefs, int count,
                  std::uint8_t* alpha) {
  for (int i = 0; i < count; ++i) {
    const int level = std::clamp((reliefs[i] + 32768 + 128) / 256, 0, InkLook::kReliefs - 1);
    unsigned seen = look.alphas[PressureMap::row_of(packed[i]) * InkLook::kReliefs +
                                static_cast<std::size_t>(level)];
    if (look.has_rim) {
      seen = std::min(255U, (seen * look.rim[PressureMap::rim_of(packed[i])]) >> 8U);
    }
    const unsigned product = seen * alpha[i] + 128U;
    alpha[i] = static_cast<std::uint8_t>((product + (product >> 8U)) >> 8U);
  }
}

/// The visits of one pixel: how much ink each leaves, 0..1, and where it is along the path, in
/// widths.
struct VisitInk {
  int count = 0;
  float ink[VisitMap::kMax];
  float travel[VisitMap::kMax];

  /// Adds a visit; keeps the one with the most ink first.
  void add(float more, float at) noexcept {
    int n = count++;
    for (; n > 0 && ink[n - 1] < more; --n) {
      ink[n] = ink[n - 1];
      travel[n] = travel[n - 1];
    }
    ink[n] = more;
    travel[n] = at;
  }
  /// Returns the ink of all visits. A visit counts less if one with more ink is near along the
  /// path (VisitMap::separate), as far as that one counts itself. Near visits and those of the same
  /// ink change places without a jump.
  [[nodiscard]] float blended(float ring) const noexcept {
    float counts[VisitMap::kMax];
    float bare = 1.0F;
    for (int n = 0; n < count; ++n) {
      counts[n] = 1.0F;
      for (int m = 0; m < n; ++m) {
        float apart = std::abs(travel[n] - travel[m]);
        if (ring > 0.0F) apart = std::min(apart, ring - apart);
        if (apart >= VisitMap::kOtherVisit) continue;
        counts[n] *= 1.0F - (1.0F - VisitMap::separate(apart)) * counts[m];
      }
      bare *= 1.0F - counts[n] * ink[n];
    }
    return 1.0F - bare;
  }
};

/// Returns how much of the ink of a visit is visible, 0..1, for the relief without hairs.
float visit_ink(const InkLook& look, std::int32_t value, int relief) noexcept {
  if (look.hair_weight > 0) relief += look.hair_weight * look.hairs[PressureMap::across_of(value)];
  const int level = std::clamp((relief + 32768 + 128) / 256, 0, InkLook::kReliefs - 1);
  const std::uint8_t seen =
      look.alphas[PressureMap::row_of(value) * InkLook::kReliefs + static_cast<std::size_t>(level)];
  constexpr float kPerStep = 1.0F / (255.0F * VisitMap::kCoverSteps);
  return static_cast<float>(seen * VisitMap::cover_of(value)) * kPerStep;
}

}  // namespace

ReliefWeights relief_weights(const MediumLook& look) noexcept {
  const double n =
      std::sqrt(look.grain * look.grain + look.crumb * look.crumb + look.streaks * look.streaks);
  if (!(n > 0.0)) return {};
  return {look.grain / n, look.crumb / n, look.streaks / n, std::min(1.0, n)};
}

double ink_alpha(const MediumLook& look, double wear, double push, double relief,
                 double blur) noexcept {
  const double tone = std::clamp(push, 0.0, 1.0);
  // Above 0 only within a soft edge.
  const double lost = std::clamp(push / PressureMap::kMinPush, 0.0, 1.0);
  const double cut = look.cut_light + (look.cut_heavy - look.cut_light) * tone + kOutOfReach * lost;
  const double height = 1.0 - wear * tone;
  const double per_rms = 0.5 / std::max(look.soft, 0.05);
  const auto seen_at = [&](double r) { return smoothstep(0.5 + (height * r - cut) * per_rms); };
  double seen = seen_at(relief);
  if (blur > 0.0) {  // a normal distribution, as seven points of equal weight
    constexpr std::array<double, 3> kAt{0.366, 0.792, 1.466};
    for (const double at : kAt) seen += seen_at(relief - at * blur) + seen_at(relief + at * blur);
    seen /= 7.0;
  }
  const double opacity = look.opacity_light + (look.opacity_heavy - look.opacity_light) * tone;
  return opacity * (1.0 - lost) * (1.0 - relief_weights(look).all * (1.0 - seen));
}

InkLook::InkLook(const MediumLook& look, double wear, const SeenRelief& seen) {
  const ReliefWeights weights = relief_weights(look);
  const auto of_256 = [](double weight) {
    return static_cast<int>(std::floor(256.0 * weight + 0.5));
  };
  const double surface_share = weights.surface * seen.depth;
  surface_weight = of_256(surface_share);
  crumb_weight = of_256(weights.crumb);
  hair_weight = of_256(weights.hairs);
  const double blur = std::sqrt(surface_share * surface_share * (1.0 - seen.kept) +
                                weights.crumb * weights.crumb * (1.0 - seen.crumb_kept));
  alphas.reserve(static_cast<std::size_t>(PressureMap::kRows) * kReliefs);
  constexpr int kMiddle = kReliefs / 2;
  for (int row = 0; row < PressureMap::kRows; ++row) {
    for (int level = 0; level < kReliefs; ++level) {
      const double relief = (level - kMiddle) / ReliefLevel::kPerRms;
      const double alpha =
          ink_alpha(look, wear, PressureMap::push_of_row(row), relief, blur > 0.05 ? blur : 0.0);
      alphas.push_back(static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(alpha, 0.0, 1.0))));
    }
  }
  edge = look.edge;
  has_rim = look.rim > 0.0;
  builds_up = look.grain > 0.0 && !has_rim;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const double rho = std::sqrt((static_cast<double>(i) + 0.5) / static_cast<double>(rim.size()));
    rim[i] = static_cast<std::uint16_t>(
        std::lround(256.0 * (1.0 + std::max(look.rim, 0.0) * smoothstep((rho - 0.55) / 0.35))));
  }
  for (std::size_t i = 0; i < hairs.size(); ++i) {
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(hairs.size());
    hairs[i] = static_cast<std::int16_t>(std::clamp(ReliefLevel::kPerRms * hair(x), -127.0, 127.0));
  }
}

InkShade::InkShade(const InkLook& look, const View& view) : look_(&look) {
  if (look.surface) surface_ = ReliefPlane(*look.surface, look.surface_tile_mm, view);
  if (look.crumb) crumb_ = ReliefPlane(*look.crumb, look.crumb_tile_mm, view, dust::kTurn);
}

/// Makes the pixels darker that have several visits, from their reliefs without hairs.
void InkShade::build_up(const VisitMap& visits, int x, int y, int count, const int* reliefs,
                        std::uint8_t* alphas) const noexcept {
  for (int i = 0; i < count; ++i) {
    if (!visits.is_searched(x + i, y)) continue;
    const VisitMap::Visits at = visits.visits(x + i, y);
    if (at.value(1) == 0) continue;
    VisitInk ink;
    for (int n = 0; n < VisitMap::kMax && at.value(n) != 0; ++n) {
      ink.add(visit_ink(*look_, at.value(n), reliefs[i]), at.travel(n));
    }
    const auto all = static_cast<std::uint8_t>(255.0F * ink.blended(visits.ring()) + 0.5F);
    alphas[i] = std::max(alphas[i], all);
  }
}

void InkShade::row(const PressureMap& pressure, const VisitMap& visits, int x, int y, int count,
                   std::uint8_t* alphas) const noexcept {
  constexpr int kPiece = 64;
  const InkLook& look = *look_;
  for (int from = 0; from < count; from += kPiece) {
    const int pixels = std::min(kPiece, count - from);
    const std::int32_t* packed = pressure.row(y) + (x + from - pressure.area().x0);
    int reliefs[kPiece];
    std::fill_n(reliefs, pixels, 0);  // only as many as needed: most runs are short
    if (!surface_.is_flat()) surface_.add_row(x + from, y, pixels, look.surface_weight, reliefs);
    if (!crumb_.is_flat()) crumb_.add_row(x + from, y, pixels, look.crumb_weight, reliefs);
    int smooth[kPiece];  // the reliefs without hairs
    if (!visits.is_empty()) std::copy_n(reliefs, pixels, smooth);
    if (look.hair_weight > 0) add_hairs(look, packed, pixels, reliefs);
    shade(look, packed, reliefs, pixels, alphas + from);
    if (!visits.is_empty()) build_up(visits, x + from, y, pixels, smooth, alphas + from);
  }
}

}  // namespace felt
