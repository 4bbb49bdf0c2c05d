#include "felt/document/stroke_index.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "felt/geometry/nearest.h"

namespace felt {
namespace {

constexpr std::array kTips = {StrokeTip::kStart, StrokeTip::kEnd};

/// Lines farther out than this are one line: still in order, only fuller.
constexpr double kLastLine = 1e12;

}  // namespace

StrokeIndex::StrokeIndex(const Document& document, double cell_mm) : cell_mm_(cell_mm) {
  for (const Layer& layer : document.layers()) {
    for (StrokeId id : layer.strokes) {
      add(id, *document.find(id));
      if (layer.visible && !layer.locked) editable_[id] = document.find(id);
    }
  }
}

void StrokeIndex::update(const Edit& edit, const Document& document) {
  for (const StrokeChange& c : edit.changes) editable_.erase(c.id);
  for (const StrokeChange& c : edit.changes) {
    if (!c.after) continue;
    const Layer& layer = *document.layer(document.layer_of(c.id));
    if (layer.visible && !layer.locked) editable_[c.id] = c.after;
  }
  for (const LayerChange& c : edit.layers) {
    if (!c.after) continue;
    for (const StrokeId id : document.layer(c.id)->strokes) {
      editable_.erase(id);
      if (c.after->visible && !c.after->locked) editable_[id] = document.find(id);
    }
  }
  for (const StrokeChange& c : edit.changes) {
    if (c.before) remove(c.id, *c.before);
    if (c.after) add(c.id, *c.after);
  }
}

std::int64_t StrokeIndex::line_of(double mm) const noexcept {
  return static_cast<std::int64_t>(std::clamp(std::floor(mm / cell_mm_), -kLastLine, kLastLine));
}

void StrokeIndex::add(StrokeId id, const Stroke& stroke) {
  if (stroke.closed()) return;
  for (StrokeTip tip : kTips) {
    const Point p = tip_point(stroke, tip);
    cells_[{line_of(p.y), line_of(p.x)}].push_back({{id, tip}, p});
    ++tips_;
  }
}

void StrokeIndex::remove(StrokeId id, const Stroke& stroke) {
  if (stroke.closed()) return;
  for (StrokeTip tip : kTips) {
    const Point p = tip_point(stroke, tip);
    const auto cell = cells_.find({line_of(p.y), line_of(p.x)});
    if (cell == cells_.end()) continue;
    auto& entries = cell->second;
    const TipId wanted{id, tip};
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&](const Entry& e) { return e.id == wanted; });
    if (entry == entries.end()) continue;
    *entry = entries.back();
    entries.pop_back();
    if (entries.empty()) cells_.erase(cell);
    --tips_;
  }
}

std::optional<StrokeHit> StrokeIndex::nearest(Point place, double radius_mm) const {
  std::optional<StrokeHit> best;
  double limit = radius_mm * radius_mm;
  for (const auto& [id, stroke] : editable_) {
    for (int i = 0; i < stroke->segment_count(); ++i) {
      const auto hit = nearest_within(stroke->segment(i), place, limit);
      if (!hit || (best && hit->distance_squared >= limit)) continue;
      limit = hit->distance_squared;
      best = StrokeHit{id, i + hit->t, hit->point, std::sqrt(limit)};
    }
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
  const std::int64_t left = line_of(place.x - radius_mm), right = line_of(place.x + radius_mm);
  const std::int64_t top = line_of(place.y - radius_mm), bottom = line_of(place.y + radius_mm);
  std::optional<TipHit> best;
  const auto consider = [&](const Entry& e) {
    const double d = distance(place, e.point);
    if (!(d <= radius_mm)) return;
    if (best && (d > best->distance_mm || (d == best->distance_mm && e.id > best->id))) return;
    if (std::find(except.begin(), except.end(), e.id) != except.end()) return;
    if (!document.find(e.id.stroke)) return;
    if (!document.layer(document.layer_of(e.id.stroke))->visible) return;
    best = TipHit{e.id, e.point, d};
  };
  // Only cells that hold something are visited: a huge circle costs no more than all of them.
  auto cell = cells_.lower_bound({top, left});
  while (cell != cells_.end() && cell->first.first <= bottom) {
    const auto [row, column] = cell->first;
    if (column > right) {
      cell = cells_.lower_bound({row + 1, left});
    } else if (column < left) {
      cell = cells_.lower_bound({row, left});
    } else {
      for (const Entry& e : cell->second) consider(e);
      ++cell;
    }
  }
  return best;
}

}  // namespace felt
