#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "felt/base/base64.h"
#include "felt/document/layer_picture.h"

namespace felt::testing {

/// A PNG file of 2 x 1 pixels, red and blue.
inline constexpr std::string_view kRedBluePng =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAADklEQVR42mP4z8AAQv8BD/kD/Zh51wAAAAAASUVORK5C"
    "YII=";
/// A PNG file of 4 x 4 pixels in different colours. The right half is half transparent.
inline constexpr std::string_view kColorfulPng =
    "iVBORw0KGgoAAAANSUhEUgAAAAQAAAAECAYAAACp8Z5+AAAALUlEQVR42hXIMQEAMAzDsAALMJ8FVX6be+hRknkVmVkl"
    "NUSNXmAIDC7WEGvoA8idHznSJ3w/AAAAAElFTkSuQmCC";

/// Returns the data of a PNG file in base64.
inline std::shared_ptr<const PictureData> picture_data(std::string_view base64 = kRedBluePng) {
  return make_picture_data(base64_bytes(base64).value()).value();
}

/// Returns a picture of 20 x 10 mm with its top left corner at (x, y), red on the left and blue on
/// the right.
inline LayerPicturePtr red_blue_picture(double x_mm, double y_mm) {
  return std::make_shared<const LayerPicture>(
      LayerPicture{picture_data(), {10.0, 0.0, 0.0, 10.0, x_mm, y_mm}});
}

}  // namespace felt::testing
