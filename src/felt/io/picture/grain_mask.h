#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/geometry/rect.h"
#include "felt/render/grain.h"
#include "felt/render/raster.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A picture that is laid over the outline of a stroke and gives the visible share of its ink at
/// each point. The outline does not change. Outside the picture, no ink is visible.
struct GrainMask {
  Rect area;  ///< mm
  int width = 0, height = 0;
  std::vector<std::uint8_t> seen;  ///< 255: fully visible; rows from the top

  /// Returns the mask as a PNG file: white, with the visibility as alpha.
  [[nodiscard]] Result<std::string> png(double dpi) const;
};

/// Makes the masks of a file's strokes with the rasteriser that draws them on screen. Their pixels
/// lie on the grid of a picture of `area` at that resolution, so that both show the same grain.
class GrainMasks {
 public:
  /// Largest number of pixels in all masks of a file.
  static constexpr std::int64_t kMaxPixels = 200'000'000;

  /// Returns the finest resolution up to `dpi` at which all these strokes can have masks. Returns
  /// nullopt if they need more than kMaxPixels even at GrainPrint::kMinDpi.
  static std::optional<double> dpi_for_all(std::span<const StrokePtr> strokes, const Rect& area,
                                           double dpi) noexcept;

  /// Masks cover only the part of strokes inside `area`.
  GrainMasks(const GrainPrint& print, const Rect& area) noexcept;

  /// Returns nullopt if all of the ink is visible, or if no ink is in the area. Fails if the
  /// resolution is out of range, or if all masks together exceed kMaxPixels.
  Result<std::optional<GrainMask>> of(const Stroke& stroke);
  [[nodiscard]] double dpi() const noexcept { return print_.dpi; }

 private:
  void draw(const Stroke& stroke, const View& view, GrainMask& mask);

  GrainPrint print_;
  Rect area_;
  std::int64_t pixels_left_ = kMaxPixels;
  Rasterizer rasterizer_;
  StrokeOutliner outliner_;
  std::vector<std::uint8_t> ink_, covered_, coverage_;
};

/// Encodes bytes as base64 for a data: URI.
std::string base64_text(std::string_view bytes);

}  // namespace felt
