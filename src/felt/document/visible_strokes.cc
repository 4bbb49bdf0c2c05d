#include "felt/document/visible_strokes.h"

#include <charconv>
#include <memory>
#include <utility>

namespace felt {

std::vector<StrokePtr> visible_strokes(const Document& document) {
  std::vector<StrokePtr> strokes;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) strokes.push_back(document.find(id));
  }
  return strokes;
}

const LayerPicture* exported_picture(const Layer& layer, PictureChoice pictures) noexcept {
  const bool is_shown = layer.picture && layer.visible &&
                        (pictures == PictureChoice::kAll || layer.picture->exported);
  return is_shown ? layer.picture.get() : nullptr;
}

VisibleInk visible_ink(const Document& document) {
  VisibleInk ink{visible_strokes(document), {}};
  std::map<StrokeId, StrokeId> numbers;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) numbers.emplace(id, StrokeId{numbers.size() + 1});
  }
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const FillId id : layer.fills) {
      RenamedFill renamed = with_other_strokes(*document.find_fill(id), numbers);
      ink.fills.push_back(std::make_shared<const Fill>(std::move(renamed.fill)));
    }
  }
  return ink;
}

RenamedFill with_other_strokes(Fill fill, const std::map<StrokeId, StrokeId>& new_ids) {
  bool is_complete = true;
  for (FillLoop& loop : fill.loops) {
    bool is_known = true;
    for (FillPiece& piece : loop.pieces) {
      if (!piece.stroke) continue;
      const auto found = new_ids.find(piece.stroke);
      is_known = is_known && found != new_ids.end();
      if (is_known) piece.stroke = found->second;
    }
    if (!is_known) loop.pieces.clear();
    is_complete = is_complete && is_known;
  }
  return {std::move(fill), is_complete};
}

bool goes_with_strokes(const Fill& fill, const std::function<bool(StrokeId)>& is_chosen) {
  bool has_stroke = false;
  for (const FillLoop& loop : fill.loops) {
    for (const FillPiece& piece : loop.pieces) {
      if (!piece.stroke) continue;
      if (!is_chosen(piece.stroke)) return false;
      has_stroke = true;
    }
  }
  return has_stroke;
}

Rect ink_bounds(const Document& document, LayerChoice layers) {
  Rect ink;
  for (const Layer& layer : document.layers()) {
    if (layers == LayerChoice::kVisible && !layer.visible) continue;
    for (const StrokeId id : layer.strokes) ink.extend(document.find(id)->bounds());
    for (const FillId id : layer.fills) ink.extend(fill_bounds(*document.find_fill(id)));
  }
  return ink;
}

namespace {

/// Returns 12 for "s12" if the letter is 's', and 0 for any other name.
std::uint64_t number_of_name(std::string_view name, char letter) noexcept {
  if (name.size() < 2 || name[0] != letter || name[1] == '0') return 0;
  constexpr std::uint64_t kLimit = std::uint64_t{1} << 40;
  std::uint64_t number = 0;
  const char* end = name.data() + name.size();
  const auto [rest, error] = std::from_chars(name.data() + 1, end, number);
  return error == std::errc() && rest == end && number < kLimit ? number : 0;
}

}  // namespace

std::string fill_name(FillId id) {
  return "f" + std::to_string(id.value);
}

std::string stroke_name(StrokeId id) {
  return "s" + std::to_string(id.value);
}

StrokeId stroke_id_of_name(std::string_view name) noexcept {
  return {number_of_name(name, 's')};
}

FillId fill_id_of_name(std::string_view name) noexcept {
  return {number_of_name(name, 'f')};
}

}  // namespace felt
