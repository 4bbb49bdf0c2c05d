#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "felt/render/grain.h"
#include "felt/render/ink_scene.h"
#include "felt/render/raster.h"

namespace felt {

/// Tiles are squares of so many pixels.
inline constexpr int kTileSide = 256;

/// How ink is drawn.
struct InkStyle {
  Grain grain{};
  /// Above 0: only centre lines, so wide.
  double hair_px = 0.0;
};

/// Strokes that a part of a picture shows, drawn one after another, so that a long work can be laid
/// down and taken up again. Holds the strokes: the scene may change meanwhile.
struct InkJob {
  View view;
  PixelRect part;
  std::vector<StrokePtr> strokes;
  std::size_t next = 0;

  [[nodiscard]] bool is_done() const noexcept { return next == strokes.size(); }
};

/// What a tile shows below and above the strokes of a preview, kept while they change.
struct TileSplit {
  PixelRect valid;                  ///< what the pictures show; empty: nothing is kept
  std::vector<std::uint8_t> below;  ///< of `valid`
  std::vector<std::uint8_t> above;  ///< likewise, on nothing
  StrokeId below_top;               ///< the highest stroke in `below`, or none
  StrokeId above_bottom;            ///< the lowest stroke in `above`, or none
  std::vector<StrokeId> drawn;      ///< all strokes of both, ascending
  std::vector<StrokeId> previewed;  ///< when it was made, ascending
  std::uint64_t revision = 0;       ///< of the scene
  /// Some of the tile was put together from `above`, a pile of strokes that was blended in one go:
  /// up to 4 of 255 levels off where dozens of transparent strokes lie on one another.
  bool is_rounded = false;
};

/// Paints parts of pictures of a scene, ink on nothing. One thread at a time.
class TilePainter {
 public:
  /// What draws `part` of this picture, straight. `above`: only the layers above that one.
  [[nodiscard]] static InkJob job_of(const InkScene& scene, const View& view, PixelRect part,
                                     std::optional<LayerId> above = {});
  /// Draws the next stroke of a job. The part must have been cleared before the first one.
  void draw_next(InkJob& job, const InkStyle& style, Pixels target);
  /// Draws one stroke.
  void draw(const Stroke& stroke, const View& view, PixelRect part, const InkStyle& style,
            Pixels target);

  /// Paints `part` anew while a preview is shown, with what lies below and above its strokes from
  /// `split`, which is made or widened where it does not fit; the cost is then that of the strokes
  /// of the preview and between them, however many lie around. False: there is nothing to gain
  /// here, and nothing was painted: draw it straight.
  bool paint_split(const InkScene& scene, const View& view, PixelRect part, const InkStyle& style,
                   TileSplit& split, Pixels target);

 private:
  [[nodiscard]] static bool is_valid(const InkScene& scene, const View& view,
                                     const TileSplit& split);
  bool fits(const InkScene& scene, const TileSplit& split, PixelRect part) const;
  bool make(const InkScene& scene, const View& view, PixelRect valid, const InkStyle& style,
            TileSplit& split);

  Rasterizer rasterizer_;
  std::vector<const SceneStroke*> found_;
};

}  // namespace felt
