#include "convert_drawing.h"

#include <algorithm>
#include <charconv>
#include <span>
#include <utility>
#include <vector>

#include "felt/document/visible_strokes.h"
#include "felt/io/drawing_builder.h"

namespace felt::cli {
namespace {

/// Returns the index of the layer with this number or name, or layers.size() if it does not exist.
std::size_t find_layer(std::string_view text, std::span<const Layer> layers) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size()) {
    return number >= 1 && number <= layers.size() ? number - 1 : layers.size();
  }
  const auto named =
      std::find_if(layers.begin(), layers.end(), [text](const Layer& l) { return l.name == text; });
  return static_cast<std::size_t>(named - layers.begin());
}

tl::unexpected<Error> no_layer(std::string_view text, std::span<const Layer> layers) {
  constexpr std::size_t kMaxNamed = 20;
  std::string there;
  for (std::size_t i = 0; i < std::min(layers.size(), kMaxNamed); ++i) {
    there += (i > 0 ? ", " : "") + std::to_string(i + 1) + " '" + layers[i].name + "'";
  }
  if (layers.size() > kMaxNamed) there += ", ...";
  return fail(ErrorCode::kNotFound, "--layers: layer '" + std::string(text) +
                                        "' does not exist; the layers are " + there);
}

/// Returns for each layer whether it is kept.
Result<std::vector<bool>> chosen_layers(const std::string& text, std::span<const Layer> layers) {
  std::vector<bool> chosen(layers.size(), text == "all");
  if (text == "all") return chosen;
  if (text == "visible") {
    for (std::size_t i = 0; i < layers.size(); ++i) chosen[i] = layers[i].visible;
    return chosen;
  }
  // The name of a layer may contain commas.
  if (const std::size_t one = find_layer(text, layers); one < layers.size()) {
    chosen[one] = true;
    return chosen;
  }
  for (std::string_view rest = text;;) {
    const std::string_view word = rest.substr(0, rest.find(','));
    const std::size_t layer = find_layer(word, layers);
    if (layer == layers.size()) return no_layer(word, layers);
    chosen[layer] = true;
    if (word.size() == rest.size()) return chosen;
    rest.remove_prefix(word.size() + 1);
  }
}

/// Returns the state of a chosen layer, which is visible even if the layer or its group was hidden.
LayerState shown_state(const Layer& layer) {
  LayerState state = layer.state();
  state.visible = true;
  if (state.group && !state.group->visible) {
    LayerGroup group = *state.group;
    group.visible = true;
    state.group = std::make_shared<const LayerGroup>(std::move(group));
  }
  return state;
}

/// Returns an edit that adds to `chosen` what is in no layer of `document`: guides, edits of the
/// body, and the symmetry groups of strokes that are still there.
Edit unlayered_objects(const Document& document, const Document& chosen) {
  Edit edit{"Choose layers", {}};
  for (const auto& [id, guide] : document.guides()) edit.guides.push_back({id, nullptr, guide});
  for (const auto& [id, body] : document.body_edits()) {
    edit.body_edits.push_back({id, nullptr, body});
  }
  for (const auto& [id, group] : document.symmetries()) {
    SymmetryGroup kept = *group;
    std::erase_if(kept.images, [&](const SymmetryImage& i) { return !chosen.find(i.stroke); });
    if (kept.images.size() < 2) continue;
    edit.symmetries.push_back(
        {id, nullptr, std::make_shared<const SymmetryGroup>(std::move(kept))});
  }
  edit.toggles_guides = document.shows_guides() != chosen.shows_guides();
  return edit;
}

}  // namespace

Result<void> choose_layers(const std::string& text, Drawing& drawing) {
  if (text.empty()) return {};
  const Document& document = drawing.document;
  const Result<std::vector<bool>> chosen = chosen_layers(text, document.layers());
  if (!chosen) return tl::unexpected(chosen.error());
  DrawingBuilder builder;
  for (std::size_t i = 0; i < document.layers().size(); ++i) {
    if (!(*chosen)[i]) continue;
    const Layer& layer = document.layers()[i];
    const std::size_t kept = builder.add_layer(shown_state(layer));
    for (const StrokeId id : layer.strokes) builder.add(kept, document.find(id), id);
    for (const FillId id : layer.fills) {
      builder.add_fill(kept, document.find_fill(id), fill_name(id));
    }
  }
  Document kept = std::move(builder).build().document;
  if (Result<void> added = kept.apply(unlayered_objects(document, kept)); !added) return added;
  drawing.document = std::move(kept);
  drawing.layer = {};
  return {};
}

}  // namespace felt::cli
