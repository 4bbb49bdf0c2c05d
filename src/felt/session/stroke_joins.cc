#include "felt/session/stroke_joins.h"

#include <algorithm>

#include "felt/geometry/nearest.h"

namespace felt {
namespace {

double rough_length_mm(const Stroke& stroke) {
  const std::vector<Point>& p = stroke.data().points;
  double length_mm = 0.0;
  for (std::size_t i = 1; i < p.size(); ++i) length_mm += distance(p[i - 1], p[i]);
  return length_mm;
}

bool changes_shape(const StrokeChange& c) {
  return !c.before || !c.after || c.before->data().points != c.after->data().points;
}

/// Returns true if the edit adds a stroke that is not a part of a stroke before the edit, or
/// replaces one by more than a part of it.
bool gains_ink(const StrokeChange& c, const Edit& edit) {
  if (!c.after || !changes_shape(c)) return false;
  if (c.before) return !is_piece_of(*c.after, *c.before);
  return std::none_of(edit.changes.begin(), edit.changes.end(), [&c](const StrokeChange& other) {
    return other.before && other.before != other.after && is_piece_of(*c.after, *other.before);
  });
}

enum class Loss { kNone, kPart, kAll };

/// Returns how much of the ink of a stroke remains at its place; `added` are the added strokes.
Loss loss_of(const StrokeChange& c, const std::vector<const StrokeChange*>& added) {
  if (!c.before || !changes_shape(c)) return Loss::kNone;
  const bool has_parts = std::any_of(added.begin(), added.end(), [&c](const StrokeChange* other) {
    return is_piece_of(*other->after, *c.before);
  });
  if (!c.after) return has_parts ? Loss::kPart : Loss::kAll;
  return has_parts || is_piece_of(*c.after, *c.before) ? Loss::kPart : Loss::kNone;
}

/// Returns true if the ink that a stroke lost can be in another stroke.
bool may_join(const StrokeChange& from, Loss loss, const StrokeChange& into) {
  if (loss == Loss::kPart && into.before) return false;  // a transform, for example
  return into.after->bounds().intersects(from.before->bounds());
}

void add_joins(const StrokeChange& from, Loss loss, const std::vector<const StrokeChange*>& gaining,
               std::vector<StrokeJoin>& joins) {
  if (loss == Loss::kNone) return;
  for (const StrokeChange* into : gaining) {
    if (may_join(from, loss, *into)) joins.push_back({from.id, into->id});
  }
}

}  // namespace

bool is_piece_of(const Stroke& part, const Stroke& whole) {
  constexpr double kOnLineMm = 0.01;  // as far as a piece may be from the stroke by rounding
  if (!part.bounds().intersects(whole.bounds())) return false;
  const int n = part.segment_count();
  for (const double u : {0.0, 0.5 * n, 1.0 * n}) {
    const Point p = part.position(u);
    bool is_near = false;
    for (int i = 0; i < whole.segment_count() && !is_near; ++i) {
      is_near = nearest_within(whole.segment(i), p, kOnLineMm * kOnLineMm).has_value();
    }
    if (!is_near) return false;
  }
  return true;
}

std::vector<StrokeJoin> stroke_joins(const Edit& edit) {
  const bool only_reshapes = std::all_of(edit.changes.begin(), edit.changes.end(),
                                         [](const StrokeChange& c) { return c.before && c.after; });
  if (only_reshapes) return {};
  std::vector<const StrokeChange*> added, gaining;
  for (const StrokeChange& c : edit.changes) {
    if (!c.before && c.after) added.push_back(&c);
    if (gains_ink(c, edit)) gaining.push_back(&c);
  }
  std::vector<StrokeJoin> joins;
  if (!gaining.empty()) {
    for (const StrokeChange& c : edit.changes) add_joins(c, loss_of(c, added), gaining, joins);
  }
  return joins;
}

StrokeId longest_remainder(const Edit& edit, StrokeId stroke) {
  const auto old = std::find_if(edit.changes.begin(), edit.changes.end(),
                                [stroke](const StrokeChange& c) { return c.id == stroke; });
  if (old == edit.changes.end() || !old->before) return {};
  StrokeId longest;
  double longest_mm = -1.0;
  const auto offer = [&](const StrokeChange& c) {
    const double mm = rough_length_mm(*c.after);
    if (mm <= longest_mm) return;
    longest_mm = mm;
    longest = c.id;
  };
  if (old->after) offer(*old);
  for (const StrokeChange& c : edit.changes) {
    if (!c.before && c.after && is_piece_of(*c.after, *old->before)) offer(c);
  }
  if (longest) return longest;
  const std::vector<StrokeJoin> joins = stroke_joins(edit);
  for (const StrokeChange& c : edit.changes) {
    const bool is_joined = std::any_of(joins.begin(), joins.end(), [&](const StrokeJoin& join) {
      return join.from == stroke && join.into == c.id;
    });
    if (is_joined) offer(c);
  }
  return longest;
}

}  // namespace felt
