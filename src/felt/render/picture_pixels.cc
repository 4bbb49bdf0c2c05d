#include "felt/render/picture_pixels.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace felt {
namespace {

/// Adds a pixel of a level with a weight. Beyond its edges a picture continues with its last
/// pixels.
void add_texel(const std::uint8_t* bytes, int width, int height, int x, int y, float weight,
               PixelSum& sum) noexcept {
  const std::ptrdiff_t column = std::clamp(x, 0, width - 1), row = std::clamp(y, 0, height - 1);
  const std::uint8_t* p = bytes + 4 * (row * width + column);
  for (std::size_t k = 0; k < 4; ++k) sum[k] += weight * static_cast<float>(p[k]);
}

/// Returns how much of a target pixel is inside of a picture along one axis, 0..1. `at` is its
/// centre, from 0 to `size`, and `step` the size of the target pixel.
double inside(double at, double size, double step) noexcept {
  return std::clamp(0.5 + std::min(at, size - at) / step, 0.0, 1.0);
}

/// Blends a premultiplied pixel over another one.
void blend_over(const PixelSum& over, bool swap, std::uint8_t* to) noexcept {
  const float left = 1.0F - over[3] / 255.0F;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t from = swap && k < 3 ? 2 - k : k;
    to[k] = static_cast<std::uint8_t>(
        std::min(255.0F, over[from] + left * static_cast<float>(to[k]) + 0.5F));
  }
}

/// Returns the pixels of `part` that an area of the page may touch.
PixelRect touched(const Rect& area_mm, const View& view, PixelRect part) noexcept {
  const Rect px = view.area_px(area_mm);
  const auto whole = [](double x, int first, int last) {
    return static_cast<int>(std::clamp(x, static_cast<double>(first), static_cast<double>(last)));
  };
  return {whole(std::floor(px.x0) - 1.0, part.x0, part.x1),
          whole(std::floor(px.y0) - 1.0, part.y0, part.y1),
          whole(std::ceil(px.x1) + 1.0, part.x0, part.x1),
          whole(std::ceil(px.y1) + 1.0, part.y0, part.y1)};
}

}  // namespace

Result<std::shared_ptr<const PicturePixels>> PicturePixels::decode(const PictureData& data) {
  const auto damaged = [](const std::string& why) {
    return fail(ErrorCode::kInvalidData, "the PNG file is damaged: " + why);
  };
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&png, data.png.data(), data.png.size()) == 0) {
    return damaged(png.message);
  }
  if (static_cast<int>(png.width) != data.width_px ||
      static_cast<int>(png.height) != data.height_px) {
    png_image_free(&png);
    return damaged("its size is not the one that it states");
  }
  png.format = PNG_FORMAT_RGBA;
  Level level{data.width_px, data.height_px, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(png))};
  if (png_image_finish_read(&png, nullptr, level.bytes.data(), 0, nullptr) == 0) {
    return damaged(png.message);
  }
  for (std::size_t i = 0; i < level.bytes.size(); i += 4) {
    const unsigned alpha = level.bytes[i + 3];
    for (std::size_t k = 0; k < 3; ++k) {
      level.bytes[i + k] = static_cast<std::uint8_t>((level.bytes[i + k] * alpha + 127U) / 255U);
    }
  }
  std::shared_ptr<PicturePixels> pixels(new PicturePixels);
  pixels->levels_.push_back(std::move(level));
  while (pixels->levels_.back().width > 1 || pixels->levels_.back().height > 1) {
    pixels->levels_.push_back(halved(pixels->levels_.back()));
  }
  return pixels;
}

/// Averages squares of four pixels. A side with an odd number of pixels repeats its last one.
PicturePixels::Level PicturePixels::halved(const Level& from) {
  Level to{(from.width + 1) / 2, (from.height + 1) / 2, {}};
  to.bytes.reserve(std::size_t{4} * static_cast<std::size_t>(to.width) *
                   static_cast<std::size_t>(to.height));
  for (int y = 0; y < to.height; ++y) {
    const int y1 = std::min(2 * y + 1, from.height - 1);
    for (int x = 0; x < to.width; ++x) {
      const int x1 = std::min(2 * x + 1, from.width - 1);
      const auto at = [&from](int column, int row) {
        return from.bytes.data() + 4 * (static_cast<std::ptrdiff_t>(row) * from.width + column);
      };
      const std::uint8_t *a = at(2 * x, 2 * y), *b = at(x1, 2 * y), *c = at(2 * x, y1),
                         *d = at(x1, y1);
      for (int k = 0; k < 4; ++k) {
        to.bytes.push_back(static_cast<std::uint8_t>((a[k] + b[k] + c[k] + d[k] + 2) / 4));
      }
    }
  }
  return to;
}

/// Interpolates between the four nearest pixels. The centre of a pixel has the coordinate 0.5.
PixelSum PicturePixels::Level::at(double x, double y, float weight) const noexcept {
  const double u = x - 0.5, v = y - 0.5;
  const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
  const auto right = static_cast<float>(u - i), lower = static_cast<float>(v - j);
  PixelSum sum{};
  add_texel(bytes.data(), width, height, i, j, weight * (1.0F - right) * (1.0F - lower), sum);
  add_texel(bytes.data(), width, height, i + 1, j, weight * right * (1.0F - lower), sum);
  add_texel(bytes.data(), width, height, i, j + 1, weight * (1.0F - right) * lower, sum);
  add_texel(bytes.data(), width, height, i + 1, j + 1, weight * right * lower, sum);
  return sum;
}

void PicturePixels::draw(const Affine& place, const View& view, PixelRect part, double opacity,
                         Pixels target) const {
  const std::optional<Affine> to_picture = inverse(place);
  const Level& full = levels_.front();
  Rect box;
  for (const Point corner :
       {Point{0.0, 0.0}, Point{1.0 * full.width, 0.0}, Point{1.0 * full.width, 1.0 * full.height},
        Point{0.0, 1.0 * full.height}}) {
    box.extend(apply(place, corner));
  }
  const PixelRect area = touched(box, view, part.intersected(target.rect()));
  if (!to_picture || area.empty() || !(opacity > 0.0)) return;
  const auto texel_at = [&](double x, double y) { return apply(*to_picture, view.to_mm({x, y})); };
  const Point origin = texel_at(0.0, 0.0);
  const Vec step_x = texel_at(1.0, 0.0) - origin, step_y = texel_at(0.0, 1.0) - origin;
  const double texels_per_px = std::max(norm(step_x), norm(step_y));
  std::size_t n = 0;
  double shrink = 1.0;
  for (; n + 1 < levels_.size() && texels_per_px >= 2.0 * shrink; ++n) shrink *= 2.0;
  const Level& level = levels_[n];
  const Vec texels{std::hypot(step_x.x, step_y.x), std::hypot(step_x.y, step_y.y)};
  const bool swap = target.order == PixelOrder::kBgra;
  for (int y = area.y0; y < area.y1; ++y) {
    std::uint8_t* to = target.data + y * target.stride + std::ptrdiff_t{4} * area.x0;
    for (int x = area.x0; x < area.x1; ++x, to += 4) {
      const Point at = origin + (x + 0.5) * step_x + (y + 0.5) * step_y;
      const double share =
          opacity * inside(at.x, full.width, texels.x) * inside(at.y, full.height, texels.y);
      if (!(share > 0.0)) continue;
      blend_over(level.at(at.x / shrink, at.y / shrink, static_cast<float>(share)), swap, to);
    }
  }
}

}  // namespace felt
