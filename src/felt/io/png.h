#pragma once

#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/render/image.h"

namespace felt {

/// A picture read from a PNG file.
struct PngPicture {
  Image image;
  double dpi = 0.0;  ///< 0 where the file does not say
};

/// The PNG file of a picture: 8-bit sRGB, with an alpha channel only where a pixel is
/// transparent, and its resolution. The same picture gives the same bytes.
/// PNG has whole pixels per metre, so dpi is kept to 0.013.
Result<std::string> encode_png(const Image& image, double dpi);

/// Writes a picture to a file, whole or not at all; "-" is stdout.
Result<void> write_png(const std::string& path, const Image& image, double dpi);

/// Reads any PNG that libpng reads, converted to 8-bit RGBA. Error: not a PNG, damaged, or larger
/// than Image::kMaxPixels.
Result<PngPicture> decode_png(std::string_view bytes);

}  // namespace felt
