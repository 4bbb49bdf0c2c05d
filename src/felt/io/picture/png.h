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
  double dpi = 0.0;  ///< resolution; 0 if the file does not specify it
};

/// Returns a picture as a PNG file in 8-bit sRGB. The file contains the resolution, and an alpha
/// channel only if a pixel is transparent. The same picture gives the same bytes. PNG stores the
/// resolution as a whole number of pixels per metre, so the stored resolution differs from `dpi` by
/// up to 0.013 dpi.
Result<std::string> encode_png(const Image& image, double dpi);

/// Writes a picture to a file, completely or not at all; "-" is stdout.
Result<void> write_png(const std::string& path, const Image& image, double dpi);

/// Reads any PNG that libpng supports, converted to 8-bit RGBA. Fails if it is not a PNG, is
/// damaged, or is larger than Image::kMaxPixels.
Result<PngPicture> decode_png(std::string_view bytes);

/// Reads any PNG that libpng supports as a relief: grey at 16 bits per pixel (8-bit values are
/// scaled up). White is high. The height of a coloured pixel is its brightness; transparency and
/// gamma are ignored. Fails if it is not a PNG, is damaged, or has more than kMaxHeightPixels.
Result<HeightPicture> decode_height_png(std::string_view bytes);
inline constexpr std::int64_t kMaxHeightPixels = std::int64_t{1} << 26;

/// Reads a relief from a file, like decode_height_png(). Also fails if the file cannot be read, is
/// a pipe or a device, or is larger than 256 MiB. The message names the file.
Result<HeightPicture> read_height_png(const std::string& path);

}  // namespace felt
