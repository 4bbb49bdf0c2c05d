#include "felt/solid/creases.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "felt/geometry/triangle_tree.h"

namespace felt {
namespace crease_search {

/// The corners of all triangles, in groups that share a point.
class Corners {
 public:
  explicit Corners(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::size_t> parent_;
};

std::vector<Vec3> facet_normals(const SolidBody& body) {
  std::vector<Vec3> normals;
  normals.reserve(body.triangles.size());
  for (const auto& [a, b, c] : body.triangles) {
    const Vec3 n = cross(body.points[b] - body.points[a], body.points[c] - body.points[a]);
    const double length = norm(n);
    normals.push_back(length > 0.0 ? (1.0 / length) * n : Vec3{});
  }
  return normals;
}

/// An edge of the surface: the corners at which its two directed edges begin, and how far the
/// facets at both sides turn.
struct Edge {
  std::size_t start, twin;
  double turn_deg;
  bool is_crease;
};

std::size_t next_corner(std::size_t corner) {
  return corner % 3 == 2 ? corner - 2 : corner + 1;
}

std::vector<Edge> edges_of(const SolidBody& body) {
  const std::vector<Vec3> normals = facet_normals(body);
  std::vector<Edge> edges;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> starts;  // of directed edges
  for (std::size_t i = 0; i < body.triangles.size(); ++i) {
    const SolidBody::Triangle& t = body.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      starts.emplace(std::pair(t[k], t[(k + 1) % 3]), 3 * i + k);
      const auto twin = starts.find({t[(k + 1) % 3], t[k]});
      if (twin == starts.end()) continue;
      const double cosine = dot(normals[i], normals[twin->second / 3]);
      const double turn = std::acos(std::clamp(cosine, -1.0, 1.0));
      edges.push_back({3 * i + k, twin->second, turn * 180.0 / std::numbers::pi, false});
    }
  }
  return edges;
}

/// Returns how far the facets turn at an edge that is certainly a crease: a few times as far as at
/// nearly all others. The finer the surface, the better the two are told apart.
double crease_deg(const std::vector<Edge>& edges) {
  constexpr double kUsualShare = 0.9, kTimes = 3.0;
  if (edges.empty()) return kMaxCreaseDeg;
  std::vector<double> turns;
  for (const Edge& edge : edges) turns.push_back(edge.turn_deg);
  const auto usual = turns.begin() + static_cast<std::ptrdiff_t>(
                                         kUsualShare * static_cast<double>(turns.size() - 1));
  std::nth_element(turns.begin(), usual, turns.end());
  return std::clamp(kTimes * *usual, kMinCreaseDeg, kMaxCreaseDeg);
}

/// Finds the creases of a surface: edges that turn far, and those that turn less but continue a
/// crease that would end there. The border of a cut is one line, however flat it is in parts
/// (hysteresis as in Canny, 1986, DOI 10.1109/TPAMI.1986.4767851).
class CreaseSearch {
 public:
  CreaseSearch(const SolidBody& body, std::vector<Edge>& edges) : body_(body), edges_(edges) {}

  void run();

 private:
  static constexpr double kWeakShare = 0.3;
  static constexpr double kMinStraightness = 0.7;  // cosine of the turn of a crease at a point

  [[nodiscard]] std::uint32_t point(std::size_t corner) const {
    return body_.triangles[corner / 3][corner % 3];
  }
  [[nodiscard]] std::uint32_t other_end(const Edge& edge, std::uint32_t from) const {
    const std::uint32_t start = point(edge.start);
    return start == from ? point(next_corner(edge.start)) : start;
  }
  void extend(std::size_t edge, std::uint32_t end);
  [[nodiscard]] std::size_t continuation(std::size_t edge, std::uint32_t end) const;

  const SolidBody& body_;
  std::vector<Edge>& edges_;
  std::vector<std::vector<std::size_t>> weak_;  // the weak edges and the creases at each point
};

void CreaseSearch::run() {
  const double strong_deg = crease_deg(edges_);
  weak_.resize(body_.points.size());
  std::vector<std::size_t> strong;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    Edge& edge = edges_[i];
    edge.is_crease = edge.turn_deg > strong_deg;
    if (edge.is_crease) strong.push_back(i);
    if (edge.turn_deg <= kWeakShare * strong_deg) continue;
    weak_[point(edge.start)].push_back(i);
    weak_[point(next_corner(edge.start))].push_back(i);
  }
  for (const std::size_t i : strong) {
    const std::uint32_t a = point(edges_[i].start);
    extend(i, a);
    extend(i, other_end(edges_[i], a));
  }
}

/// Marks the edges that continue a crease beyond one of its ends.
void CreaseSearch::extend(std::size_t edge, std::uint32_t end) {
  for (std::size_t next = continuation(edge, end); next != edge; next = continuation(edge, end)) {
    edges_[next].is_crease = true;
    edge = next;
    end = other_end(edges_[next], end);
  }
}

/// Returns the edge that turns most of those that go on from the end of a crease, or the crease
/// itself if there is none, or if the crease does not end there.
std::size_t CreaseSearch::continuation(std::size_t edge, std::uint32_t end) const {
  const Vec3 along = body_.points[end] - body_.points[other_end(edges_[edge], end)];
  std::size_t best = edge;
  for (const std::size_t i : weak_[end]) {
    if (i == edge) continue;
    if (edges_[i].is_crease) return edge;
    const Vec3 on = body_.points[other_end(edges_[i], end)] - body_.points[end];
    if (dot(along, on) < kMinStraightness * norm(along) * norm(on)) continue;
    if (best == edge || edges_[i].turn_deg > edges_[best].turn_deg) best = i;
  }
  return best;
}

/// Joins the corners at both ends of each edge at which the surface is smooth.
Corners smooth_corners(const SolidBody& body) {
  std::vector<Edge> edges = edges_of(body);
  CreaseSearch(body, edges).run();
  Corners corners(3 * body.triangles.size());
  for (const Edge& edge : edges) {
    if (edge.is_crease) continue;
    corners.join(next_corner(edge.start), edge.twin);
    corners.join(edge.start, next_corner(edge.twin));
  }
  return corners;
}

}  // namespace crease_search

SolidBody split_at_creases(const SolidBody& body) {
  SolidBody split = body;
  if (body.border_count > 0) return split;
  crease_search::Corners corners = crease_search::smooth_corners(body);
  constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::vector<std::uint32_t> point_of_group(3 * body.triangles.size(), kNone);
  std::vector<bool> is_used(body.points.size(), false);
  for (std::size_t i = 0; i < body.triangles.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t at = body.triangles[i][k];
      std::uint32_t& number = point_of_group[corners.root(3 * i + k)];
      if (number == kNone && !is_used[at]) {
        is_used[at] = true;
        number = at;
      } else if (number == kNone) {
        number = static_cast<std::uint32_t>(split.points.size());
        split.points.push_back(body.points[at]);
        if (!body.paint.empty()) split.paint.push_back(body.paint[at]);
      }
      split.triangles[i][k] = number;
    }
  }
  return split;
}

}  // namespace felt
