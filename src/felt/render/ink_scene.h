#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/render/ink_damage.h"
#include "felt/render/line_style.h"
#include "felt/render/picture_pixels.h"
#include "felt/render/scene_stroke.h"
#include "felt/render/stroke_grid.h"
#include "felt/render/stroke_order.h"

namespace felt {

/// A fill of an InkScene.
struct SceneFill {
  FillPtr fill;
  Rect box;  ///< bounds of the area
  LayerId layer;
};

/// A layer of an InkScene.
struct SceneLayer {
  LayerId id;
  bool is_visible = true;
  std::size_t position = 0;  ///< position among the layers; 0 is the lowest
  double opacity = 1.0;
  BlendMode blend = BlendMode::kNormal;
  LayerGroupPtr group;                          ///< null if the layer is in no group
  LayerPicturePtr picture;                      ///< null for most layers
  std::shared_ptr<const PicturePixels> pixels;  ///< of `picture`; null if it is damaged
  StrokeOrder order;
  StrokeGrid grid;
  std::vector<FillId> fills;  ///< the lowest first; all are below the strokes

  /// Returns true if the layer, or its group, must be drawn as a whole and then blended.
  [[nodiscard]] bool is_whole() const noexcept {
    return opacity < 1.0 || blend != BlendMode::kNormal || (group && group->is_whole());
  }
  /// Returns true if the layer, or its group, does not cover what is below it.
  [[nodiscard]] bool is_blended() const noexcept {
    return blend != BlendMode::kNormal || (group && group->blend != BlendMode::kNormal);
  }
  /// Returns true if drawing its strokes one by one does not give the picture of the layer.
  [[nodiscard]] bool is_special() const noexcept { return is_whole() || pixels; }
};

/// A stroke or a fill that was found in a scene: one of the two pointers is set.
struct SceneInk {
  const SceneStroke* stroke = nullptr;
  const SceneFill* fill = nullptr;
  const SceneLayer* layer = nullptr;  ///< the layer of either
};

/// Position of a stroke in the drawing order. A smaller value is drawn first.
struct InkHeight {
  std::size_t layer = 0;
  std::size_t rank = 0;

  friend constexpr auto operator<=>(const InkHeight&, const InkHeight&) noexcept = default;
};

/// A display's copy of a document. It is updated by the document's edits, and quickly finds the
/// strokes in a part of the page, in drawing order. Only opening a document and changing whole
/// layers take time linear in the size of the sketch. A preview is applied to this copy and is
/// undone when the next preview or edit arrives. Strokes that look the same before and after a
/// change are not reported as damage.
///
/// Not thread-safe. Strokes are shared with the document, which may be used on another thread.
class InkScene {
 public:
  InkScene() : InkScene(Document{}) {}
  explicit InkScene(const Document& document);
  InkScene(const InkScene&) = delete;
  InkScene& operator=(const InkScene&) = delete;

  /// Sets the styles with which the strokes are drawn; at first, those of the built-in media. If a
  /// part of a stroke with a style changes, all of it may look different and counts as damage.
  void set_styles(const StrokeStyles& styles) { styles_ = styles; }

  /// Applies an edit of the document and ends the preview. Adds the area to repaint to `damage`.
  /// Fails if Document::apply would fail; in that case the preview is removed, and nothing else
  /// changes.
  Result<void> apply(const Edit& edit, InkDamage& damage);
  /// Shows `preview` applied to the document, or the document itself if `preview` is empty. Damage
  /// and errors are the same as in apply().
  Result<void> show(const std::optional<Edit>& preview, InkDamage& damage);

