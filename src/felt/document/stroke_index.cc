#include "felt/document/stroke_index.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace felt {
namespace {

constexpr std::array kTips = {StrokeTip::kStart, StrokeTip::kEnd};

/// Radii, in mm, of the first and the last circle that nearest() searches before it searches the
/// whole radius.
constexpr double kFirstReachMm = 8.0;
constexpr double kLastReachMm = 1e7;

double handle_reach_mm(const Stroke& stroke) {
  double farthest = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic c = stroke.segment(i);
    const Rect hull = control_bounds(c);
    farthest = std::max(
        {farthest, std::min(c.p[0].x, c.p[3].x) - hull.x0, std::min(c.p[0].y, c.p[3].y) - hull.y0,
         hull.x1 - std::max(c.p[0].x, c.p[3].x), hull.y1 - std::max(c.p[0].y, c.p[3].y)});
  }
  return farthest;
}

double half_width_mm(const Stroke& stroke) {
  double widest = 0.0;
  for (const WidthKnot& k : stroke.widths()) widest = std::max(widest, 0.5 * k.width_mm);
  return widest;
}

}  // namespace

void StrokeIndex::LayerSegments::update(std::span<const SegmentForest::Change> changes) {
  segments.update(changes);
  for (const SegmentForest::Change& c : changes) {
    const double half_mm = c.after ? half_width_mm(*c.after) : 0.0;
    if (half_mm > 0.5 * kBroadMm) {
      Rect box;
      for (int i = 0; i < c.after->segment_count(); ++i) box.extend(bounds(c.after->segment(i)));
      broad[c.id] = {c.after, box, half_mm};
    } else if (!broad.empty()) {
      broad.erase(c.id);
    }
  }
}

StrokeIndex::StrokeIndex(const Document& document, double cell_mm, std::size_t indexed_at_once)
    : cell_mm_(cell_mm) {
  const bool later = document.stroke_count() > indexed_at_once;
  std::vector<UnindexedStrokes::Entry> now;
  for (const Layer& layer : document.layers()) {
    layers_[layer.id].show(layer.visible, layer.locked);
    for (const StrokeId id : layer.strokes) {
      UnindexedStrokes::Entry entry{id, layer.id, document.find(id)};
      const bool broad = measure(*entry.stroke) > 0.5 * kBroadMm;
      if (!later || broad || !unindexed_.add(entry)) now.push_back(std::move(entry));
    }
  }
  index(now);
}

void StrokeIndex::update(const Edit& edit, const Document& document) {
  std::vector<UnindexedStrokes::Entry> near;
  for (const StrokeChange& c : edit.changes) {
    if (c.before) unindexed_.take_around(*c.before, near);
  }
  index(near);
  remove_tips(edit);
  for (const StrokeChange& c : edit.changes) {
    if (!c.after || c.before == c.after) continue;  // only its place among the strokes changed
    measure(*c.after);
    add_tips(c.id, *c.after);
  }
  update_segments(edit, document);
}

void StrokeIndex::index_strokes_in(const Rect& area) const {
  if (unindexed_.size() == 0) return;
  std::vector<UnindexedStrokes::Entry> near;
  unindexed_.take(area, near);
  index(near);
}

void StrokeIndex::index(std::span<const UnindexedStrokes::Entry> entries) const {
  std::map<LayerId, std::vector<SegmentForest::Change>> changes;
  for (const UnindexedStrokes::Entry& entry : entries) {
    changes[entry.layer].push_back({entry.id, entry.stroke});
    add_tips(entry.id, *entry.stroke);
  }
  for (const auto& [id, strokes] : changes) layers_[id].update(strokes);
}

void StrokeIndex::update_segments(const Edit& edit, const Document& document) {
  std::map<LayerId, std::vector<SegmentForest::Change>> changes;
  for (const StrokeChange& c : edit.changes) {
    const LayerId from = c.before ? c.before_place.layer : LayerId{};
    const LayerId to = c.after ? c.after_place.layer : LayerId{};
    if (from && from != to) changes[from].push_back({c.id, nullptr});
    if (to && !(from == to && c.before == c.after)) changes[to].push_back({c.id, c.after});
  }
  for (const auto& [id, strokes] : changes) {
    const auto [layer, is_new] = layers_.try_emplace(id);
    if (const Layer* known = document.layer(id); is_new && known) {
      layer->second.show(known->visible, known->locked);
    }
    layer->second.update(strokes);
  }
  for (const LayerChange& c : edit.layers) {
    if (c.after) {
      layers_[c.id].show(is_visible(*c.after), is_locked(*c.after));
    } else {
      layers_.erase(c.id);
    }
  }
}

