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

/// How much of a stroke's ink is seen where: a picture that lies over its outline, which stays what
/// it is. Outside of it nothing is seen.
struct GrainMask {
  Rect area;  ///< mm
  int width = 0, height = 0;
  std::vector<std::uint8_t> seen;  ///< 255: all of it; rows from the top

  /// A PNG file of it: white, its alpha is what is seen.
  [[nodiscard]] Result<std::string> png(double dpi) const;
};

/// Makes the masks of a file's strokes, by the rasteriser that draws them on screen. Their pixels
/// lie on the grid of a picture of `area` at that resolution, so that both show the same grains.
class GrainMasks {
 public:
  /// Pixels of all masks of a file.
  static constexpr std::int64_t kMostPixels = 200'000'000;

  /// The finest resolution, `dpi` at most, at which the masks of all these strokes are made; none
  /// where they have more than kMostPixels even at GrainPrint::kLeastDpi.
  static std::optional<double> dpi_for_all(std::span<const StrokePtr> strokes, const Rect& area,
                                           double dpi) noexcept;

  /// Of what is in `area` only.
  GrainMasks(const GrainPrint& print, const Rect& area) noexcept;

  /// None where all of the ink is seen, or none of it is in the area. Error: a resolution beyond
  /// its range, or more than kMostPixels in all.
  Result<std::optional<GrainMask>> of(const Stroke& stroke);
  [[nodiscard]] double dpi() const noexcept { return print_.dpi; }

 private:
  void draw(const Stroke& stroke, const View& view, GrainMask& mask);

  GrainPrint print_;
  Rect area_;
  std::int64_t pixels_left_ = kMostPixels;
  Rasterizer rasterizer_;
  StrokeOutliner outliner_;
  std::vector<std::uint8_t> ink_, covered_, coverage_;
};

/// As text for a data: URI.
std::string base64_text(std::string_view bytes);

}  // namespace felt