  /// Replaces the content of `found` with all strokes that are in visible layers and have bounds
  /// touching the area, lowest first. The pointers are valid until the next change. If `above` is
  /// set, finds only strokes that cover that layer: those of the layers above it that are not
  /// blended (SceneLayer::is_blended).
  void find(const Rect& area, std::vector<const SceneStroke*>& found,
            std::optional<LayerId> above = {}) const;
  /// Does the same for strokes and fills. The fills of a layer come before its strokes.
  void find_ink(const Rect& area, std::vector<SceneInk>& found,
                std::optional<LayerId> above = {}) const;
  /// Returns the visible layers for which SceneLayer::is_special() is true, lowest first. If
  /// `above` is set, returns only those of the layers that find() uses then.
  [[nodiscard]] std::vector<const SceneLayer*> special_layers(
      std::optional<LayerId> above = {}) const;
  [[nodiscard]] static InkHeight height(const SceneStroke& stroke) noexcept {
    return {stroke.layer->position, stroke.rank()};
  }
  /// Returns the stroke, or null if the scene does not have it.
  [[nodiscard]] const SceneStroke* find(StrokeId id) const;
  /// Returns the ids of the strokes that the preview changes, ascending. The list also contains
  /// strokes that the preview removes and that are therefore not in the scene.
  [[nodiscard]] const std::vector<StrokeId>& previewed() const noexcept { return previewed_; }
  /// Returns true if the bounds of a fill of a visible layer touch the area.
  [[nodiscard]] bool has_fill(const Rect& area) const;
  /// Returns a number that changes with every change of the document, and with previews that change
  /// layers, but not with other previews.
  [[nodiscard]] std::uint64_t revision() const noexcept { return revision_; }

 private:
  /// A stroke as it looked before a change.
  struct Seen {
    StrokeId id;
    StrokePtr stroke;
    LayerId layer;
    bool is_visible = false;
    InkHeight height;
    std::size_t below = 0;  // unchanged strokes below it in its layer
  };
  using SeenStrokes = std::vector<Seen>;  // sorted by height
  /// A fill as it looked before a change; null if it was not visible.
  struct SeenFill {
    FillPtr fill;
    Rect box;
    InkHeight height;
  };
  using SeenFills = std::map<FillId, SeenFill>;
  using FillLists = std::map<LayerId, std::vector<FillId>>;

  [[nodiscard]] SeenStrokes look(const std::vector<StrokeId>& ids) const;
  void compare(SeenStrokes before, SeenStrokes after, InkDamage& damage) const;
  void add_seen(const Stroke& stroke, InkDamage& damage) const;
  void add_change(const Stroke& before, const Stroke& after, InkDamage& damage) const;
  void add_layers(const Edit& edit, InkDamage& damage) const;
  [[nodiscard]] SeenFills look_at_fills(const std::vector<FillId>& ids) const;
  static void compare_fills(const SeenFills& before, const SeenFills& after, InkDamage& damage);
  [[nodiscard]] Result<void> check(const Edit& edit) const;
  [[nodiscard]] Result<FillLists> new_fills(const Edit& edit) const;
  void change_fills(const Edit& edit);
  [[nodiscard]] Result<void> check_places(const Edit& edit) const;
  void set_look(SceneLayer& layer, const LayerState& state);
  [[nodiscard]] std::shared_ptr<const PicturePixels> pixels_of(const SceneLayer& layer) const;
  void carry_out(const Edit& edit);
  [[nodiscard]] Result<std::vector<LayerId>> new_order(const Edit& edit) const;
  void replace(const Edit& edit);
  void set_shape(SceneStroke& stroke, const StrokePtr& shape);
  void mark_previewed(bool on);
  Result<void> change(const Edit* next, bool is_preview, InkDamage& damage);

  std::map<StrokeId, SceneStroke> strokes_;
  std::map<FillId, SceneFill> fills_;
  std::map<LayerId, SceneLayer> layers_;
  std::vector<LayerId> layer_order_;  // lowest first
  std::optional<Edit> preview_;
  std::vector<StrokeId> previewed_;
  std::uint64_t revision_ = 0;
  StrokeStyles styles_;
};

}  // namespace felt
