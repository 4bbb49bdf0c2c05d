#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "felt/fill/line_meetings.h"
#include "felt/fill/map_edges.h"

namespace felt {

/// The numbers of Euler's formula for planar graphs: nodes - edges + faces = 1 + components. The
/// face outside of everything counts.
struct MapCounts {
  std::size_t nodes = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t components = 0;
};

/// A closed walk along edges, with one face on its side. A half edge 2e follows edge e, 2e + 1 runs
/// against it.
struct MapLoop {
  std::vector<std::size_t> half_edges;
  double area_mm2 = 0.0;  ///< positive if the face is inside the loop
  Rect box;
  std::size_t component = 0;
  bool outer = false;  ///< the loop around its component: the face is outside
};

/// The planar map of strokes and links: the areas into which they divide the page. Source:
/// Baudelaire, Gangnet, "Planar maps: an interaction paradigm for graphic design", CHI 1989.
///
/// The half edges that leave a node are sorted by direction. Curves that are tangent there are
/// compared where they leave a small circle around the node: parts of curves that do not meet leave
/// it in the order in which they leave the node. The walk that always takes the next half edge in
/// this order goes around one face. An edge with the same walk on both sides bounds nothing (a dead
/// end, or the connection of two areas); such edges are dropped and the walks are repeated.
class PlanarMap {
 public:
  /// Makes the map of the edges.
  explicit PlanarMap(MapEdges edges);

  /// Returns the counts before edges that bound nothing are dropped.
  [[nodiscard]] const MapCounts& counts() const noexcept { return counts_; }
  [[nodiscard]] std::span<const MapLoop> loops() const noexcept { return loops_; }
  [[nodiscard]] const MapEdges& edges() const noexcept { return edges_; }

  /// Returns the index of the loop around the bounded face that contains p, or nullopt if p is in
  /// the face outside of everything.
  [[nodiscard]] std::optional<std::size_t> loop_around(Point p) const;
  /// Returns the indices of the loops of the holes in the face inside the loop. Requires that the
  /// loop is not an outer one.
  [[nodiscard]] std::vector<std::size_t> holes_in(std::size_t loop) const;

 private:
  using HalfEdge = std::size_t;

  void sort_half_edges();
  void trace();
  std::size_t drop_idle_edges();
  void set_components();
  [[nodiscard]] std::size_t tail(HalfEdge h) const { return edges_.edges[h / 2].nodes[h % 2]; }
  [[nodiscard]] MapLoop walk(HalfEdge first, std::vector<std::uint8_t>& seen) const;
  void measure(MapLoop& loop) const;
  [[nodiscard]] std::vector<std::uint8_t> parities(Point p) const;

  MapEdges edges_;
  std::vector<Rect> boxes_;                     // by edge, around the control points
  std::vector<std::vector<HalfEdge>> leaving_;  // by node, by direction from +x to +y
  std::vector<HalfEdge> next_;
  std::vector<std::size_t> component_;  // by node
  std::vector<std::uint8_t> dropped_;   // by edge
  std::vector<MapLoop> loops_;
  std::vector<std::size_t> loop_of_;  // by half edge
  MapCounts counts_;
};

}  // namespace felt
