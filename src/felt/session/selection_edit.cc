#include "felt/session/selection_edit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "felt/document/copy_limit.h"
#include "felt/document/edit_builder.h"
#include "felt/document/visible_strokes.h"
#include "felt/stroke/color_text.h"
#include "felt/stroke/edit/mend_joints.h"

namespace felt {
namespace {

/// What a restyle event says, parsed.
struct RestyledInk {
  std::optional<Rgba> color;
  std::string medium;
  std::optional<std::uint8_t> alpha;
  std::optional<double> width_factor;

  void apply(StrokeData& data) const {
    if (color) data.color = *color;
    if (alpha) data.color.a = *alpha;
    if (!medium.empty()) data.medium = medium;
    if (!width_factor) return;
    for (WidthKnot& knot : data.widths) {
      const double broadest_mm = std::max(kMaxRestyledWidthMm, knot.width_mm);
      knot.width_mm = std::clamp(*width_factor * knot.width_mm, kMinWidthMm, broadest_mm);
    }
  }
};

Result<RestyledInk> restyled_ink(const RestyleEvent& event) {
  RestyledInk ink{color_from_text(event.color), event.medium, {}, event.width_factor};
  if (!event.color.empty() && !ink.color) {
    return fail(ErrorCode::kInvalidArgument,
                "color: \"" + event.color + "\" is not a colour like #1f2933");
  }
  if (event.opacity) {
    if (!(*event.opacity >= 0.0 && *event.opacity <= 1.0)) {
      return fail(ErrorCode::kInvalidArgument, "opacity: is not a number from 0 to 1");
    }
    ink.alpha = static_cast<std::uint8_t>(std::lround(255.0 * *event.opacity));
  }
  const double factor = event.width_factor.value_or(1.0);
  if (!(factor >= RestyleEvent::kMinWidthFactor && factor <= RestyleEvent::kMaxWidthFactor)) {
    return fail(ErrorCode::kInvalidArgument, "width: is not a factor from 0.01 to 100");
  }
  return ink;
}

}  // namespace

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
  const auto is_chosen = [&](StrokeId id) { return selection.is_whole(id); };
  InkSize size;
  for (const auto& [id, marks] : selection.strokes()) {
    if (is_chosen(id)) size.add(*document.find(id));
  }
  std::vector<std::pair<LayerId, FillPtr>> fills;  // those that go along
  for (const Layer& layer : document.layers()) {
    for (const FillId id : layer.fills) {
      FillPtr fill = document.find_fill(id);
      if (layer.locked || !goes_with_strokes(*fill, is_chosen)) continue;
      size.add(*fill);
      fills.emplace_back(layer.id, std::move(fill));
    }
  }
  if (Result<void> fits = check_copies(document, size); !fits) {
    return tl::unexpected(fits.error());
  }
  const Vec shift{kDuplicateShiftMm, kDuplicateShiftMm};
  std::map<StrokeId, StrokeId> copies;
  // Visits the strokes in drawing order, because a selection does not store it.
  for (const Layer& layer : document.layers()) {
    for (const StrokeId id : layer.strokes) {
      if (!is_chosen(id)) continue;
      StrokeData data = document.find(id)->data();
      for (Point& p : data.points) p = p + shift;
      Result<Stroke> copy = Stroke::create(std::move(data));
      if (!copy) {
        return tl::unexpected(
            with_context(copy.error(), "stroke " + std::to_string(id.value) + ", shifted"));
      }
      copies[id] = builder.add(layer.id, std::make_shared<const Stroke>(*std::move(copy)));
    }
  }
  for (const auto& [layer, fill] : fills) {
    RenamedFill copy = with_other_strokes(*fill, copies);
    for (FillLoop& loop : copy.fill.loops) {
      for (Point& p : loop.points) p = p + shift;
    }
    builder.add_fill(layer, std::make_shared<const Fill>(std::move(copy.fill)));
  }
  return std::move(builder).build("Duplicate");
}

Result<void> check_move(const MoveEvent& event) {
  const Vec by = event.by_mm;
  if (std::abs(by.x) <= MoveEvent::kMaxMm && std::abs(by.y) <= MoveEvent::kMaxMm) return {};
  return fail(ErrorCode::kInvalidArgument, "move: is farther than 10000 mm");
}

Result<MoveEdit> move_edit(const Scene& scene, Vec by_mm) {
  Selection whole;
  for (const auto& [id, marks] : scene.selection.strokes()) {
    if (scene.selection.is_whole(id)) whole.set_whole(id, marks.size());
  }
  const MovedStrokes strokes(scene.document, scene.index, whole, false);
  if (strokes.empty() || by_mm == Vec{}) return MoveEdit{};
  MoveEdit move{strokes.finished(translation(by_mm), 1.0, "Move")};
  if (move.edit.empty()) {
    // Far from the origin, rounding may break an invariant, which this mends.
    Result<Edit> alone = move_alone_edit(scene.document, scene.selection, by_mm);
    if (!alone) return tl::unexpected(alone.error());
    return MoveEdit{*std::move(alone)};
  }
  if (auto pull = strokes.connected_pull()) pull->complete(move.edit, scene);
  move.selection = strokes.selection_after(move.edit, scene.selection);
  return move;
}

Result<Edit> move_alone_edit(const Document& document, const Selection& selection, Vec by_mm) {
  EditBuilder builder(document);
  if (by_mm == Vec{}) return std::move(builder).build("Move");
  for (const auto& [id, marks] : selection.strokes()) {
    if (!selection.is_whole(id)) continue;
    StrokeData data = document.find(id)->data();
    for (Point& p : data.points) p = p + by_mm;
    mend_rounding(data);
    Result<Stroke> moved = Stroke::create(std::move(data));
    if (!moved) return tl::unexpected(with_context(moved.error(), "move"));
    builder.replace(id, std::make_shared<const Stroke>(*std::move(moved)));
  }
  return std::move(builder).build("Move");
}

Edit order_edit(const Document& document, const Selection& selection, OrderEvent::To to) {
  const bool to_front = to == OrderEvent::To::kFront;
  Edit edit{to_front ? "Bring to front" : "Send to back", {}};
  for (const Layer& layer : document.layers()) {
    const auto is_moved = [&](StrokeId id) { return selection.is_whole(id); };
    const auto count = static_cast<std::size_t>(
        std::count_if(layer.strokes.begin(), layer.strokes.end(), is_moved));
    std::size_t index = to_front ? layer.strokes.size() - count : 0;
    for (std::size_t i = 0; i < layer.strokes.size(); ++i) {
      const StrokeId id = layer.strokes[i];
      if (!is_moved(id)) continue;
      const StrokePtr stroke = document.find(id);
      edit.changes.push_back({id, stroke, stroke, {layer.id, i}, {layer.id, index++}});
    }
  }
  const auto stays = [](const StrokeChange& c) { return c.before_place == c.after_place; };
  if (std::all_of(edit.changes.begin(), edit.changes.end(), stays)) edit.changes.clear();
  return edit;
}

Result<Edit> restyle_edit(const Document& document, const Selection& selection,
                          const RestyleEvent& event) {
  const Result<RestyledInk> ink = restyled_ink(event);
  if (!ink) return tl::unexpected(with_context(ink.error(), "restyle"));
  EditBuilder builder(document);
  for (const auto& [id, marks] : selection.strokes()) {
    const StrokePtr stroke = document.find(id);
    if (!stroke) continue;
    StrokeData data = stroke->data();
    ink->apply(data);
    if (data == stroke->data()) continue;
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
