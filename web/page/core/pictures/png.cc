#include "png.h"

#include <span>

#include "felt/base/hash.h"

/// Copies the pixels of a PNG file, RGBA with straight alpha. Leaves them as they are if they are
/// not decoded yet.
extern "C" __attribute__((import_module("env"), import_name("picture_pixels"))) void picture_pixels(
    std::uint32_t name_high, std::uint32_t name_low, const char* png, std::size_t size,
    void* pixels, std::size_t pixels_size);

namespace {

constexpr std::uint64_t kMaxPixels = 40'000'000;  // as in files.js
constexpr std::size_t kWidthAt = 16, kHeightAt = 20;

std::uint32_t number_at(const unsigned char* bytes) {
  return std::uint32_t{bytes[0]} << 24U | std::uint32_t{bytes[1]} << 16U |
         std::uint32_t{bytes[2]} << 8U | bytes[3];
}

}  // namespace

int png_image_begin_read_from_memory(png_image* image, const void* bytes, std::size_t size) {
  const auto* at = static_cast<const unsigned char*>(bytes);
  image->message = "it ends within its header";
  if (size < kHeightAt + 4) return 0;
  image->width = number_at(at + kWidthAt);
  image->height = number_at(at + kHeightAt);
  image->png = static_cast<const char*>(bytes);
  image->size = size;
  image->message = "it has more than 40 million pixels";
  return std::uint64_t{image->width} * image->height <= kMaxPixels ? 1 : 0;
}

int png_image_finish_read(png_image* image, const void*, void* pixels, std::int32_t, const void*) {
  felt::Fnv1a name;
  name.add(std::as_bytes(std::span(image->png, image->size)));
  picture_pixels(static_cast<std::uint32_t>(name.value() >> 32U),
                 static_cast<std::uint32_t>(name.value()), image->png, image->size, pixels,
                 PNG_IMAGE_SIZE(*image));
  return 1;
}
