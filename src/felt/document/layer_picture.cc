#include "felt/document/layer_picture.h"

#include <cmath>
#include <string_view>
#include <utility>

namespace felt {
namespace {

// The signature of a PNG file, and the length and type of its first chunk.
constexpr std::string_view kPngHead{"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16};
constexpr std::size_t kPngSizeEnd = 24;

std::uint32_t big_endian_at(std::string_view bytes, std::size_t at) noexcept {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

}  // namespace

Result<std::shared_ptr<const PictureData>> make_picture_data(std::string png) {
  if (png.size() > PictureData::kMaxBytes) {
    return fail(ErrorCode::kLimitExceeded, "the picture is larger than 48 MiB");
  }
  if (png.size() < kPngSizeEnd || !std::string_view(png).starts_with(kPngHead)) {
    return fail(ErrorCode::kInvalidData, "the picture is not a PNG file");
  }
  const std::uint32_t width = big_endian_at(png, 16), height = big_endian_at(png, 20);
  constexpr auto kMaxSide = static_cast<std::uint32_t>(PictureData::kMaxSidePx);
  if (width == 0 || height == 0 || width > kMaxSide || height > kMaxSide) {
    return fail(ErrorCode::kLimitExceeded, "the sides of a picture must have 1 to 8192 pixels");
  }
  return std::make_shared<const PictureData>(
      PictureData{std::move(png), static_cast<int>(width), static_cast<int>(height)});
}

bool is_picture_place(const Affine& place) noexcept {
  for (const double x : {place.a, place.b, place.c, place.d}) {
    if (!(std::fabs(x) <= LayerPicture::kMaxScale)) return false;
  }
  return std::fabs(place.e) <= LayerPicture::kMaxMm && std::fabs(place.f) <= LayerPicture::kMaxMm &&
         inverse(place).has_value();
}

Rect bounds_of(const LayerPicture& picture) noexcept {
  const double w = picture.data->width_px, h = picture.data->height_px;
  Rect box;
  for (const Point corner : {Point{0.0, 0.0}, Point{w, 0.0}, Point{w, h}, Point{0.0, h}}) {
    box.extend(apply(picture.place, corner));
  }
  return box;
}

LayerPicturePtr placed(const LayerPicture& picture, const Affine& place) {
  LayerPicture moved = picture;
  moved.place = place;
  return std::make_shared<const LayerPicture>(std::move(moved));
}

}  // namespace felt
