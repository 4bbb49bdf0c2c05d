#include "felt/tactile/seen_ink.h"

#include <algorithm>
#include <cmath>

namespace felt {

bool is_seen(Rgba ink, double opacity, Rgba paper) noexcept {
  if (paper.a == 0) paper = {255, 255, 255, 255};
  const double alpha = opacity * ink.a / 255.0;
  const auto difference = [&](int of_ink, int of_paper) {
    return alpha * std::abs(static_cast<double>(of_ink - of_paper));
  };
  return std::max({difference(ink.r, paper.r), difference(ink.g, paper.g),
                   difference(ink.b, paper.b)}) > kUnseenLevels;
}

double layer_opacity(const Layer& layer) noexcept {
  return layer.opacity * (layer.group ? layer.group->opacity : 1.0);
}

UnseenInk unseen_ink(const Document& document, Rgba paper) {
  UnseenInk unseen;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    const double opacity = layer_opacity(layer);
    for (const StrokeId id : layer.strokes) {
      if (!is_seen(document.find(id)->color(), opacity, paper)) unseen.strokes.push_back(id);
    }
    for (const FillId id : layer.fills) {
      if (!is_seen(document.find_fill(id)->color, opacity, paper)) unseen.fills.push_back(id);
    }
  }
  return unseen;
}

Rect seen_bounds(const Document& document, Rgba paper) {
  Rect bounds;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    const double opacity = layer_opacity(layer);
    for (const StrokeId id : layer.strokes) {
      const StrokePtr stroke = document.find(id);
      if (is_seen(stroke->color(), opacity, paper)) bounds.extend(stroke->bounds());
    }
    for (const FillId id : layer.fills) {
      const FillPtr fill = document.find_fill(id);
      if (is_seen(fill->color, opacity, paper)) bounds.extend(fill_bounds(*fill));
    }
  }
  return bounds;
}

}  // namespace felt
