#include "felt/io/picture/png.h"

#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
#include <cstring>
#include <vector>

#include "felt/base/atomic_file.h"
#include "felt/base/read_file.h"

namespace felt {
namespace {

constexpr double kInchesPerMetre = 1000.0 / 25.4;

/// Data shared between libpng's callbacks and the functions below. libpng returns from errors by
/// longjmp, which runs no destructor, so all objects that own memory are members of this struct or
/// variables of the callers, never variables of a function that longjmp leaves.
struct Session {
  std::string message;
  std::string out;
  std::string_view in;
  std::vector<std::uint8_t> row;
  std::vector<std::uint8_t> pixels;
  std::uint32_t width = 0, height = 0;
  double dpi = 0.0;
};

void on_error(png_structp png, png_const_charp text) {
  static_cast<Session*>(png_get_error_ptr(png))->message = text;
  std::longjmp(*png_set_longjmp_fn(png, std::longjmp, sizeof(std::jmp_buf)), 1);
}

void on_warning(png_structp, png_const_charp) {}

void on_write(png_structp png, png_bytep data, std::size_t size) {
  static_cast<Session*>(png_get_io_ptr(png))->out.append(reinterpret_cast<const char*>(data), size);
}

void on_flush(png_structp) {}

void on_read(png_structp png, png_bytep data, std::size_t size) {
  auto* session = static_cast<Session*>(png_get_io_ptr(png));
  if (session->in.size() < size) png_error(png, "the file ends too early");
  std::memcpy(data, session->in.data(), size);
  session->in.remove_prefix(size);
}

std::uint8_t unmultiplied(std::uint8_t c, std::uint8_t a) noexcept {
  return a == 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(std::min(255, (c * 255 + a / 2) / a));
}

std::uint8_t premultiplied(std::uint8_t c, std::uint8_t a) noexcept {
  return static_cast<std::uint8_t>((c * a + 127) / 255);
}

bool opaque(const Image& image) noexcept {
  for (std::size_t i = 3; i < image.bytes().size(); i += 4) {
    if (image.bytes()[i] != 255) return false;
  }
  return true;
}

/// Fills `row` with row y as PNG stores it: straight alpha, or no alpha.
void load_row(const Image& image, int y, bool alpha, std::vector<std::uint8_t>& row) {
  const auto width = static_cast<std::size_t>(image.width());
  const std::uint8_t* p = image.bytes().data() + 4 * width * static_cast<std::size_t>(y);
  row.clear();
  for (std::size_t x = 0; x < width; ++x, p += 4) {
    if (alpha) {
      row.insert(row.end(), {unmultiplied(p[0], p[3]), unmultiplied(p[1], p[3]),
                             unmultiplied(p[2], p[3]), p[3]});
    } else {
      row.insert(row.end(), {p[0], p[1], p[2]});
    }
  }
}

/// Returns false if libpng failed; the reason is in the session.
bool encode(png_structp png, png_infop info, const Image& image, double dpi, Session& session) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_write_fn(png, &session, on_write, on_flush);
  const bool alpha = !opaque(image);
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width()),
               static_cast<png_uint_32>(image.height()), 8,
               alpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  if (dpi > 0.0) {
    const auto per_metre = static_cast<png_uint_32>(std::lround(dpi * kInchesPerMetre));
    png_set_pHYs(png, info, per_metre, per_metre, PNG_RESOLUTION_METER);
  }
  png_write_info(png, info);
  for (int y = 0; y < image.height(); ++y) {
    load_row(image, y, alpha, session.row);
    png_write_row(png, session.row.data());
  }
  png_write_end(png, info);
  return true;
}

bool decode(png_structp png, png_infop info, Session& session) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_read_fn(png, &session, on_read);
  png_read_info(png, info);
  session.width = png_get_image_width(png, info);
  session.height = png_get_image_height(png, info);
  if (std::uint64_t{session.width} * session.height > std::uint64_t{Image::kMaxPixels}) {
    png_error(png, "the picture is too large");
  }
  session.dpi = png_get_pixels_per_meter(png, info) / kInchesPerMetre;
  png_set_expand(png);
  png_set_strip_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 255, PNG_FILLER_AFTER);
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  session.pixels.resize(std::size_t{4} * session.width * session.height);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t y = 0; y < session.height; ++y) {
      png_read_row(png, session.pixels.data() + y * 4 * session.width, nullptr);
    }
  }
  png_read_end(png, nullptr);
  return true;
}

