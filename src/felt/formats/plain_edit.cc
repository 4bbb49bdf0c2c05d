#include "felt/formats/plain_edit.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "felt/stroke/edit/corner_trips.h"

namespace felt {
namespace {

double opacity_of(const Layer& layer) {
  return layer.opacity * (layer.group ? layer.group->opacity : 1.0);
}

/// Returns the stroke with this opacity, or nullptr if nothing changes.
StrokePtr plain_stroke(const Stroke& stroke, double opacity) {
  std::optional<Stroke> plain = without_corner_trips(stroke);
  if (opacity != 1.0) {
    StrokeData data = (plain ? *plain : stroke).data();
    data.color.a = static_cast<std::uint8_t>(std::lround(opacity * data.color.a));
    plain = Stroke::create(std::move(data)).value();
  }
  return plain ? std::make_shared<const Stroke>(*std::move(plain)) : nullptr;
}

/// Adds the change of a layer to an edit: its opacity and that of its group go to its strokes and
/// fills. Where those of such a layer overlap, they show through.
void make_plain(const Document& document, std::size_t at, Edit& edit) {
  const Layer& layer = document.layers()[at];
  const double opacity = opacity_of(layer);
  if (opacity != 1.0) {
    LayerState state = layer.state();
    state.opacity = 1.0;
    if (state.group) {
      LayerGroup group = *state.group;
      group.opacity = 1.0;
      state.group = std::make_shared<const LayerGroup>(std::move(group));
    }
    edit.layers.push_back({layer.id, layer.state(), std::move(state), at, at});
  }
  for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
    const StrokePtr stroke = document.find(layer.strokes[i]);
    StrokePtr plain = plain_stroke(*stroke, opacity);
    const StrokePlace place{layer.id, i};
    if (plain) edit.changes.push_back({layer.strokes[i], stroke, std::move(plain), place, place});
  }
  for (std::size_t i = 0; opacity != 1.0 && i < layer.fills.size(); ++i) {
    const FillPtr fill = document.find_fill(layer.fills[i]);
    Fill other = *fill;
    other.color.a = static_cast<std::uint8_t>(std::lround(opacity * other.color.a));
    const StrokePlace place{layer.id, i};
    edit.fills.push_back(
        {layer.fills[i], fill, std::make_shared<const Fill>(std::move(other)), place, place});
  }
}

}  // namespace

Edit plain_edit(const Document& document, FileFormat format) {
  Edit edit{"Make plain", {}, {}};
  if (format != FileFormat::kXopp && format != FileFormat::kNdjson) return edit;
  for (std::size_t i = 0; i < document.layers().size(); ++i) make_plain(document, i, edit);
  return edit;
}

}  // namespace felt
