#include "felt/solid/chords.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace felt {
namespace chord_split {

using Triangle = std::array<std::uint32_t, 3>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

Edge edge_of(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

/// The middles of the edges that are divided.
using Middles = std::map<Edge, std::uint32_t>;

/// Divides a triangle at the middles of its edges. Turns it so that the case has one form.
void divide(const Triangle& t, const Middles& middles, std::vector<Triangle>& out) {
  std::array<std::int64_t, 3> middle{};  // of the edge from corner k to the next
  int count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto at = middles.find(edge_of(t[k], t[(k + 1) % 3]));
    middle[k] = at == middles.end() ? -1 : static_cast<std::int64_t>(at->second);
    count += middle[k] >= 0 ? 1 : 0;
  }
  std::size_t turn = 0;
  if (count == 1) {
    while (middle[turn] < 0) ++turn;
  } else if (count == 2) {
    while (middle[(turn + 2) % 3] >= 0) ++turn;
  }
  const std::uint32_t a = t[turn], b = t[(turn + 1) % 3], c = t[(turn + 2) % 3];
  const auto m = static_cast<std::uint32_t>(middle[turn]);
  const auto n = static_cast<std::uint32_t>(middle[(turn + 1) % 3]);
  const auto o = static_cast<std::uint32_t>(middle[(turn + 2) % 3]);
  switch (count) {
    case 0:
      out.push_back(t);
      break;
    case 1:
      out.insert(out.end(), {{a, m, c}, {m, b, c}});
      break;
    case 2:
      out.insert(out.end(), {{m, b, n}, {a, m, n}, {a, n, c}});
      break;
    default:
      out.insert(out.end(), {{a, m, o}, {m, b, n}, {o, n, c}, {m, n, o}});
      break;
  }
}

}  // namespace chord_split

PlaneMesh without_chords(PlaneMesh mesh, const std::vector<std::uint8_t>& is_axis,
                         std::vector<std::uint8_t>& on_border) {
  using namespace chord_split;
  std::set<Edge> border;
  for (std::size_t i = 0; i < mesh.edges.size(); ++i) {
    if (!is_axis[i]) border.insert(edge_of(mesh.edges[i][0], mesh.edges[i][1]));
  }
  Middles middles;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (!on_border[a] || !on_border[b] || border.contains(edge_of(a, b))) continue;
      const auto number = static_cast<std::uint32_t>(mesh.points.size());
      if (!middles.emplace(edge_of(a, b), number).second) continue;
      mesh.points.push_back(lerp(mesh.points[a], mesh.points[b], 0.5));
      on_border.push_back(0);
    }
  }
  std::vector<Triangle> divided;
  for (const Triangle& t : mesh.triangles) divide(t, middles, divided);
  mesh.triangles = std::move(divided);
  return mesh;
}

}  // namespace felt
