#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "felt/document/edit.h"

namespace felt {

/// Maximum number of layers of a drawing. Files have no more, and events add no more.
inline constexpr std::size_t kMaxLayers = 10'000;

/// A layer: its strokes and fills in drawing order, and its state (LayerState). All fills are below
/// all strokes of the layer.
struct Layer {
  LayerId id;
  std::string name;
  bool visible = true;  ///< the layer and its group are visible
  bool locked = false;  ///< the layer or its group is locked
  double opacity = 1.0;
  LayerPicturePtr picture = {};
  BlendMode blend = BlendMode::kNormal;
  LayerGroupPtr group = {};
  std::vector<StrokeId> strokes;  ///< the lowest first
  std::vector<FillId> fills{};    ///< the lowest first
  bool own_visible = true;        ///< without its group
  bool own_locked = false;        ///< without its group
  KeyTimingPtr timing = {};

  [[nodiscard]] LayerState state() const {
    return {name, own_visible, own_locked, opacity, picture, blend, group, timing};
  }
  friend bool operator==(const Layer& a, const Layer& b) {
    return a.id == b.id && a.state() == b.state() && a.strokes == b.strokes && a.fills == b.fills;
  }
};

/// The layers of a document in their order, which are found by their ids in constant time.
class LayerTable {
 public:
  explicit LayerTable(Layer first);

  /// Returns the layers, the lowest first.
  [[nodiscard]] std::span<const Layer> layers() const noexcept { return layers_; }
  /// Returns the ids of layers().
  [[nodiscard]] std::span<const LayerId> ids() const noexcept { return ids_; }
  [[nodiscard]] std::size_t size() const noexcept { return layers_.size(); }
  /// Returns the index of a layer, or size() if the id is unknown.
  [[nodiscard]] std::size_t index_of(LayerId id) const noexcept;
  /// Returns a layer, or null if the id is unknown. Valid until rearrange().
  [[nodiscard]] const Layer* find(LayerId id) const noexcept;
  [[nodiscard]] Layer* find(LayerId id) noexcept;

  /// The change of the position of one layer: it is added (`from` is empty), removed (`to` is
  /// empty) or moved. `from` is the index before all moves, `to` the index after all moves.
  struct Move {
    LayerId id;
    std::optional<std::size_t> from;
    std::optional<std::size_t> to;
  };
  /// Moves layers; an added layer has only its id. The other layers keep their order. Requires that
  /// the ids are different and that Moves::reorder() accepts the moves. Takes linear time in the
  /// layers from the lowest move on.
  void rearrange(std::span<const Move> moves);
  /// Returns the number of layers that rearrange() has moved in memory so far.
  [[nodiscard]] std::uint64_t moved_count() const noexcept { return moved_; }

 private:
  void number_from(std::size_t index);

  std::vector<Layer> layers_;
  std::vector<LayerId> ids_;                                // of layers_
  std::unordered_map<std::uint64_t, std::size_t> indices_;  // by id; never iterated
  std::uint64_t moved_ = 0;
};

}  // namespace felt
