#include "felt/render/image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace felt {
namespace {

/// Returns c * a / 255, rounded to the nearest number.
std::uint8_t scaled(std::uint8_t c, std::uint8_t a) noexcept {
  return static_cast<std::uint8_t>((c * a + 127) / 255);
}

}  // namespace

void fill(Pixels target, PixelRect area, Rgba color) noexcept {
  const PixelRect part = area.intersected(target.rect());
  std::array<std::uint8_t, 4> pixel{scaled(color.r, color.a), scaled(color.g, color.a),
                                    scaled(color.b, color.a), color.a};
  if (target.order == PixelOrder::kBgra) std::swap(pixel[0], pixel[2]);
  for (int y = part.y0; y < part.y1; ++y) {
    std::uint8_t* p = target.data + y * target.stride + std::ptrdiff_t{4} * part.x0;
    for (int x = part.x0; x < part.x1; ++x) p = std::copy(pixel.begin(), pixel.end(), p);
  }
}

namespace {

/// Blends a pixel. `weight` is the opacity in 1 / 256. All levels are in units of 1 / 256 of a
/// level.
void blend_normal(const std::uint8_t* from, unsigned weight, std::uint8_t* to) noexcept {
  const unsigned left = 255U * 256U - from[3] * weight;
  for (std::ptrdiff_t k = 0; k < 4; ++k) {
    const unsigned level = from[k] * weight + (to[k] * left + 127U) / 255U;
    to[k] = static_cast<std::uint8_t>(std::min(255U, (level + 128U) / 256U));
  }
}

/// Multiplies a pixel. With c and a the premultiplied source, t and b the premultiplied target and
/// p the paper, the target becomes t (1 - a + c) + (1 - b) c p. Together with the paper, which the
/// target covers by a + b - a b, this is (t + (1 - b) p) (1 - a + c): the product of the target on
/// the paper and the source on white.
void blend_multiply(const std::uint8_t* from, unsigned weight, const std::array<unsigned, 3>& paper,
                    std::uint8_t* to) noexcept {
  const unsigned left = 255U * 256U - from[3] * weight, clear = 255U - to[3];
  const unsigned covered = from[3] * weight + (to[3] * left + 127U) / 255U;
  const unsigned alpha = std::min(255U, (covered + 128U) / 256U);
  for (std::size_t k = 0; k < 3; ++k) {
    const unsigned color = from[k] * weight, on_paper = (color * paper[k] + 127U) / 255U;
    const unsigned level = (to[k] * (left + color) + clear * on_paper + 127U) / 255U;
    to[k] = static_cast<std::uint8_t>(std::min(alpha, (level + 128U) / 256U));
  }
  to[3] = static_cast<std::uint8_t>(alpha);
}

}  // namespace

void blend(Pixels from, PixelRect area, double opacity, BlendMode mode, Rgba paper,
           Pixels target) noexcept {
  const PixelRect part = area.intersected(target.rect()).intersected(from.rect());
  const auto weight = static_cast<unsigned>(std::lround(std::clamp(opacity, 0.0, 1.0) * 256.0));
  std::array<unsigned, 3> levels{paper.r, paper.g, paper.b};
  if (target.order == PixelOrder::kBgra) std::swap(levels[0], levels[2]);
  for (int y = part.y0; y < part.y1; ++y) {
    const std::uint8_t* p = from.data + y * from.stride + std::ptrdiff_t{4} * part.x0;
    std::uint8_t* to = target.data + y * target.stride + std::ptrdiff_t{4} * part.x0;
    for (int x = part.x0; x < part.x1; ++x, p += 4, to += 4) {
      if (mode == BlendMode::kMultiply) {
        blend_multiply(p, weight, levels, to);
      } else {
        blend_normal(p, weight, to);
      }
    }
  }
}

Image::Image(int width, int height)
    : width_(width),
      height_(height),
      bytes_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4) {}

Result<Image> Image::create(int width, int height) {
  if (width <= 0 || height <= 0 || std::int64_t{width} * height > kMaxPixels) {
    return fail(ErrorCode::kLimitExceeded,
                "a picture of " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels is not between 1 and " + std::to_string(kMaxPixels) + " pixels");
  }
  return Image(width, height);
}

Rgba Image::at(int x, int y) const noexcept {
  const std::uint8_t* p =
      bytes_.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                           static_cast<std::size_t>(x));
  return {p[0], p[1], p[2], p[3]};
}

}  // namespace felt
