#pragma once

#include <memory>

#include "felt/render/grain.h"
#include "felt/render/image.h"
#include "felt/render/view.h"
#include "felt/stroke/outline/outline.h"

namespace felt {

/// How far, in pixels, the drawn edge of a stroke may be from the true one.
inline constexpr double kRasterTolerancePx = 0.05;

/// Fills outlines into pixels with 256 levels of coverage (anti-aliasing).
///
/// An outline is filled by the non-zero rule and covers each pixel once, so that a transparent
/// stroke does not darken where it crosses itself. What lies outside `clip` is not touched;
/// filling an area in one go or in tiles gives the same pixels, to 2 of 255 levels at the seams.
///
/// Of a long stroke only the segments near the clip are traced.
///
/// The object keeps its buffers: no allocation per outline after warm-up. One thread at a time.
class Rasterizer {
 public:
  Rasterizer();
  ~Rasterizer();
  Rasterizer(Rasterizer&&) noexcept;
  Rasterizer& operator=(Rasterizer&&) noexcept;

  /// Fills an outline given in mm.
  void fill(const Outline& outline, const View& view, PixelRect clip, Rgba color, Pixels target);

  /// Traces a stroke as finely as this view asks for and fills it in its colour. Does nothing
  /// when it lies outside the clip.
  void draw(const Stroke& stroke, const View& view, PixelRect clip, Pixels target);

  /// Only its centre line, `width_px` wide and opaque: outline view.
  void draw_center_line(const Stroke& stroke, const View& view, PixelRect clip, double width_px,
                        Pixels target);

  /// The same as `draw` with the stroke's medium as it looks on a sheet (R47); a plain grain gives
  /// the pixels of the above.
  void draw(const Stroke& stroke, const View& view, PixelRect clip, const Grain& grain,
            Pixels target);

 private:
  void load(const Outline& outline, const View& view, PixelRect part);
  const InkLook* look_of(const Stroke& stroke, const View& view, const Grain& grain);
  const Outline& trace_near(const Stroke& stroke, const View& view, const Rect& shown);

  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace felt
