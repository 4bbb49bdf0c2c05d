#include "felt/tools/connect/near_tips.h"

#include <algorithm>

#include "felt/document/stroke_index.h"
#include "felt/tools/connecting.h"

namespace felt {
namespace {

/// The index contains the ends of all visible strokes, including those on locked layers. At most
/// kMaxSkipped locked ends are skipped one by one. If more of them are near, the segments of
/// editable strokes are searched instead.
constexpr std::size_t kMaxSkipped = 32;

bool is_before(const TipHit& a, const TipHit& b) noexcept {
  return a.distance_mm != b.distance_mm ? a.distance_mm < b.distance_mm : a.id < b.id;
}

std::vector<TipHit> by_segments(const Scene& scene, Point place, double radius_mm) {
  std::vector<TipHit> found;
  const auto add = [&](StrokeId id, const Stroke& stroke, StrokeTip tip) {
    const Point at = tip_point(stroke, tip);
    const double away = distance(place, at);
    if (away <= radius_mm) found.push_back({{id, tip}, at, away});
  };
  Rect area;
  area.extend(place);
  scene.index.for_each_segment_in(area.inflated(radius_mm), [&](StrokeId id, int segment) {
    const StrokePtr stroke = scene.document.find(id);
    if (!stroke || stroke->closed()) return;
    if (segment == 0) add(id, *stroke, StrokeTip::kStart);
    if (segment == stroke->segment_count() - 1) add(id, *stroke, StrokeTip::kEnd);
  });
  std::sort(found.begin(), found.end(), is_before);
  return found;
}

}  // namespace

std::vector<TipHit> editable_tips_near(const Scene& scene, Point place, double radius_mm,
                                       std::size_t max_ends) {
  std::vector<TipHit> found;
  std::vector<TipId> seen;
  while (found.size() < max_ends) {
    const auto hit = scene.index.nearest_tip(scene.document, place, radius_mm, seen);
    if (!hit) break;
    seen.push_back(hit->id);
    if (is_editable(scene.document, scene.document.layer_of(hit->id.stroke))) {
      found.push_back(*hit);
    } else if (seen.size() - found.size() > kMaxSkipped) {
      found = by_segments(scene, place, radius_mm);
      found.resize(std::min(found.size(), max_ends));
      break;
    }
  }
  return found;
}

}  // namespace felt
