#include "felt/fill/map_edges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "felt/geometry/intersect.h"
#include "felt/geometry/nearest.h"

namespace felt {
namespace {

/// A parameter of a line at which it is divided, and the point there.
struct LineBreak {
  double u = 0.0;
  std::size_t point = 0;
};

/// A stroke, or a link as a line of one or two straight segments.
struct DividedLine {
  StrokeId stroke;
  std::size_t link = 0;
  std::span<const Cubic> segments;
  std::vector<LineBreak> breaks;
};

/// Gives points that are within the tolerance of each other the same number: sorts by x, divides
/// where the gap is wider than the tolerance, and repeats this by y and again by x.
class NodeSnapper {
 public:
  NodeSnapper(std::span<const Point> points, double snap_mm)
      : points_(points), snap_mm_(snap_mm), node_of_(points.size()), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (!points.empty()) divide(order_, 0);
  }

  std::vector<std::size_t> node_of() && { return std::move(node_of_); }
  std::vector<Point> nodes() && { return std::move(nodes_); }

 private:
  void divide(std::span<std::size_t> part, int pass) {
    constexpr int kPasses = 4;
    if (part.size() > 1 && pass < kPasses) {
      const auto key = [&](std::size_t i) { return pass % 2 ? points_[i].y : points_[i].x; };
      std::sort(part.begin(), part.end(), [&](std::size_t a, std::size_t b) {
        return std::pair(key(a), a) < std::pair(key(b), b);
      });
      std::size_t begin = 0;
      for (std::size_t i = 1; i <= part.size(); ++i) {
        if (i < part.size() && key(part[i]) - key(part[i - 1]) <= snap_mm_) continue;
        divide(part.subspan(begin, i - begin), pass + 1);
        begin = i;
      }
      return;
    }
    const std::size_t first = *std::min_element(part.begin(), part.end());
    for (const std::size_t i : part) node_of_[i] = nodes_.size();
    nodes_.push_back(points_[first]);
  }

  std::span<const Point> points_;
  double snap_mm_;
  std::vector<std::size_t> node_of_;
  std::vector<Point> nodes_;
  std::vector<std::size_t> order_;
};

class Divider {
 public:
  Divider(const LineMeetings& meetings, std::vector<TipLink> links) : meetings_(meetings) {
    result_.links = std::move(links);
  }

  MapEdges run() {
    add_strokes();
    add_link_lines();
    cross_links();
    double largest = 0.0;
    for (const Point& p : points_) {
      largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    }
    result_.snap_mm = std::max(kSnapMm, 1e-12 * largest);
    NodeSnapper snapper(points_, result_.snap_mm);
    node_of_ = std::move(snapper).node_of();
    result_.nodes = std::move(snapper).nodes();
    for (DividedLine& line : lines_) add_edges(line);
    drop_copies();
    return std::move(result_);
  }

 private:
  std::size_t add_point(Point p) {
    points_.push_back(p);
    return points_.size() - 1;
  }

  void add_strokes() {
    std::vector<const MeetingLine*> lines;
    for (const auto& [id, line] : meetings_.lines()) {
      index_of_[id] = lines_.size();
      const auto& ends = line.stroke->data().points;
      const std::size_t start = add_point(ends.front());
      const std::size_t end = line.stroke->closed() ? start : add_point(ends.back());
      const auto n = static_cast<double>(line.segments.size());
      lines_.push_back({id, 0, line.segments, {{0.0, start}, {n, end}}});
      lines.push_back(&line);
    }
    for (std::size_t i = 0; i < lines.size(); ++i) {
      for (const auto& [other, found] : lines[i]->meetings) {
        for (const Meeting& m : found) {
          const std::size_t p = add_point(m.point);
          lines_[i].breaks.push_back({m.u, p});
          lines_[index_of_.at(other)].breaks.push_back({m.v, p});
        }
      }
    }
  }

  void add_link_lines() {
    for (std::size_t k = 0; k < result_.links.size(); ++k) {
      const TipLink& link = result_.links[k];
      std::vector<Point> corners{link.from.point};
      if (link.corner) corners.push_back(*link.corner);
      corners.push_back(link.to.point);
      for (std::size_t i = 1; i < corners.size(); ++i) {
        link_segments_.push_back(straight(corners[i - 1], corners[i]));
      }
    }
    std::size_t first = 0;
    for (std::size_t k = 0; k < result_.links.size(); ++k) {
      const TipLink& link = result_.links[k];
      const std::size_t count = link.corner ? 2 : 1;
      const std::size_t from = add_point(link.from.point), to = add_point(link.to.point);
      lines_[index_of_.at(link.from.stroke)].breaks.push_back({link.from.u, from});
      lines_[index_of_.at(link.to.stroke)].breaks.push_back({link.to.u, to});
      DividedLine line{StrokeId{}, k, std::span(link_segments_).subspan(first, count), {}};
      line.breaks = {{0.0, from}, {static_cast<double>(count), to}};
      if (link.corner) line.breaks.push_back({1.0, add_point(*link.corner)});
      lines_.push_back(std::move(line));
      first += count;
    }
  }

