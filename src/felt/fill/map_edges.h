#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "felt/fill/tip_links.h"

namespace felt {

/// Points nearer to each other than this, in mm, become one node of the map. At large coordinates
/// the distance grows with the accuracy of crossings (intersect.h). Source: points are rounded to
/// one another so that curves keep their order around them, as in Hobby, "Practical segment
/// intersection with finite precision output", Computational Geometry 13, 1999.
inline constexpr double kSnapMm = 1e-6;

/// A part of a stroke or of a link between two nodes, without a node between them.
struct MapEdge {
  StrokeId stroke;  ///< zero for a link
  double from = 0.0;
  double to = 0.0;
  std::array<std::size_t, 2> nodes{};
  std::size_t first_cubic = 0;
  std::size_t cubic_count = 0;
  std::size_t link = 0;  ///< the index of the link; not used for a stroke
};

/// The graph of strokes and links: nodes where they meet or end, and the edges between.
struct MapEdges {
  std::vector<Point> nodes;
  std::vector<MapEdge> edges;
  std::vector<Cubic> cubics;
  std::vector<TipLink> links;
  double snap_mm = kSnapMm;

  [[nodiscard]] std::span<const Cubic> cubics_of(const MapEdge& edge) const {
    return std::span(cubics).subspan(edge.first_cubic, edge.cubic_count);
  }
};

/// Divides strokes and links where they meet. Parts that lie on top of each other give one edge, of
/// the stroke with the lowest id.
MapEdges divide_lines(const LineMeetings& meetings, std::vector<TipLink> links);

/// Returns the part of a stroke between two parameters as cubics, reversed if from > to.
std::vector<Cubic> cubics_between(std::span<const Cubic> segments, double from, double to);

}  // namespace felt
