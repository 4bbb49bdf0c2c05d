#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "felt/render/grain.h"
#include "felt/render/ink_scene.h"
#include "felt/render/raster.h"

namespace felt {

/// Side of a square tile, in pixels.
inline constexpr int kTileSide = 256;

/// How ink is drawn.
struct InkStyle {
  Grain grain{};
  /// If above 0, only the centre lines of strokes are drawn, this many pixels wide.
  double hair_px = 0.0;
  Rgba paper{255, 255, 255, 255};  ///< below the picture: blend modes multiply with it
  /// If true, the part of a job gets exactly the pixels of the whole target painted in one job.
  /// Slower, because shapes are traced and clipped as for the whole target.
  bool is_seamless = false;
};

/// A stroke or a fill to draw: one of the two pointers is set.
struct InkItem {
  StrokePtr stroke;
  FillPtr fill;
};

/// A layer of an InkJob that is drawn as a whole: its picture first, then the items from `first` to
/// `last` (not included) of the job.
struct InkGroup {
  std::size_t first = 0, last = 0;
  double opacity = 1.0;
  std::shared_ptr<const PicturePixels> pixels;  ///< null if the layer has no picture
  Affine place;                                 ///< of the picture
  BlendMode blend = BlendMode::kNormal;
  bool has_ink = false;  ///< the layer has strokes or fills, perhaps outside the job's part
};

/// A group of layers of an InkJob that is drawn as a whole (LayerGroup::is_whole): the items from
/// `first` to `last` and the groups from `first_group` to `last_group` (not included) of the job.
struct InkFolder {
  std::size_t first = 0, last = 0;
  std::size_t first_group = 0, last_group = 0;
  double opacity = 1.0;
  BlendMode blend = BlendMode::kNormal;
};

/// The strokes and fills that a part of a picture shows, drawn one at a time, so that a long job
/// can be interrupted and resumed. The job shares ownership of them, so the scene may change
/// meanwhile.
struct InkJob {
  View view;
  PixelRect part;
  std::vector<InkItem> items;
  std::vector<InkGroup> groups;    ///< only of layers that are special, lowest first
  std::vector<InkFolder> folders;  ///< lowest first
  std::size_t next = 0;
  std::size_t next_group = 0;
  std::size_t next_folder = 0;
  bool is_in_group = false;                 ///< the group `next_group` has begun
  bool is_in_folder = false;                ///< the folder `next_folder` has begun
  std::vector<std::uint8_t> group_pixels;   ///< its strokes so far, if it is drawn as a whole
  std::vector<std::uint8_t> folder_pixels;  ///< the layers of the folder so far

  [[nodiscard]] bool has_begun() const noexcept {
    return next + next_group > 0 || is_in_group || is_in_folder;
  }
  [[nodiscard]] bool is_done() const noexcept {
    return next == items.size() && next_group == groups.size() && next_folder == folders.size();
  }
  [[nodiscard]] bool is_blank() const noexcept { return items.empty() && groups.empty(); }
};

/// Two pictures of a tile: one of the strokes below the strokes of a preview, and one of the
/// strokes above these. The pictures are kept while the preview changes.
struct TileSplit {
  PixelRect valid;                  ///< area of the pictures; empty if nothing is kept
  std::vector<std::uint8_t> below;  ///< picture of the strokes below, transparent background
  std::vector<std::uint8_t> above;  ///< picture of the strokes above, transparent background
  StrokeId below_top;               ///< the highest stroke in `below`; zero if it is empty
  StrokeId above_bottom;            ///< the lowest stroke in `above`; zero if it is empty
  std::vector<StrokeId> drawn;      ///< all strokes in both pictures, ascending
  std::vector<StrokeId> previewed;  ///< InkScene::previewed() when the split was made
  std::uint64_t revision = 0;       ///< InkScene::revision() when the split was made
  /// True if a part of the tile was composed from `above`, in which many strokes are blended in one
  /// step. The error is up to 4 of 255 levels if dozens of transparent strokes overlap.
  bool is_rounded = false;
};

/// Paints parts of pictures of a scene, on a transparent background. Not thread-safe.
class TilePainter {
 public:
  /// Returns the job that draws `part` of the picture with this view directly, without a TileSplit.
  /// If `above` is set, the job draws only the layers above that layer.
  [[nodiscard]] static InkJob job_of(const InkScene& scene, const View& view, PixelRect part,
                                     std::optional<LayerId> above = {});
  /// Draws the next stroke, fill or picture of a job. Requires that the part was cleared before the
  /// first one. The outline view (InkStyle::hair_px) has no fills.
  void draw_next(InkJob& job, const InkStyle& style, Pixels target);
  /// Draws one stroke.
  void draw(const Stroke& stroke, const View& view, PixelRect part, const InkStyle& style,
            Pixels target);

  /// Repaints `part` while a preview is shown. The strokes below and above those of the preview
  /// come from `split`. If the pictures in `split` can be used for `part`, the time depends only on
  /// the strokes of the preview and on the strokes between these; otherwise, `split` is first made
  /// again for an area that contains `part`. Returns false, and paints nothing, if this is not
  /// faster than drawing directly, or if the part shows a fill.
  bool paint_split(const InkScene& scene, const View& view, PixelRect part, const InkStyle& style,
                   TileSplit& split, Pixels target);

 private:
  [[nodiscard]] static bool is_valid(const InkScene& scene, const View& view,
                                     const TileSplit& split);
  /// Draws the next item or picture of a job, in its group.
  void draw_in_group(InkJob& job, const InkStyle& style, Pixels target);
  /// Draws the next item of a job.
  void draw_item(InkJob& job, const InkStyle& style, Pixels target);
  bool fits(const InkScene& scene, const TileSplit& split, PixelRect part) const;
  bool make(const InkScene& scene, const View& view, PixelRect valid, const InkStyle& style,
            TileSplit& split);

  Rasterizer rasterizer_;
  std::vector<const SceneStroke*> found_;
};

}  // namespace felt
