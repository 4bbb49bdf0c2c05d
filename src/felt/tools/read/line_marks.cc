#include "felt/tools/read/line_marks.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <set>
#include <utility>

#include "felt/geometry/intersect.h"
#include "felt/geometry/nearest.h"

namespace felt {
namespace {

/// Edges of ink that are nearer than this touch, mm: less than a fingertip or an eye notices.
constexpr double kInkTouchMm = 0.1;

/// A crossing of two neighbouring segments nearer than this to their joint is the joint itself.
constexpr double kSeamMm = 0.5;

using Piece = std::pair<StrokeId, int>;

Rect square_around(Point p, double half_mm) {
  return {p.x - half_mm, p.y - half_mm, p.x + half_mm, p.y + half_mm};
}

/// Finds the marks of one line near the pen.
class MarkSearch {
 public:
  MarkSearch(const Scene& scene, StrokeId id, const Stroke& line, const Rect& area,
             ReadLayers layers)
      : scene_(scene), id_(id), line_(line), area_(area) {
    scene.index.for_each_segment_in(
        area,
        [&](StrokeId stroke, int segment) {
          if (stroke == id) own_.push_back({stroke, segment});
          if (stroke != id && is_read(scene, stroke, layers)) others_.push_back({stroke, segment});
        },
        StrokeReach::kVisible);
    // The index has no order.
    std::sort(own_.begin(), own_.end());
    std::sort(others_.begin(), others_.end());
    if (own_.size() > kMaxOwnPieces) own_.resize(kMaxOwnPieces);
    if (others_.size() > kMaxOtherPieces) others_.resize(kMaxOtherPieces);
  }

  std::vector<LineMark> run() {
    for (const Piece& own : own_) cross(own.second);
    if (!line_.closed()) {
      for (const StrokeTip tip : {StrokeTip::kStart, StrokeTip::kEnd}) add_own_end(tip);
    }
    add_ends_of_others();
    std::vector<LineMark> marks;
    for (const Found& f : found_)
      marks.push_back({f.at, 1 + f.others.size() + (f.is_loop ? 1 : 0)});
    return marks;
  }

 private:
  struct Found {
    Point at;
    std::set<StrokeId> others;
    bool is_loop = false;
  };

  void add(Point at, StrokeId other, bool is_loop) {
    if (!area_.contains(at)) return;
    auto known = std::find_if(found_.begin(), found_.end(),
                              [&](const Found& f) { return distance(f.at, at) < kOneMarkMm; });
    if (known == found_.end()) known = found_.insert(found_.end(), Found{at, {}, false});
    if (other.value != 0) known->others.insert(other);
    known->is_loop = known->is_loop || is_loop;
  }

  void cross(int segment) {
    const Cubic curve = line_.segment(segment);
    for (const auto& [stroke, other] : others_) {
      const StrokePtr& line = scene_.document.find(stroke);
      if (!line) continue;
      for (const Crossing& c : intersections(curve, line->segment(other))) {
        if (c.kind != Crossing::Kind::kOverlap) add(c.point, stroke, false);
      }
    }
    if (const auto loop = self_intersection(curve)) {
      if (loop->t2 - loop->t1 < 1.0) add(loop->point, {}, true);
    }
    for (const Piece& own : own_) {
      if (own.second > segment) cross_itself(segment, own.second);
    }
  }

  void cross_itself(int a, int b) {
    const Cubic first = line_.segment(a), second = line_.segment(b);
    for (const Crossing& c : intersections(first, second)) {
      const bool after = b == a + 1 && distance(c.point, first.p[3]) < kSeamMm;
      const bool around = line_.closed() && a == 0 && b == line_.segment_count() - 1 &&
                          distance(c.point, first.p[0]) < kSeamMm;
      if (!after && !around && c.kind != Crossing::Kind::kOverlap) add(c.point, {}, true);
    }
  }

  /// Adds an end of the line with the lines that it touches.
  void add_own_end(StrokeTip tip) {
    const Point at = tip_point(line_, tip);
    if (!area_.contains(at)) return;
    add(at, {}, false);
    const double half_mm =
        0.5 * line_.width_mm(tip == StrokeTip::kStart ? 0.0 : line_.segment_count());
    for (const auto& [stroke, other] : others_) {
      if (touches(stroke, other, at, half_mm)) add(at, stroke, false);
    }
  }

  [[nodiscard]] bool touches(StrokeId stroke, int segment, Point at, double half_mm) const {
    const StrokePtr& line = scene_.document.find(stroke);
    if (!line) return false;
    const Nearest near = nearest(line->segment(segment), at);
    return std::sqrt(near.distance_squared) <=
           half_mm + 0.5 * line->width_mm(segment + near.t) + kInkTouchMm;
  }

  void add_ends_of_others() {
    for (const auto& [stroke, segment] : others_) {
      const StrokePtr& line = scene_.document.find(stroke);
      if (!line || line->closed()) continue;
      const int last = line->segment_count() - 1;
      if (segment == 0) add_end(stroke, *line, StrokeTip::kStart);
      if (segment == last) add_end(stroke, *line, StrokeTip::kEnd);
    }
  }

  void add_end(StrokeId stroke, const Stroke& line, StrokeTip tip) {
    const Point at = tip_point(line, tip);
    const double half_mm =
        0.5 * line.width_mm(tip == StrokeTip::kStart ? 0.0 : line.segment_count());
    for (const Piece& own : own_) {
      const Nearest near = nearest(line_.segment(own.second), at);
      if (std::sqrt(near.distance_squared) >
          half_mm + 0.5 * line_.width_mm(own.second + near.t) + kInkTouchMm) {
        continue;
      }
      return add(near.point, stroke, false);
    }
  }

  const Scene& scene_;
  StrokeId id_;
  const Stroke& line_;
  Rect area_;
  std::vector<Piece> own_, others_;
  std::vector<Found> found_;
};

}  // namespace

bool is_read(const Scene& scene, StrokeId id, ReadLayers layers) {
  return layers == ReadLayers::kVisible || scene.document.layer_of(id) == scene.layer;
}

std::optional<StrokeHit> nearest_read(const Scene& scene, Point pen, double radius_mm,
                                      ReadLayers layers) {
  if (layers == ReadLayers::kVisible) {
    return scene.index.nearest(pen, radius_mm, StrokeReach::kVisible);
  }
  std::optional<StrokeHit> best;
  double limit = radius_mm * radius_mm;
  scene.index.for_each_segment_in(
      square_around(pen, radius_mm),
      [&](StrokeId id, int segment) {
        if (!is_read(scene, id, layers)) return;
        const auto near = nearest_within(scene.document.find(id)->segment(segment), pen, limit);
        if (!near) return;
        const double u = segment + near->t;
        const double d = near->distance_squared;
        if (best && d == limit && std::pair(id, u) > std::pair(best->stroke, best->u)) return;
        limit = d;
        best = StrokeHit{id, u, near->point, std::sqrt(d)};
      },
      StrokeReach::kVisible);
  return best;
}

std::optional<double> distance_to(const Scene& scene, StrokeId id, Point pen, double radius_mm) {
  const StrokePtr line = scene.document.find(id);
  double limit = radius_mm * radius_mm;
  bool is_found = false;
  scene.index.for_each_segment_in(
      square_around(pen, radius_mm),
      [&](StrokeId stroke, int segment) {
        if (stroke != id || !line) return;
        const auto near = nearest_within(line->segment(segment), pen, limit);
        if (!near) return;
        limit = near->distance_squared;
        is_found = true;
      },
      StrokeReach::kVisible);
  return is_found ? std::optional(std::sqrt(limit)) : std::nullopt;
}

std::vector<LineMark> marks_near(const Scene& scene, StrokeId id, Point pen, double reach_mm,
                                 ReadLayers layers) {
  const StrokePtr line = scene.document.find(id);
  if (!line) return {};
  return MarkSearch(scene, id, *line, square_around(pen, reach_mm), layers).run();
}

}  // namespace felt
