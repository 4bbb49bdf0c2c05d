#include "felt/session/selection_edit.h"

#include <utility>

#include "felt/document/edit_builder.h"

namespace felt {

Selection selected(const Document& document, const Selection& before, SelectStrokes::What what) {
  using What = SelectStrokes::What;
  if (what == What::kNone) return {};
  Selection after = select_all(document);
  if (what == What::kInvert) {
    for (const auto& [id, marks] : before.strokes()) {
      if (before.is_whole(id)) after.remove(id);
    }
  }
  return after;
}

Edit delete_edit(const Document& document, const Selection& selection) {
  EditBuilder builder(document);
  for (const auto& [id, marks] : selection.strokes()) {
    if (selection.is_whole(id)) builder.remove(id);
  }
  return std::move(builder).build("Delete");
}

Result<Edit> duplicate_edit(const Document& document, const Selection& selection) {
  EditBuilder builder(document);
  if (selection.empty()) return std::move(builder).build("Duplicate");
  // Visits the strokes in drawing order, because a selection does not store it.
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) {
      if (!selection.is_whole(id)) continue;
      StrokeData data = document.find(id)->data();
      for (Point& p : data.points) p = p + Vec{kDuplicateShiftMm, kDuplicateShiftMm};
      Result<Stroke> copy = Stroke::create(std::move(data));
      if (!copy) {
        return tl::unexpected(
            with_context(copy.error(), "stroke " + std::to_string(id.value) + ", shifted"));
      }
      builder.add(layer.id, std::make_shared<const Stroke>(*std::move(copy)));
    }
  }
  return std::move(builder).build("Duplicate");
}

Result<Edit> restyle_edit(const Document& document, const Selection& selection,
                          std::optional<Rgba> color, const std::string& medium) {
  EditBuilder builder(document);
  for (const auto& [id, marks] : selection.strokes()) {
    const StrokePtr stroke = document.find(id);
    if (!stroke) continue;
    const bool is_so =
        (!color || stroke->color() == *color) && (medium.empty() || stroke->medium() == medium);
    if (is_so) continue;
    StrokeData data = stroke->data();
    if (color) data.color = *color;
    if (!medium.empty()) data.medium = medium;
    Result<Stroke> changed = Stroke::create(std::move(data));
    if (!changed) return tl::unexpected(with_context(changed.error(), "restyle"));
    builder.replace(id, std::make_shared<const Stroke>(*std::move(changed)));
  }
  return std::move(builder).build("Restyle");
}

Selection made_by(const Edit& edit) {
  Selection made;
  for (const StrokeChange& c : edit.changes) {
    if (!c.before && c.after) made.set_whole(c.id, c.after->data().points.size());
  }
  return made;
}

}  // namespace felt
