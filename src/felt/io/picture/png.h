#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/geometry/height_picture.h"
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

/// Reads any PNG that libpng reads as a relief: grey at 16 bits a pixel (8 are stretched), white is
/// high, colours by their brightness, without regard to transparency or gamma. Error: not a PNG,
/// damaged, or more than kMostHeightPixels.
Result<HeightPicture> decode_height_png(std::string_view bytes);
inline constexpr std::int64_t kMostHeightPixels = std::int64_t{1} << 26;

/// The same from a file. Error: it cannot be read, is a pipe or a device, is larger than 256 MiB,
/// or the above; names it.
Result<HeightPicture> read_height_png(const std::string& path);

}  // namespace felt