/// Decodes like decode(), but to a single grey channel with 16 bits a pixel, high byte first.
bool decode_grey(png_structp png, png_infop info, Session& session) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_read_fn(png, &session, on_read);
  png_read_info(png, info);
  session.width = png_get_image_width(png, info);
  session.height = png_get_image_height(png, info);
  if (std::uint64_t{session.width} * session.height > std::uint64_t{kMaxHeightPixels}) {
    png_error(png, "the picture is too large for a relief");
  }
  session.dpi = png_get_pixels_per_meter(png, info) / kInchesPerMetre;
  png_set_expand(png);
  png_set_expand_16(png);
  png_set_strip_alpha(png);
  constexpr int kQuietly = 1, kUsualWeights = -1;
  if ((png_get_color_type(png, info) & PNG_COLOR_MASK_COLOR) != 0) {
    png_set_rgb_to_gray_fixed(png, kQuietly, kUsualWeights, kUsualWeights);
  }
  const int passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  if (png_get_rowbytes(png, info) != std::size_t{2} * session.width) {
    png_error(png, "the picture cannot be converted to grey");
  }
  session.pixels.resize(std::size_t{2} * session.width * session.height);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t y = 0; y < session.height; ++y) {
      png_read_row(png, session.pixels.data() + y * 2 * session.width, nullptr);
    }
  }
  png_read_end(png, nullptr);
  return true;
}

tl::unexpected<Error> no_memory() {
  return fail(ErrorCode::kLimitExceeded, "libpng could not start: out of memory");
}

}  // namespace

Result<std::string> encode_png(const Image& image, double dpi) {
  if (!(dpi >= 0.0 && dpi <= 1e6)) {
    return fail(ErrorCode::kInvalidArgument, "the resolution of a PNG must be 0 to 1000000 dpi");
  }
  Session session;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &session, on_error, on_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool ok = info && encode(png, info, image, dpi, session);
  png_destroy_write_struct(&png, &info);
  if (ok) return std::move(session.out);
  if (session.message.empty()) return no_memory();
  return fail(ErrorCode::kInvalidData, "PNG: " + session.message);
}

Result<void> write_png(const std::string& path, const Image& image, double dpi) {
  auto bytes = encode_png(image, dpi);
  if (!bytes) return tl::unexpected<Error>(with_context(std::move(bytes.error()), path));
  return write_file(path, *bytes);
}

Result<PngPicture> decode_png(std::string_view bytes) {
  Session session;
  session.in = bytes;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &session, on_error, on_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool ok = info && decode(png, info, session);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!ok && session.message.empty()) return no_memory();
  if (!ok) return fail(ErrorCode::kInvalidData, "PNG: " + session.message);
  auto image = Image::create(static_cast<int>(session.width), static_cast<int>(session.height));
  if (!image) return tl::unexpected<Error>(std::move(image.error()));
  std::uint8_t* to = image->pixels().data;
  for (std::size_t i = 0; i < session.pixels.size(); i += 4) {
    const std::uint8_t a = session.pixels[i + 3];
    for (std::size_t c = 0; c < 3; ++c) to[i + c] = premultiplied(session.pixels[i + c], a);
    to[i + 3] = a;
  }
  return PngPicture{*std::move(image), session.dpi};
}

Result<HeightPicture> decode_height_png(std::string_view bytes) {
  Session session;
  session.in = bytes;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &session, on_error, on_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  const bool ok = info && decode_grey(png, info, session);
  png_destroy_read_struct(&png, &info, nullptr);
  if (!ok && session.message.empty()) return no_memory();
  if (!ok) return fail(ErrorCode::kInvalidData, "PNG: " + session.message);
  HeightPicture picture{static_cast<int>(session.width), static_cast<int>(session.height), {}, 0.0};
  picture.heights.reserve(session.pixels.size() / 2);
  for (std::size_t i = 0; i + 1 < session.pixels.size(); i += 2) {
    const int value = 256 * session.pixels[i] + session.pixels[i + 1];
    picture.heights.push_back(static_cast<float>(value) / 65535.0F);
  }
  if (session.dpi > 0.0) picture.width_mm = 25.4 * picture.width / session.dpi;
  return picture;
}

Result<HeightPicture> read_height_png(const std::string& path) {
  constexpr std::size_t kMaxBytes = std::size_t{256} << 20;
  auto bytes = read_regular_file(path, kMaxBytes);
  if (!bytes) return tl::unexpected<Error>(std::move(bytes.error()));
  auto picture = decode_height_png(*bytes);
  if (!picture) return tl::unexpected<Error>(with_context(std::move(picture.error()), path));
  return picture;
}

}  // namespace felt
