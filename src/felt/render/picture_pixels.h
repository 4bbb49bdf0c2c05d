#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/layer_picture.h"
#include "felt/render/image.h"
#include "felt/render/view.h"

namespace felt {

/// The weighted sum of pixels: red, green, blue, alpha, premultiplied, 0..255.
using PixelSum = std::array<float, 4>;

/// The pixels of a picture, ready to be drawn at any scale. Immutable.
class PicturePixels {
 public:
  /// Decodes the picture. Fails if its bytes are damaged. Takes about 0.2 s and 100 MB for 20
  /// million pixels.
  static Result<std::shared_ptr<const PicturePixels>> decode(const PictureData& data);

  /// Draws the picture over `part` of the target. `place` maps its pixels to the page, `opacity` is
  /// 0..1. Between pixels of the picture, colours are interpolated; a picture that is shown smaller
  /// is averaged first.
  void draw(const Affine& place, const View& view, PixelRect part, double opacity,
            Pixels target) const;

 private:
  /// The picture, reduced by a power of two. RGBA, premultiplied.
  struct Level {
    int width = 0, height = 0;
    std::vector<std::uint8_t> bytes;

    [[nodiscard]] PixelSum at(double x, double y, float weight) const noexcept;
  };

  PicturePixels() = default;
  static Level halved(const Level& from);

  std::vector<Level> levels_;  // the full size first
};

}  // namespace felt
