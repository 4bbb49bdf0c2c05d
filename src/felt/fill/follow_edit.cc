#include "felt/fill/follow_edit.h"

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "felt/document/edit_builder.h"
#include "felt/geometry/nearest.h"

namespace felt {
namespace {

constexpr double kSameLineMm = 0.01;  // parts of a divided stroke lie this near to it

/// Returns true if a point in the middle of `part` is on `whole`.
bool lies_on(const Stroke& part, const Stroke& whole) {
  if (!part.bounds().intersects(whole.bounds())) return false;
  const Point middle = part.position(0.5 * part.segment_count());
  for (int i = 0; i < whole.segment_count(); ++i) {
    if (nearest_within(whole.segment(i), middle, kSameLineMm * kSameLineMm)) return true;
  }
  return false;
}

bool has_changed_piece(const Fill& fill, const std::set<StrokeId>& changed) {
  for (const FillLoop& loop : fill.loops) {
    for (const FillPiece& piece : loop.pieces) {
      if (piece.stroke && changed.contains(piece.stroke)) return true;
    }
  }
  return false;
}

/// Returns the strokes whose shape the edit changes or removes.
std::set<StrokeId> changed_strokes(const Edit& edit) {
  std::set<StrokeId> changed;
  for (const StrokeChange& c : edit.changes) {
    if (c.before && c.before != c.after) changed.insert(c.id);
  }
  return changed;
}

/// Returns the layers in which the places of fills depend on the edit.
std::set<LayerId> layers_with_changed_fills(const Edit& edit) {
  std::set<LayerId> layers;
  for (const FillChange& c : edit.fills) {
    if (c.before) layers.insert(c.before_place.layer);
    if (c.after) layers.insert(c.after_place.layer);
  }
  return layers;
}

}  // namespace

std::vector<LineEdit> line_edits(const Edit& edit) {
  std::vector<const StrokeChange*> added, present;
  for (const StrokeChange& c : edit.changes) {
    if (!c.after || c.before == c.after) continue;
    present.push_back(&c);
    if (!c.before) added.push_back(&c);
  }
  std::vector<LineEdit> edits;
  for (const StrokeChange& old : edit.changes) {
    if (!old.before || old.before == old.after) continue;
    LineEdit line{old.id, old.before, {}};
    if (old.after) line.after.push_back(old.id);
    for (const StrokeChange* other : old.after ? added : present) {
      const bool is_part = !other->before && lies_on(*other->after, *old.before);
      const bool is_joined = !old.after && lies_on(*old.before, *other->after);
      if (is_part || is_joined) line.after.push_back(other->id);
    }
    // A stroke that only changed its shape needs no entry.
    if (!old.after || line.after.size() > 1) edits.push_back(std::move(line));
  }
  return edits;
}

std::vector<FillChange> following_fills(const Document& document, const Edit& edit,
                                        DocumentMap& map, WhenOpened when_opened) {
  const std::set<StrokeId> changed = changed_strokes(edit);
  if (changed.empty() || document.fill_count() == 0) return {};
  const std::set<LayerId> left_out = layers_with_changed_fills(edit);
  std::vector<FillId> affected;
  Rect area;
  for (const Layer& layer : document.layers()) {
    if (layer.locked || left_out.contains(layer.id)) continue;
    for (const FillId id : layer.fills) {
      const FillPtr fill = document.find_fill(id);
      if (!has_changed_piece(*fill, changed)) continue;
      affected.push_back(id);
      area.extend(fill_bounds(*fill));
    }
  }
  if (affected.empty()) return {};
  for (const StrokeChange& c : edit.changes) {
    if (c.after && changed.contains(c.id)) area.extend(c.after->bounds());
  }
  FillMap* now = map.after(document, edit, area);
  if (!now) return {};
  const std::vector<LineEdit> lines = line_edits(edit);
  EditBuilder builder(document);
  for (const FillId id : affected) {
    const FillPtr fill = document.find_fill(id);
    std::optional<Fill> followed = follow_fill(*fill, *now, lines, when_opened);
    if (!followed || !check_fill(*followed)) {
      builder.remove_fill(id);
    } else if (*followed != *fill) {
      builder.replace_fill(id, std::make_shared<const Fill>(*std::move(followed)));
    }
  }
  return std::move(builder).build({}).fills;
}

}  // namespace felt