/// Counts the stroke's ends and updates the largest width and handle distance. Returns half of the
/// stroke's width.
double StrokeIndex::measure(const Stroke& stroke) {
  const double half_mm = half_width_mm(stroke);
  widest_half_mm_ = std::max(widest_half_mm_, half_mm);
  if (half_mm <= 0.5 * kBroadMm) usual_half_mm_ = std::max(usual_half_mm_, half_mm);
  farthest_handle_mm_ = std::max(farthest_handle_mm_, handle_reach_mm(stroke));
  if (!stroke.closed()) tips_ += kTips.size();
  return half_mm;
}

void StrokeIndex::add_tips(StrokeId id, const Stroke& stroke) const {
  if (stroke.closed()) return;
  for (StrokeTip tip : kTips) {
    const Point p = tip_point(stroke, tip);
    cells_[grid_cell(p, cell_mm_)].push_back({{id, tip}, p});
  }
}

/// Removes the ends of the strokes that the edit changes. Visits each cell once, because all
/// strokes of a large edit may end in one cell.
void StrokeIndex::remove_tips(const Edit& edit) {
  std::vector<std::pair<CellAddress, TipId>> gone;
  for (const StrokeChange& c : edit.changes) {
    if (!c.before || c.before == c.after || c.before->closed()) continue;
    for (StrokeTip tip : kTips) {
      gone.push_back({grid_cell(tip_point(*c.before, tip), cell_mm_), {c.id, tip}});
    }
  }
  std::sort(gone.begin(), gone.end());
  for (auto first = gone.begin(); first != gone.end();) {
    const auto last = std::find_if(first, gone.end(),
                                   [&](const auto& other) { return other.first != first->first; });
    if (const auto cell = cells_.find(first->first); cell != cells_.end()) {
      tips_ -= std::erase_if(cell->second, [&](const Entry& entry) {
        return std::binary_search(first, last, std::pair(first->first, entry.id));
      });
      if (cell->second.empty()) cells_.erase(cell);
    }
    first = last;
  }
}

std::optional<StrokeHit> StrokeIndex::nearest(Point place, double radius_mm,
                                              StrokeReach reach) const {
  // Searches in growing circles, because a large circle would visit all leaves.
  for (double mm = kFirstReachMm; mm < std::min(radius_mm, kLastReachMm); mm *= 8.0) {
    if (const auto found = nearest_within(place, mm, reach)) return found;
  }
  return nearest_within(place, radius_mm, reach);
}

std::optional<StrokeHit> StrokeIndex::nearest_within(Point place, double radius_mm,
                                                     StrokeReach reach) const {
  if (is_finite(place)) {
    index_strokes_in(
        Rect{place.x - radius_mm, place.y - radius_mm, place.x + radius_mm, place.y + radius_mm});
  }
  std::optional<StrokeHit> best;
  double smallest = 0.0;
  for (const auto& [layer, entry] : layers_) {
    if (!entry.is_in(reach)) continue;
    const auto hit = entry.segments.nearest(place, radius_mm);
    if (!hit) continue;
    const double d = hit->nearest.distance_squared;
    if (best && (d > smallest || (d == smallest && hit->stroke > best->stroke))) continue;
    smallest = d;
    best = StrokeHit{hit->stroke, hit->segment + hit->nearest.t, hit->nearest.point, std::sqrt(d)};
  }
  return best;
}

std::vector<StrokeId> StrokeIndex::strokes_in(const Rect& area) const {
  std::vector<StrokeId> found;
  for_each_segment_in(area, [&](StrokeId id, int) { found.push_back(id); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::optional<TipHit> StrokeIndex::nearest_tip(const Document& document, Point place,
                                               double radius_mm,
                                               std::span<const TipId> except) const {
  if (!is_finite(place) || !(radius_mm >= 0.0)) return std::nullopt;
  const Rect area{place.x - radius_mm, place.y - radius_mm, place.x + radius_mm,
                  place.y + radius_mm};
  std::optional<TipHit> best;
  for_each_tip_in(area, [&](const TipId& id, Point point) {
    const double d = distance(place, point);
    if (!(d <= radius_mm)) return;
    if (best && (d > best->distance_mm || (d == best->distance_mm && id > best->id))) return;
    if (std::find(except.begin(), except.end(), id) != except.end()) return;
    if (!document.find(id.stroke)) return;
    if (!document.layer(document.layer_of(id.stroke))->visible) return;
    best = TipHit{id, point, d};
  });
  return best;
}

}  // namespace felt
