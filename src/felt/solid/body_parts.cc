#include "felt/solid/body_parts.h"

#include <cstdint>
#include <numeric>

namespace felt {
namespace body_components {

std::uint32_t root_of(std::vector<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace body_components

int euler_number(const SolidBody& body) noexcept {
  // Each triangle of a closed surface has three halves of edges.
  return static_cast<int>(body.points.size()) - static_cast<int>(body.triangles.size()) / 2;
}

double mean_edge_mm(const SolidBody& body) noexcept {
  double sum = 0.0;
  for (const SolidBody::Triangle& t : body.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      sum += norm(body.points[t[(k + 1) % 3]] - body.points[t[k]]);
    }
  }
  return body.triangles.empty() ? 0.0 : sum / (3.0 * static_cast<double>(body.triangles.size()));
}

std::vector<SolidBody> components_of(const SolidBody& body) {
  using body_components::root_of;
  const std::size_t n = body.points.size();
  std::vector<std::uint32_t> parent(n);
  std::iota(parent.begin(), parent.end(), 0U);
  for (const auto& [a, b, c] : body.triangles) {
    parent[root_of(parent, a)] = root_of(parent, b);
    parent[root_of(parent, b)] = root_of(parent, c);
  }
  constexpr std::uint32_t kNone = 0xFFFFFFFF;
  std::vector<std::uint32_t> part_of_root(n, kNone), number(n, kNone);
  std::vector<SolidBody> parts;
  for (const SolidBody::Triangle& t : body.triangles) {
    std::uint32_t& part = part_of_root[root_of(parent, t[0])];
    if (part == kNone) {
      part = static_cast<std::uint32_t>(parts.size());
      SolidBody& added = parts.emplace_back();
      added.stroke = body.stroke;
      added.color = body.color;
    }
    SolidBody::Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (number[t[k]] == kNone) {
        number[t[k]] = static_cast<std::uint32_t>(parts[part].points.size());
        parts[part].points.push_back(body.points[t[k]]);
      }
      corners[k] = number[t[k]];
    }
    parts[part].triangles.push_back(corners);
  }
  for (SolidBody& part : parts) part.holes = (2 - euler_number(part)) / 2;
  return parts;
}

}  // namespace felt
