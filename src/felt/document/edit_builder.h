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

/// Says what becomes of one stroke, again and again while a gesture lasts, without looking its
/// place up each time: previews at 1 kHz in a layer of 10^5 strokes. The document must not change.
class StrokeReplacement {
 public:
  /// Linear in the layer. Requires that the stroke is there.
  StrokeReplacement(const Document& document, StrokeId id);

  [[nodiscard]] StrokeId id() const noexcept { return id_; }
  /// The stroke as it is in the document.
  [[nodiscard]] const StrokePtr& before() const noexcept { return before_; }
  /// The stroke becomes this, in its place; null removes it.
  [[nodiscard]] Edit with(StrokePtr after, std::string label) const;

 private:
  StrokeId id_;
  StrokePtr before_;
  StrokePlace place_;
};

}  // namespace felt
