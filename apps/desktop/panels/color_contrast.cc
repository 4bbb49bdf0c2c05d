#include "desktop/panels/color_contrast.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace felt::desktop {
namespace {

// Above that of black ink on the blackboard, 2.1.
constexpr double kHiddenContrast = 2.25;
constexpr int kHiddenStep = 72;

double luminance_of(Rgba color) {
  const auto linear = [](std::uint8_t part) {
    const double c = part / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

}  // namespace

double contrast_of(Rgba a, Rgba b) {
  const double one = luminance_of(a), two = luminance_of(b);
  return (std::max(one, two) + 0.05) / (std::min(one, two) + 0.05);
}

Rgba seen_on(Rgba color, Rgba ground) {
  const auto mix = [&color](std::uint8_t over, std::uint8_t under) {
    const double share = color.a / 255.0;
    return static_cast<std::uint8_t>(std::lround(share * over + (1.0 - share) * under));
  };
  return {mix(color.r, ground.r), mix(color.g, ground.g), mix(color.b, ground.b)};
}

Rgba seen_paper(Rgba paper) {
  return seen_on(paper, {255, 255, 255});
}

bool is_hard_to_see(Rgba ink, Rgba paper) {
  const Rgba ground = seen_paper(paper), seen = seen_on(ink, ground);
  if (contrast_of(seen, ground) >= kHiddenContrast) return false;
  const int most = std::max(
      {std::abs(seen.r - ground.r), std::abs(seen.g - ground.g), std::abs(seen.b - ground.b)});
  return most <= kHiddenStep;
}

Rgba visible_instead_of(Rgba ink, Rgba usual, Rgba paper) {
  const Rgba ground = seen_paper(paper), black{}, white{255, 255, 255};
  const Rgba strong = contrast_of(black, ground) >= contrast_of(white, ground) ? black : white;
  for (Rgba color : {usual, strong}) {
    color.a = ink.a;
    if (contrast_of(seen_on(color, ground), ground) >= kFaintContrast) return color;
  }
  return strong;
}

}  // namespace felt::desktop
