#include "felt/render/grain.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

// In RMS heights. Of a nearly normal distribution a third lies above the light cut, all but 1 %
// above the heavy one.
constexpr double kLightCut = 0.35;
constexpr double kHeavyCut = -2.6;
constexpr double kSoft = 0.9;  // half of the width of the edge of a grain

// The tooth: the same map again, so many times finer, and its share.
constexpr double kFiner = 4.3, kFinest = 8.3;
constexpr double kTooth = 0.65;

double smoothstep(double x) noexcept {
  const double y = std::clamp(x, 0.0, 1.0);
  return y * y * (3.0 - 2.0 * y);
}

}  // namespace

HeightField::Sample Grain::at(Point place) const noexcept {
  return field_ ? field_->at(place) : HeightField::Sample{};
}

bool Grain::is_smooth() const noexcept {
  return !field_ || !(field_->spec().rms_um > 0.0);
}

double Grain::relief(Point place) const noexcept {
  if (is_smooth()) return 0.0;
  const auto finer = [&](double by) { return field_->at({by * place.x, by * place.y}).height_mm; };
  const double h = at(place).height_mm + kTooth * (finer(kFiner) + finer(kFinest));
  const double rms_mm = 1e-3 * field_->spec().rms_um * std::sqrt(1.0 + 2.0 * kTooth * kTooth);
  return h / rms_mm;
}

double Grain::alpha(Point place, double pressure, double share) const noexcept {
  if (is_smooth()) return 1.0;
  const double cut = kLightCut + (kHeavyCut - kLightCut) * std::clamp(pressure, 0.0, 1.0);
  const double seen = smoothstep(0.5 + (relief(place) - cut) / (2.0 * kSoft));
  return 1.0 - share * (1.0 - seen);
}

double grain_share(std::string_view material) noexcept {
  if (material == "pencil" || material == "chalk") return 1.0;
  return material == "crayon" ? 0.8 : 0.0;
}

double pressure_of_width(double width_mm) noexcept {
  constexpr double kThinnest = 0.3, kBroadest = 6.0;
  return std::clamp((width_mm - kThinnest) / (kBroadest - kThinnest), 0.0, 1.0);
}

}  // namespace felt
