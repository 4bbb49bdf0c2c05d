#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "felt/document/drawing.h"

namespace felt {

/// Builds a drawing from layers and strokes in the order in which a file has them.
///
///   DrawingBuilder builder;
///   builder.drawing().page = page;
///   builder.drawing().has_page = true;
///   const std::size_t layer = builder.add_layer({name, visible, locked});
///   builder.add(layer, stroke, "s12");
///   return std::move(builder).build();
///
/// A stroke that is called "s12" becomes stroke 12, the first of that name; all others get ids
/// above the largest one, layer by layer in their order. So a file that was written with
/// stroke_name() comes back with its ids.
class DrawingBuilder {
 public:
  /// Everything but the document: page, materials, extras. It has no page until `has_page` is set.
  [[nodiscard]] Drawing& drawing() noexcept { return drawing_; }

  /// Adds a layer on top and returns its index. A layer without a name, or with one that is not
  /// UTF-8, holds a NUL or is too long, is called after its place: "Layer 3".
  std::size_t add_layer(LayerState state);
  [[nodiscard]] std::size_t layer_count() const noexcept { return layers_.size(); }
  /// Adds a stroke on top of that layer. Requires that the layer is there.
  void add(std::size_t layer, Stroke stroke, std::string_view name = {});
  /// The same for a stroke that another document holds as `id`, which it keeps.
  void add(std::size_t layer, StrokePtr stroke, StrokeId id);

  /// Returns the drawing. Without any layer it has an empty one, "Ink". A page beyond the size that
  /// pages may have gets the default size, a surface with an invalid name none.
  [[nodiscard]] Drawing build() &&;

 private:
  struct Entry {
    std::uint64_t id = 0;  // that it asks for; 0: any
    StrokePtr stroke;
  };
  struct NewLayer {
    LayerState state;
    std::vector<Entry> strokes;
  };
  [[nodiscard]] Edit edit() const;

  Drawing drawing_{.has_page = false};
  std::vector<NewLayer> layers_;
};

}  // namespace felt
