#include "felt/tools/junctions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "felt/geometry/nearest.h"

namespace felt {
namespace {

constexpr double kReachSquared = kSharedPointMm * kSharedPointMm;

double end_u(const Stroke& stroke, StrokeTip tip) {
  return tip == StrokeTip::kStart ? 0.0 : static_cast<double>(stroke.segment_count());
}

class Search {
 public:
  Search(const Document& document, const StrokeIndex& index, StrokeId id, const Stroke& stroke)
      : document_(document), index_(index), id_(id), stroke_(stroke) {}

  std::vector<Junction> run() {
    for (int i = 0; i < stroke_.segment_count(); ++i) find_ends_on(i);
    if (!stroke_.closed()) {
      find_curves_at(StrokeTip::kStart);
      find_curves_at(StrokeTip::kEnd);
    }
    std::vector<Junction> all;
    for (auto& [other, junctions] : found_) {
      std::sort(junctions.begin(), junctions.end(), [](const Junction& a, const Junction& b) {
        return std::pair(a.other_u, a.u) < std::pair(b.other_u, b.u);
      });
      all.insert(all.end(), junctions.begin(), junctions.end());
    }
    return all;
  }

 private:
  /// Adds the ends of other strokes that lie on segment i.
  void find_ends_on(int i) {
    const Cubic curve = stroke_.segment(i);
    const Rect area = control_bounds(curve).inflated(kSharedPointMm);
    index_.for_each_tip_in(area, [&](TipId tip, Point end) {
      if (tip.stroke == id_) return;
      const auto near = nearest_within(curve, end, kReachSquared);
      const StrokePtr other = near ? document_.find(tip.stroke) : nullptr;
      const Layer* layer = other ? document_.layer(document_.layer_of(tip.stroke)) : nullptr;
      if (!layer || !layer->visible) return;
      add({i + near->t, tip.stroke, end_u(*other, tip.tip), end, !layer->locked});
    });
  }

  /// Adds the curves of other strokes, except their ends, that pass through an end of this one.
  void find_curves_at(StrokeTip tip) {
    const Point end = tip_point(stroke_, tip);
    Rect area;
    area.extend(end);
    const auto visit = [&](StrokeId id, int segment) {
      if (id == id_) return;
      const StrokePtr other = document_.find(id);
      const auto near =
          other ? nearest_within(other->segment(segment), end, kReachSquared) : std::nullopt;
      if (!near) return;
      if (!other->closed()) {
        const double gap = std::min(distance(end, tip_point(*other, StrokeTip::kStart)),
                                    distance(end, tip_point(*other, StrokeTip::kEnd)));
        if (gap <= kSharedPointMm) return;  // find_ends_on() has already added it
      }
      const bool is_locked = document_.layer(document_.layer_of(id))->locked;
      add({end_u(stroke_, tip), id, segment + near->t, end, !is_locked});
    };
    index_.for_each_segment_in(area.inflated(kSharedPointMm), visit, StrokeReach::kVisible);
  }

  /// Adds a junction unless it is already known, because a point at a joint is found on both of its
  /// segments.
  void add(const Junction& j) {
    std::vector<Junction>& others = found_[j.other];
    const bool known = std::any_of(others.begin(), others.end(), [&](const Junction& k) {
      return k.point == j.point && std::fabs(k.u - j.u) < 1e-3 &&
             std::fabs(k.other_u - j.other_u) < 1e-3;
    });
    if (!known) others.push_back(j);
  }

  const Document& document_;
  const StrokeIndex& index_;
  StrokeId id_;
  const Stroke& stroke_;
  std::map<StrokeId, std::vector<Junction>> found_;  // by the other stroke
};

}  // namespace

std::vector<Junction> junctions_of(const Document& document, const StrokeIndex& index, StrokeId id,
                                   const Stroke& stroke) {
  return Search(document, index, id, stroke).run();
}

}  // namespace felt
