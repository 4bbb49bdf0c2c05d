#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/blend_mode.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A rectangle of pixels; x1 and y1 are one past the last pixel.
struct PixelRect {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  friend constexpr bool operator==(const PixelRect&, const PixelRect&) noexcept = default;

  [[nodiscard]] constexpr int width() const noexcept { return x1 > x0 ? x1 - x0 : 0; }
  [[nodiscard]] constexpr int height() const noexcept { return y1 > y0 ? y1 - y0 : 0; }
  [[nodiscard]] constexpr bool empty() const noexcept { return x1 <= x0 || y1 <= y0; }
  /// Returns the pixels that are in both rectangles.
  [[nodiscard]] constexpr PixelRect intersected(const PixelRect& o) const noexcept {
    return {x0 > o.x0 ? x0 : o.x0, y0 > o.y0 ? y0 : o.y0, x1 < o.x1 ? x1 : o.x1,
            y1 < o.y1 ? y1 : o.y1};
  }
};

/// Order of the four bytes of a pixel in memory.
enum class PixelOrder : std::uint8_t {
  kRgba,  ///< used by PNG files
  kBgra,  ///< used by desktop windows (32-bit ARGB on a little-endian machine)
};

/// A view of pixels that the caller owns: 8-bit sRGB, premultiplied alpha, rows top to bottom.
struct Pixels {
  std::uint8_t* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next
  PixelOrder order = PixelOrder::kRgba;

  [[nodiscard]] PixelRect rect() const noexcept { return {0, 0, width, height}; }
};

/// Sets every pixel of `area`, clipped to the picture, to one colour.
void fill(Pixels target, PixelRect area, Rgba color) noexcept;

/// Blends `area` of a picture, made more transparent by `opacity` (0..1), over the same area of
/// another one. Requires that both have the same order of bytes and contain the area.
///
/// The formulas are those of CSS (https://www.w3.org/TR/compositing-1/#blending), as if the target
/// were then drawn on opaque `paper`: where the target is transparent, BlendMode::kMultiply
/// multiplies with the paper. White gives the result of CSS without paper.
void blend(Pixels from, PixelRect area, double opacity, BlendMode mode, Rgba paper,
           Pixels target) noexcept;

/// A picture in memory, RGBA, premultiplied.
class Image {
 public:
  /// Maximum number of pixels of a picture: 2^28, which take 1 GiB.
  static constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;

  /// Creates a transparent picture. Fails if a side is not positive, or if the picture has more
  /// pixels than kMaxPixels.
  static Result<Image> create(int width, int height);

  [[nodiscard]] int width() const noexcept { return width_; }
  [[nodiscard]] int height() const noexcept { return height_; }
  [[nodiscard]] Pixels pixels() noexcept {
    return {bytes_.data(), width_, height_, std::ptrdiff_t{4} * width_, PixelOrder::kRgba};
  }
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const noexcept { return bytes_; }
  /// Returns the premultiplied pixel at (x, y). Requires that (x, y) is inside the picture.
  [[nodiscard]] Rgba at(int x, int y) const noexcept;

  friend bool operator==(const Image&, const Image&) = default;

 private:
  Image(int width, int height);
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace felt
