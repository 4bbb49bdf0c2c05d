#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/document/drawing.h"

namespace felt {

/// Builds a drawing from layers and strokes, which are added in the order of the file.
///
///   DrawingBuilder builder;
///   builder.drawing().page = page;
///   builder.drawing().has_page = true;
///   const std::size_t layer = builder.add_layer({name, visible, locked});
///   builder.add(layer, stroke, "s12");
///   return std::move(builder).build();
///
/// The first stroke named "s12" gets id 12. Strokes without such a name, and further strokes with
/// the same name, get new ids above the largest requested id, in the order of the layers and of the
/// strokes in each layer. The same applies to fills, with names like "f12". A file that was written
/// with stroke_name() therefore gets its ids back. Names of strokes that are not
/// those of their ids, such as "cat-1", are kept in Drawing::names.
class DrawingBuilder {
 public:
  /// Returns the drawing, so that the caller can set everything except its document: page,
  /// materials, extras. The drawing has no page unless the caller sets `has_page`.
  [[nodiscard]] Drawing& drawing() noexcept { return drawing_; }

  /// Adds a layer on top and returns its index. If the name is empty, too long, not UTF-8 or has a
  /// NUL, the layer is named after its position: "Layer 3". Neighbours with groups of the same id
  /// are in one group; build() numbers the groups from 1.
  std::size_t add_layer(LayerState state);
  /// Replaces the state of a layer. Requires an index from add_layer(); the name has the same
  /// rules.
  void set_state(std::size_t layer, LayerState state);
  [[nodiscard]] std::size_t layer_count() const noexcept { return layers_.size(); }
  /// Adds a stroke on top of the layer with the index `layer`. Requires an index from add_layer().
  /// If `number` has the form of stroke_name(), it gives the id instead of `name`.
  void add(std::size_t layer, Stroke stroke, std::string_view name = {},
           std::string_view number = {});
  /// Adds a stroke that has the id `id` in another document. The stroke keeps that id.
  void add(std::size_t layer, StrokePtr stroke, StrokeId id);

  /// Adds a fill on top of the fills of the layer, below all its strokes. Requires an index from
  /// add_layer() and a valid fill (check_fill).
  void add_fill(std::size_t layer, FillPtr fill, std::string_view name = {});

  /// Returns the drawing. If no layer was added, the drawing gets an empty layer, "Ink". If the
  /// page is larger than allowed, it gets the default size. If the name of the surface is invalid,
  /// the surface is dropped.
  [[nodiscard]] Drawing build() &&;

 private:
  struct Entry {
    std::uint64_t id = 0;  // the requested id; 0 if any id will do
    StrokePtr stroke;
    std::string name{};  // the name in the file, if it has one that files can have
  };
  struct NewLayer {
    LayerState state;
    std::vector<Entry> strokes;
    std::vector<std::pair<std::uint64_t, FillPtr>> fills{};  // with the requested ids
  };
  [[nodiscard]] Edit edit(StrokeNames& names) const;
  void number_groups();

  Drawing drawing_{.has_page = false};
  std::vector<NewLayer> layers_;
};

}  // namespace felt
