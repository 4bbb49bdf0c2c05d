#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "felt/base/result.h"
#include "felt/geometry/affine.h"
#include "felt/geometry/rect.h"

namespace felt {

/// The file of a picture. Immutable and shared, so that moving a picture copies no bytes.
struct PictureData {
  static constexpr std::size_t kMaxBytes = std::size_t{48} << 20;
  static constexpr int kMaxSidePx = 8192;

  std::string png;
  int width_px = 0;
  int height_px = 0;

  friend bool operator==(const PictureData&, const PictureData&) = default;
};

/// Returns the data of a PNG file. Fails if the bytes do not begin like a PNG file, have more than
/// kMaxBytes, or if a side of the picture has more than kMaxSidePx pixels. Does not decode the
/// pixels (PicturePixels).
Result<std::shared_ptr<const PictureData>> make_picture_data(std::string png);

/// A picture below the strokes of a layer, to draw over. Immutable.
struct LayerPicture {
  /// Limits of the numbers in `place`: `a` to `d` in mm per pixel, `e` and `f` in mm.
  static constexpr double kMaxScale = 1e4;
  static constexpr double kMaxMm = 1e6;

  std::shared_ptr<const PictureData> data;  ///< never null
  /// Maps pixels to the page: (0, 0) is the top left corner of the picture, (width_px, height_px)
  /// the bottom right one.
  Affine place;
  /// If true, exported files show the picture, too.
  bool exported = false;

  /// Compares by value.
  friend bool operator==(const LayerPicture& a, const LayerPicture& b) {
    return a.place == b.place && a.exported == b.exported &&
           (a.data == b.data || *a.data == *b.data);
  }
};

/// The pictures that an exported file shows.
enum class PictureChoice {
  kMarked,  ///< those with `exported`
  kAll,
};

using LayerPicturePtr = std::shared_ptr<const LayerPicture>;

/// Returns true if a picture can be placed by this map: its numbers are within the limits, and it
/// has an inverse.
[[nodiscard]] bool is_picture_place(const Affine& place) noexcept;

/// Returns the bounds of a picture on the page, in mm.
[[nodiscard]] Rect bounds_of(const LayerPicture& picture) noexcept;

/// Returns the same picture at another place.
[[nodiscard]] LayerPicturePtr placed(const LayerPicture& picture, const Affine& place);

}  // namespace felt