  /// Divides links where they cross other links. No stroke crosses a link (TipLinker).
  void cross_links() {
    struct Part {
      Rect box;
      std::size_t line;
      std::size_t segment;
    };
    std::vector<Part> parts;
    for (std::size_t i = index_of_.size(); i < lines_.size(); ++i) {
      for (std::size_t s = 0; s < lines_[i].segments.size(); ++s) {
        parts.push_back({control_bounds(lines_[i].segments[s]), i, s});
      }
    }
    std::stable_sort(parts.begin(), parts.end(),
                     [](const Part& a, const Part& b) { return a.box.x0 < b.box.x0; });
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (std::size_t j = i + 1; j < parts.size() && parts[j].box.x0 <= parts[i].box.x1; ++j) {
        if (parts[i].line == parts[j].line || !parts[i].box.intersects(parts[j].box)) continue;
        cross(lines_[parts[i].line], parts[i].segment, lines_[parts[j].line], parts[j].segment);
      }
    }
  }

  void cross(DividedLine& a, std::size_t i, DividedLine& b, std::size_t j) {
    for (const Crossing& c : intersections(a.segments[i], b.segments[j])) {
      const std::size_t p = add_point(c.point);
      a.breaks.push_back({static_cast<double>(i) + c.t1, p});
      b.breaks.push_back({static_cast<double>(j) + c.t2, p});
    }
  }

  void add_edges(DividedLine& line) {
    std::sort(line.breaks.begin(), line.breaks.end(), [&](const LineBreak& a, const LineBreak& b) {
      return std::pair(a.u, node_of_[a.point]) < std::pair(b.u, node_of_[b.point]);
    });
    for (std::size_t i = 0; i + 1 < line.breaks.size(); ++i) {
      const LineBreak &from = line.breaks[i], &to = line.breaks[i + 1];
      if (from.u == to.u && node_of_[from.point] == node_of_[to.point]) continue;
      add_edge(line, from, to);
    }
  }

  void add_edge(const DividedLine& line, const LineBreak& from, const LineBreak& to) {
    const std::size_t a = node_of_[from.point], b = node_of_[to.point];
    const Point start = result_.nodes[a], end = result_.nodes[b];
    std::vector<Cubic> cubics = cubics_between(line.segments, from.u, to.u);
    if (cubics.empty()) cubics.push_back(straight(start, end));
    cubics.front().p[0] = start;
    cubics.back().p[3] = end;
    if (a == b) {
      Rect box;
      for (const Cubic& c : cubics) box.extend(control_bounds(c));
      if (std::max(box.width(), box.height()) <= 8.0 * result_.snap_mm) return;
    }
    MapEdge edge{line.stroke,           from.u,        to.u,     {a, b},
                 result_.cubics.size(), cubics.size(), line.link};
    result_.cubics.insert(result_.cubics.end(), cubics.begin(), cubics.end());
    result_.edges.push_back(edge);
  }

  [[nodiscard]] bool lies_on(const MapEdge& edge, const MapEdge& other) const {
    const double limit = 100.0 * result_.snap_mm * result_.snap_mm;
    const auto parts = result_.cubics_of(edge);
    for (const double share : {0.25, 0.5, 0.75}) {
      const double at = share * static_cast<double>(parts.size());
      const auto i = std::min(static_cast<std::size_t>(at), parts.size() - 1);
      const Point p = evaluate(parts[i], at - static_cast<double>(i));
      const auto on = result_.cubics_of(other);
      const bool hit = std::any_of(on.begin(), on.end(), [&](const Cubic& c) {
        return nearest_within(c, p, limit).has_value();
      });
      if (!hit) return false;
    }
    return true;
  }

  void drop_copies() {
    std::vector<std::size_t> order(result_.edges.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t e) {
      const auto [a, b] = result_.edges[e].nodes;
      return std::pair(std::min(a, b), std::max(a, b));
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    std::vector<std::uint8_t> copy(order.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size() && key(order[j]) == key(order[i]); ++j) {
        const MapEdge &low = result_.edges[order[i]], &high = result_.edges[order[j]];
        if (!copy[order[i]] && lies_on(high, low) && lies_on(low, high)) copy[order[j]] = 1;
      }
    }
    std::size_t kept = 0;
    for (std::size_t e = 0; e < copy.size(); ++e) {
      if (!copy[e]) result_.edges[kept++] = result_.edges[e];
    }
    result_.edges.resize(kept);
  }

  const LineMeetings& meetings_;
  std::map<StrokeId, std::size_t> index_of_;
  std::vector<DividedLine> lines_;  // the strokes, then the links
  std::vector<Cubic> link_segments_;
  std::vector<Point> points_;
  std::vector<std::size_t> node_of_;
  MapEdges result_;
};

}  // namespace

MapEdges divide_lines(const LineMeetings& meetings, std::vector<TipLink> links) {
  return Divider(meetings, std::move(links)).run();
}

std::vector<Cubic> cubics_between(std::span<const Cubic> segments, double from, double to) {
  constexpr double kSliver = 1e-12;
  std::vector<Cubic> cubics;
  const double low = std::min(from, to), high = std::max(from, to);
  const auto first = static_cast<std::size_t>(std::max(low, 0.0));
  for (std::size_t i = first; i < segments.size() && static_cast<double>(i) < high; ++i) {
    const auto start = static_cast<double>(i);
    const double t0 = std::max(low - start, 0.0), t1 = std::min(high - start, 1.0);
    if (t1 - t0 > kSliver) cubics.push_back(sub_segment(segments[i], t0, t1));
  }
  if (from > to) {
    std::reverse(cubics.begin(), cubics.end());
    for (Cubic& c : cubics) c = reversed(c);
  }
  return cubics;
}

}  // namespace felt
