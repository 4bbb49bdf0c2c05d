#pragma once

#include <cstddef>
#include <vector>

#include "felt/document/visible_strokes.h"
#include "felt/io/drawing_builder.h"

/// Drawings for tests, and their strokes by value.
namespace felt::testing {

/// Returns a drawing without a page: one layer, "Ink", with these strokes.
inline Drawing drawing_of(const std::vector<Stroke>& strokes) {
  DrawingBuilder builder;
  const std::size_t layer = builder.add_layer({"Ink"});
  for (const Stroke& stroke : strokes) builder.add(layer, stroke);
  return std::move(builder).build();
}

/// Returns the strokes of a layer, by its index.
inline std::vector<Stroke> strokes_in(const Document& document, std::size_t layer) {
  std::vector<Stroke> strokes;
  for (const StrokeId id : document.layers()[layer].strokes) strokes.push_back(*document.find(id));
  return strokes;
}

/// Returns all strokes, including those of hidden layers.
inline std::vector<Stroke> strokes_in(const Document& document) {
  std::vector<Stroke> strokes;
  for (std::size_t i = 0; i < document.layers().size(); ++i) {
    for (Stroke& stroke : strokes_in(document, i)) strokes.push_back(std::move(stroke));
  }
  return strokes;
}

/// Returns copies of these strokes.
inline std::vector<Stroke> by_value(const std::vector<StrokePtr>& strokes) {
  std::vector<Stroke> values;
  for (const StrokePtr& stroke : strokes) values.push_back(*stroke);
  return values;
}

}  // namespace felt::testing
