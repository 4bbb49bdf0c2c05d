#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/render/ink_damage.h"
#include "felt/render/scene_stroke.h"
#include "felt/render/stroke_grid.h"
#include "felt/render/stroke_order.h"

namespace felt {

/// A layer of a display.
struct SceneLayer {
  LayerId id;
  bool is_visible = true;
  std::size_t position = 0;  ///< among the layers, 0 is the lowest
  StrokeOrder order;
  StrokeGrid grid;
};

/// How high a stroke lies: compares as what is drawn first compares with what is drawn later.
struct InkHeight {
  std::size_t layer = 0;
  std::size_t rank = 0;

  friend constexpr auto operator<=>(const InkHeight&, const InkHeight&) noexcept = default;
};

/// What a display knows of a document: it follows it by its edits, and says at once which strokes a
/// part of the sheet shows, in drawing order. Nothing in here is linear in the sketch but opening
/// it and changes of whole layers. A preview is carried out in here too, and taken back when the
/// next one or an edit comes; only what looks different after that is damage.
///
/// One thread. Strokes are shared with the document, which may live elsewhere.
class InkScene {
 public:
  InkScene() : InkScene(Document{}) {}
  explicit InkScene(const Document& document);
  InkScene(const InkScene&) = delete;
  InkScene& operator=(const InkScene&) = delete;

  /// The document took this edit. The preview is over. Adds what must be painted again to `damage`.
  /// Error: it does not fit, as Document::apply would say; then only the preview is gone.
  Result<void> apply(const Edit& edit, InkDamage& damage);
  /// The document with this edit is to be seen, or, without one, as it is. Likewise.
  Result<void> show(const std::optional<Edit>& preview, InkDamage& damage);

  /// Replaces `found` by the strokes of visible layers whose boxes touch the area, lowest first.
  /// They are there until the next change. `above`: only of the layers above that one.
  void find(const Rect& area, std::vector<const SceneStroke*>& found,
            std::optional<LayerId> above = {}) const;
  [[nodiscard]] static InkHeight height(const SceneStroke& stroke) noexcept {
    return {stroke.layer->position, stroke.rank()};
  }
  /// The stroke, or null.
  [[nodiscard]] const SceneStroke* find(StrokeId id) const;
  /// The strokes that the preview changes, ascending; some may not be there.
  [[nodiscard]] const std::vector<StrokeId>& previewed() const noexcept { return previewed_; }
  /// Another number whenever the document changed, previews aside.
  [[nodiscard]] std::uint64_t revision() const noexcept { return revision_; }

 private:
  /// A stroke as it was seen before a change.
  struct Seen {
    StrokeId id;
    StrokePtr stroke;
    LayerId layer;
    bool is_visible = false;
    InkHeight height;
    std::size_t below = 0;  // strokes below it in its layer that do not change
  };
  using SeenStrokes = std::vector<Seen>;  // by height

  [[nodiscard]] SeenStrokes look(const std::vector<StrokeId>& ids) const;
  static void compare(SeenStrokes before, SeenStrokes after, InkDamage& damage);
  void add_layers(const Edit& edit, InkDamage& damage) const;
  [[nodiscard]] Result<void> check(const Edit& edit) const;
  [[nodiscard]] Result<void> check_places(const Edit& edit) const;
  void carry_out(const Edit& edit);
  [[nodiscard]] Result<std::vector<LayerId>> new_order(const Edit& edit) const;
  void replace(const Edit& edit);
  void set_shape(SceneStroke& stroke, const StrokePtr& shape);
  void mark_previewed(bool on);
  Result<void> change(const Edit* next, bool is_preview, InkDamage& damage);

  std::map<StrokeId, SceneStroke> strokes_;
  std::map<LayerId, SceneLayer> layers_;
  std::vector<LayerId> layer_order_;  // the lowest first
  std::optional<Edit> preview_;
  std::vector<StrokeId> previewed_;
  std::uint64_t revision_ = 0;
};

}  // namespace felt
