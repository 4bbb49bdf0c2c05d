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
#include "felt/render/styled_outline.h"
#include "felt/stroke/stroke.h"

namespace felt {

/// A picture that is laid over the outline of a stroke. Each pixel says which fraction of the ink
/// is visible there, so that the grain of the surface shows. The outline does not change. Outside
/// the picture, no ink is visible.
struct GrainMask {
  Rect area;  ///< mm
  int width = 0, height = 0;
  std::vector<std::uint8_t> seen;  ///< 255: fully visible; rows from the top

  /// Returns the mask as a PNG file: white, with the visibility as alpha.
  [[nodiscard]] Result<std::string> png(double dpi) const;
};

/// Makes the masks of all strokes of a file with the rasteriser that also draws the strokes on
/// screen. The pixels of the masks are those of a picture of `area` at the same resolution, so that
/// such a picture and the masks show the same grain.
class GrainMasks {
 public:
  /// Largest number of pixels in all masks of a file.
  static constexpr std::int64_t kMaxPixels = 200'000'000;

  /// Returns the highest resolution, at most `dpi`, at which the masks of all these strokes
  /// together have at most kMaxPixels. Returns nullopt if they have more even at
  /// GrainPrint::kMinDpi.
  static std::optional<double> dpi_for_all(std::span<const StrokePtr> strokes, const Rect& area,
                                           double dpi) noexcept;

  /// Masks cover only the parts of strokes that are inside `area`.
  GrainMasks(const GrainPrint& print, const Rect& area) noexcept;

  /// Returns the mask of a stroke, or nullopt if all of the stroke's ink is visible or none of it
  /// is in the area. Fails if the resolution is out of range, or if all masks together exceed
  /// kMaxPixels.
  Result<std::optional<GrainMask>> of(const Stroke& stroke);
  [[nodiscard]] double dpi() const noexcept { return print_.dpi; }

 private:
  void draw(const Stroke& stroke, const View& view, GrainMask& mask);

  GrainPrint print_;
  Rect area_;
  std::int64_t pixels_left_ = kMaxPixels;
  Rasterizer rasterizer_;
  StrokeOutliner outliner_;
  StrokeStyler styler_;
  std::vector<std::uint8_t> ink_, covered_, coverage_;
};

}  // namespace felt
