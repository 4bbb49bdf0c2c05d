#pragma once

#include <cstddef>
#include <cstdint>

/// What felt/render/picture_pixels.cc uses of libpng (libpng-manual.txt, "simplified API"). The
/// browser decodes the pictures (pictures.js).

inline constexpr std::uint32_t PNG_IMAGE_VERSION = 1;
inline constexpr std::uint32_t PNG_FORMAT_RGBA = 3;

struct png_image {
  std::uint32_t version, width, height, format;
  const char* message;
  const char* png;
  std::size_t size;
};

inline std::size_t PNG_IMAGE_SIZE(const png_image& image) {
  return std::size_t{4} * image.width * image.height;
}

/// Reads the size. Returns 0 if the page cannot show the picture.
int png_image_begin_read_from_memory(png_image* image, const void* bytes, std::size_t size);
/// Fills the pixels, row by row. Until the browser has decoded the picture, they are transparent;
/// afterwards the page paints everything again.
int png_image_finish_read(png_image* image, const void* background, void* pixels,
                          std::int32_t row_stride, const void* colormap);
inline void png_image_free(png_image*) {}
