#pragma once

#include <string>
#include <vector>

#include "felt/document/document.h"

namespace felt {

/// Makes an edit that fits a document, with the places worked out:
///
///   EditBuilder edit(document);
///   edit.remove(old);
///   edit.add(layer, stroke);
///   Edit done = std::move(edit).build("Erase");
///
/// The document must not change in between, and each stroke is named at most once.
class EditBuilder {
 public:
  explicit EditBuilder(const Document& document) noexcept : document_(document) {}

  /// A new stroke on top of its layer; several come in order. Requires that the layer is there.
  StrokeId add(LayerId layer, StrokePtr stroke);
  /// Another shape for a stroke, in its place. Requires that it is there.
  void replace(StrokeId id, StrokePtr stroke);
  /// Requires that it is there.
  void remove(StrokeId id);

  /// Linear in the changes and in the layers they touch.
  [[nodiscard]] Edit build(std::string label) &&;

 private:
  void find_places();

  const Document& document_;
  std::vector<StrokeChange> changes_;
  std::uint64_t made_ = 0;
};

}  // namespace felt
