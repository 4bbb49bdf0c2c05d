#pragma once

#include <memory>
#include <optional>

#include "felt/document/fill.h"
#include "felt/render/grain.h"
#include "felt/render/image.h"
#include "felt/render/view.h"
#include "felt/stroke/outline/outline.h"

namespace felt {

/// Largest distance, in pixels, between the drawn edge of a stroke and the true one.
inline constexpr double kRasterTolerancePx = 0.05;

/// Fills outlines into pixels with 256 levels of coverage (anti-aliasing).
///
/// An outline is filled by the non-zero rule and covers each pixel once, so that a transparent
/// stroke is not darker where it crosses itself. With a grain, dry media are (VisitMap). Pixels
/// outside `clip` do not change. Filling an
/// area in tiles gives the same pixels as filling it in one call, except for differences of up to 2
/// of 255 levels at the seams. With a window (set_window()), it gives exactly the same pixels.
///
/// For a long stroke, only the segments near the clip are traced.
///
/// Reuses its buffers, so that after warm-up it does not allocate for each outline. Not
/// thread-safe.
class Rasterizer {
 public:
  Rasterizer();
  ~Rasterizer();
  Rasterizer(Rasterizer&&) noexcept;
  Rasterizer& operator=(Rasterizer&&) noexcept;

  /// From now on, only pixels in this window change, and they become exactly what they become
  /// without a window: shapes are traced and clipped as for the whole `clip`. nullopt removes the
  /// window. It does not apply to draw_center_line().
  void set_window(std::optional<PixelRect> window) noexcept;

  /// Fills an outline given in mm.
  void fill(const Outline& outline, const View& view, PixelRect clip, Rgba color, Pixels target);

  /// Traces a stroke with the precision that this view needs and fills it in its colour. Does
  /// nothing if it is outside the clip.
  void draw(const Stroke& stroke, const View& view, PixelRect clip, Pixels target);

  /// Fills an area in its colour by the even-odd rule. Fills have no grain. Does nothing if the
  /// area is outside the clip.
  void draw_fill(const Fill& fill, const View& view, PixelRect clip, Pixels target);

  /// Draws only the centre line of a stroke, `width_px` wide and opaque. Used for the outline view.
  void draw_center_line(const Stroke& stroke, const View& view, PixelRect clip, double width_px,
                        Pixels target);

  /// Draws a stroke with the look and the style of its medium on a surface (R47). If the grain is
  /// plain and the medium has no style, the pixels are the same as without a grain.
  void draw(const Stroke& stroke, const View& view, PixelRect clip, const Grain& grain,
            Pixels target);

 private:
  void load(const Outline& outline, const View& view, PixelRect part);
  void blend_loaded(PixelRect part, Rgba color, Pixels target);
  /// Returns the pixels of `part` that may change.
  [[nodiscard]] PixelRect visible(PixelRect part) const noexcept;
  const InkLook* look_of(const Stroke& stroke, const View& view, const Grain& grain);
  /// Returns the outline of the ink near `shown`; `style` may be null.
  const Outline& trace_ink(const Stroke& stroke, const StrokeStyle* style, const View& view,
                           const Rect& shown);
  const Outline& trace_near(const Stroke& stroke, const View& view, const Rect& shown);

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt
