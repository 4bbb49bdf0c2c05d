#include "felt/motion/end_links.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include "felt/geometry/polyline.h"
#include "felt/geometry/rect.h"
#include "felt/motion/stroke_shape.h"

namespace felt {
namespace {

/// Ends whose ink is this far apart still touch, because hands leave such gaps.
constexpr double kTouchMm = 0.5;

/// An end with its positions in both keys, and half its width.
struct PlacedEnd {
  std::size_t blend = 0;
  bool is_end = false;
  Point a, b;
  double radius_mm = 0.0;
};

std::vector<PlacedEnd> ends_of(std::span<const LinkedBlend> blends) {
  std::vector<PlacedEnd> ends;
  for (std::size_t i = 0; i < blends.size(); ++i) {
    if (blends[i].blend.closed()) continue;
    const StrokeData &a = blends[i].keys.a.data(), &b = blends[i].keys.b.data();
    ends.push_back({i, false, a.points.front(), b.points.front(), 0.5 * a.widths.front().width_mm});
    ends.push_back({i, true, a.points.back(), b.points.back(), 0.5 * a.widths.back().width_mm});
  }
  return ends;
}

/// A line in one key, with the parameter of the blend at each of its points.
struct KeyLine {
  std::vector<Point> points;
  Rect box;
};

KeyLine key_line(const Stroke& stroke) {
  KeyLine line{coarse_line(stroke), {}};
  for (const Point p : line.points) line.box.extend(p);
  return line;
}

/// A place on a line near an end.
struct LinePlace {
  double u = 0.0;
  Point point;
};

std::optional<LinePlace> place_on(const KeyLine& line, const Stroke& stroke, Point p,
                                  double reach_mm) {
  if (!line.box.inflated(reach_mm).contains(p)) return std::nullopt;
  const PolylineNearest nearest = nearest_on_polyline(line.points, p);
  if (nearest.distance_squared > reach_mm * reach_mm) return std::nullopt;
  const double steps = static_cast<double>(line.points.size() - 1) / stroke.segment_count();
  const double u = (static_cast<double>(nearest.index) + nearest.t) / steps;
  return LinePlace{u, stroke.position(u)};
}

/// Finds the links of a set of blends.
class LinkFinder {
 public:
  explicit LinkFinder(std::span<const LinkedBlend> blends)
      : blends_(blends), ends_(ends_of(blends)), parent_(ends_.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  EndLinks find() {
    join_ends();
    EndLinks links;
    std::vector<std::vector<std::size_t>> members(ends_.size());
    for (std::size_t i = 0; i < ends_.size(); ++i) members[root(i)].push_back(i);
    for (const auto& group : members) {
      if (group.size() > 1) links.clusters.push_back(cluster(group));
    }
    find_lines();
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (members[root(i)].size() > 1) continue;
      if (const auto on_line = line_at(ends_[i])) links.on_lines.push_back(*on_line);
    }
    return links;
  }

 private:
  std::size_t root(std::size_t i) noexcept {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void join_ends() {
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      for (std::size_t k = i + 1; k < ends_.size(); ++k) {
        const PlacedEnd &x = ends_[i], &y = ends_[k];
        const double reach = kTouchMm + 0.5 * (x.radius_mm + y.radius_mm);
        if (distance_squared(x.a, y.a) > reach * reach) continue;
        if (distance_squared(x.b, y.b) > reach * reach) continue;
        const std::size_t a = root(i), b = root(k);
        parent_[std::max(a, b)] = std::min(a, b);
      }
    }
  }

  [[nodiscard]] EndCluster cluster(const std::vector<std::size_t>& group) const {
    Vec a{}, b{};
    for (const std::size_t i : group) {
      a += ends_[i].a - Point{};
      b += ends_[i].b - Point{};
    }
    const auto count = static_cast<double>(group.size());
    EndCluster cluster;
    for (const std::size_t i : group) {
      cluster.ends.push_back({ends_[i].blend, ends_[i].is_end, ends_[i].a - (Point{} + a / count),
                              ends_[i].b - (Point{} + b / count)});
    }
    return cluster;
  }

  void find_lines() {
    for (const LinkedBlend& blend : blends_) {
      a_lines_.push_back(key_line(blend.keys.a));
      b_lines_.push_back(key_line(blend.keys.b));
    }
  }

  [[nodiscard]] std::optional<EndOnLine> line_at(const PlacedEnd& end) const {
    std::optional<EndOnLine> best;
    double least = 1e300;
    for (std::size_t i = 0; i < blends_.size(); ++i) {
      if (i == end.blend) continue;
      const double reach = kTouchMm + end.radius_mm;
      const auto a = place_on(a_lines_[i], blends_[i].keys.a, end.a, reach);
      if (!a) continue;
      const auto b = place_on(b_lines_[i], blends_[i].keys.b, end.b, reach);
      if (!b) continue;
      const double apart = distance(a->point, end.a) + distance(b->point, end.b);
      if (apart >= least) continue;
      least = apart;
      best = EndOnLine{{end.blend, end.is_end, end.a - a->point, end.b - b->point},
                       i,
                       blends_[i].blend.parameter_of_a(a->u),
                       blends_[i].blend.parameter_of_b(b->u)};
    }
    return best;
  }

  std::span<const LinkedBlend> blends_;
  std::vector<PlacedEnd> ends_;
  std::vector<std::size_t> parent_;
  std::vector<KeyLine> a_lines_, b_lines_;
};

Vec offset_at(const BlendEnd& end, double t) noexcept {
  return (1.0 - t) * end.a_offset + t * end.b_offset;
}

/// Where the ends of a blend are held.
struct HeldEnds {
  std::optional<Point> start, end;
};

}  // namespace

EndLinks find_end_links(std::span<const LinkedBlend> blends) {
  return LinkFinder(blends).find();
}

void hold_ends(std::span<const LinkedBlend> blends, const EndLinks& links, double t,
               std::span<BlendPose> poses) {
  std::vector<HeldEnds> held(blends.size());
  const auto hold = [&](const BlendEnd& end, Point at) {
    (end.is_end ? held[end.blend].end : held[end.blend].start) = at + offset_at(end, t);
  };
  for (const EndCluster& cluster : links.clusters) {
    Vec sum{};
    for (const BlendEnd& end : cluster.ends) {
      const BlendPose& pose = poses[end.blend];
      sum += (end.is_end ? pose.end : pose.start) - Point{};
    }
    const Point middle = Point{} + sum / static_cast<double>(cluster.ends.size());
    for (const BlendEnd& end : cluster.ends) hold(end, middle);
  }
  std::vector<bool> waits(blends.size(), false);
  for (const EndOnLine& on : links.on_lines) waits[on.end.blend] = true;
  for (std::size_t i = 0; i < blends.size(); ++i) {
    if (!waits[i]) StrokeBlend::fit_ends(poses[i], held[i].start, held[i].end);
  }
  for (std::size_t i = 0; i < links.on_lines.size(); ++i) {
    const EndOnLine& on = links.on_lines[i];
    const double v = (1.0 - t) * on.a_v + t * on.b_v;
    hold(on.end, StrokeBlend::position(poses[on.line], v));
    const std::size_t blend = on.end.blend;
    // Both ends of a blend are neighbours in the list.
    if (i + 1 < links.on_lines.size() && links.on_lines[i + 1].end.blend == blend) continue;
    StrokeBlend::fit_ends(poses[blend], held[blend].start, held[blend].end);
  }
}

}  // namespace felt
