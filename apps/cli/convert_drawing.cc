#include "convert_drawing.h"

#include <algorithm>
#include <charconv>
#include <utility>
#include <vector>

#include "felt/formats/layered_drawing.h"

namespace felt::cli {
namespace {

/// The layer of a number or a name; layers.size() where there is none.
std::size_t find_layer(std::string_view text, const std::vector<SketchLayer>& layers) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc() && end == text.data() + text.size()) {
    return number >= 1 && number <= layers.size() ? number - 1 : layers.size();
  }
  const auto named = std::find_if(layers.begin(), layers.end(),
                                  [text](const SketchLayer& l) { return l.name == text; });
  return static_cast<std::size_t>(named - layers.begin());
}

tl::unexpected<Error> no_layer(std::string_view text, const std::vector<SketchLayer>& layers) {
  constexpr std::size_t kMostNamed = 20;
  std::string there;
  for (std::size_t i = 0; i < std::min(layers.size(), kMostNamed); ++i) {
    there += (i > 0 ? ", " : "") + std::to_string(i + 1) + " '" + layers[i].name + "'";
  }
  if (layers.size() > kMostNamed) there += ", ...";
  return fail(ErrorCode::kNotFound,
              "--layers: there is no layer '" + std::string(text) + "'; there are " + there);
}

/// Which layers stay, by their place.
Result<std::vector<bool>> chosen_layers(const std::string& text,
                                        const std::vector<SketchLayer>& layers) {
  std::vector<bool> chosen(layers.size(), text == "all");
  if (text == "all") return chosen;
  if (text == "visible") {
    for (std::size_t i = 0; i < layers.size(); ++i) chosen[i] = layers[i].visible;
    return chosen;
  }
  // The name of one layer may hold commas.
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

}  // namespace

Result<void> choose_layers(const std::string& text, StoredDrawing& drawing) {
  if (text.empty()) return {};
  LayeredSketch sketch = layered_sketch(drawing);
  const Result<std::vector<bool>> chosen = chosen_layers(text, sketch.layers);
  if (!chosen) return tl::unexpected(chosen.error());
  LayeredSketch kept;
  kept.page = sketch.page;
  for (std::size_t i = 0; i < sketch.layers.size(); ++i) {
    if (!(*chosen)[i]) continue;
    kept.layers.push_back(std::move(sketch.layers[i]));
    kept.layers.back().visible = true;
  }
  StoredDrawing result = stored_drawing(std::move(kept));
  drawing.document = std::move(result.document);
  drawing.layer = {};
  return {};
}

}  // namespace felt::cli
