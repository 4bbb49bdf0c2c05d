#include "felt/solid/plane_mesh.h"

// Without GMP, the exact arithmetic of the predicates is that of Boost, and nothing must be linked.
#define CGAL_DISABLE_GMP 1
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_size_criteria_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <exception>
#include <map>
#include <new>
#include <stdexcept>
#include <string>

#include "felt/geometry/polyline.h"

namespace felt {
namespace cgal_mesh {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Data = CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Kernel>,
                                                  CGAL::Delaunay_mesh_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Data, CGAL::No_constraint_intersection_tag>;
using Criteria = CGAL::Delaunay_mesh_size_criteria_2<Triangulation>;
using Mesher = CGAL::Delaunay_mesher_2<Triangulation, Criteria>;

constexpr const char* kCannotBeFilled = "the outline cannot be filled";

/// The bound of CGAL for the squared sine of the smallest angle: 20.7 degrees.
constexpr double kAngleBound = 0.125;

/// CGAL accesses memory out of bounds if both ends of a constraint are the same.
void insert_edge(Triangulation& triangulation, Triangulation::Vertex_handle a,
                 Triangulation::Vertex_handle b) {
  if (a == b) throw std::invalid_argument("");
  triangulation.insert_constraint(a, b);
}

void insert(Triangulation& triangulation, const std::vector<Point>& points,
            const std::vector<std::array<std::size_t, 2>>& edges) {
  std::vector<Triangulation::Vertex_handle> vertices;
  Triangulation::Face_handle near;
  for (const Point p : points) {
    vertices.push_back(triangulation.insert({p.x, p.y}, near));
    near = vertices.back()->face();
  }
  for (const auto& [a, b] : edges) insert_edge(triangulation, vertices[a], vertices[b]);
}

/// Marks the faces that an odd number of edges separates from the outside.
void mark_inside(Triangulation& triangulation) {
  for (auto face : triangulation.all_face_handles()) face->set_in_domain(false);
  std::vector<Triangulation::Face_handle> border{triangulation.infinite_face()}, stack;
  std::map<Triangulation::Face_handle, bool> seen;
  bool inside = false;
  while (!border.empty()) {
    stack.swap(border);
    border.clear();
    while (!stack.empty()) {
      const Triangulation::Face_handle face = stack.back();
      stack.pop_back();
      if (!seen.emplace(face, inside).second) continue;
      face->set_in_domain(inside);
      for (int i = 0; i < 3; ++i) {
        (face->is_constrained(i) ? border : stack).push_back(face->neighbor(i));
      }
    }
    inside = !inside;
  }
}

/// The mesher of CGAL computes the positions of new points with rounding. If two points, or a point
/// and an edge, are only some rounding errors apart (3e-14 mm at 200 mm from the origin), it does
/// not end or accesses memory out of bounds. This distance is large enough for it.
constexpr double kMinGapMm = 1e-9;

Point point_of(Triangulation::Vertex_handle vertex) {
  return {vertex->point().x(), vertex->point().y()};
}

/// Returns true if two points, or a given edge and another point, are nearer than kMinGapMm. Each
/// point and its nearest one are the ends of an edge of the triangulation; a point that is nearer
/// to the inside of a given edge than to its ends is the corner of a triangle at that edge.
bool nearly_touches_itself(const Triangulation& triangulation) {
  for (const auto& [face, i] : triangulation.finite_edges()) {
    const Point a = point_of(face->vertex(Triangulation::cw(i)));
    const Point b = point_of(face->vertex(Triangulation::ccw(i)));
    if (distance(a, b) < kMinGapMm) return true;
    if (!face->is_constrained(i)) continue;
    for (const auto corner : {face->vertex(i), triangulation.mirror_vertex(face, i)}) {
      if (triangulation.is_infinite(corner)) continue;
      const LineNearest near = nearest_on_line(a, b, point_of(corner));
      if (near.distance_squared < kMinGapMm * kMinGapMm) return true;
    }
  }
  return false;
}

PlaneMesh result_of(const Triangulation& triangulation) {
  PlaneMesh mesh;
  std::map<Triangulation::Vertex_handle, std::uint32_t> numbers;
  const auto number = [&](Triangulation::Vertex_handle vertex) {
    const auto [entry, is_new] =
        numbers.emplace(vertex, static_cast<std::uint32_t>(mesh.points.size()));
    if (is_new) mesh.points.push_back(point_of(vertex));
    return entry->second;
  };
  for (auto face : triangulation.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    const std::array<std::uint32_t, 3> corners = {number(face->vertex(0)), number(face->vertex(1)),
                                                  number(face->vertex(2))};
    mesh.triangles.push_back(corners);
    for (int i = 0; i < 3; ++i) {
      if (!face->is_constrained(i)) continue;
      mesh.edges.push_back({corners[static_cast<std::size_t>((i + 1) % 3)],
                            corners[static_cast<std::size_t>((i + 2) % 3)]});
    }
  }
  return mesh;
}

/// Returns the triangles inside a ring whose corners, in order, are these vertices.
Result<std::vector<std::array<std::uint32_t, 3>>> ring_triangles(
    const Triangulation& triangulation, const std::vector<Triangulation::Vertex_handle>& corners) {
  std::map<Triangulation::Vertex_handle, std::uint32_t> numbers;
  for (std::uint32_t i = 0; i < corners.size(); ++i) numbers.emplace(corners[i], i);
  if (numbers.size() != corners.size()) return invalid_data("the outline has equal points");
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (auto face : triangulation.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    triangles.push_back(
        {numbers.at(face->vertex(0)), numbers.at(face->vertex(1)), numbers.at(face->vertex(2))});
  }
  return triangles;
}

}  // namespace cgal_mesh

Result<PlaneMesh> fill_plane(const std::vector<Point>& points,
                             const std::vector<std::array<std::size_t, 2>>& edges, double edge_mm,
                             std::size_t max_points) {
  using namespace cgal_mesh;
  try {
    Triangulation triangulation;
    insert(triangulation, points, edges);
    if (triangulation.dimension() < 2) return invalid_data("the outline has no area");
    if (nearly_touches_itself(triangulation)) return invalid_data(kCannotBeFilled);
    mark_inside(triangulation);
    Mesher mesher(triangulation, Criteria(kAngleBound, edge_mm));
    mesher.init(true);
    while (mesher.try_one_step_refine_mesh()) {
      if (triangulation.number_of_vertices() > max_points) {
        return fail(ErrorCode::kLimitExceeded, "the outline has too many narrow parts");
      }
    }
    return result_of(triangulation);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    // CGAL's text has several lines and names its sources.
    return invalid_data(kCannotBeFilled);
  }
}

Result<std::vector<std::array<std::uint32_t, 3>>> triangulate_ring(const std::vector<Point>& ring) {
  using namespace cgal_mesh;
  try {
    Triangulation triangulation;
    std::vector<Triangulation::Vertex_handle> corners;
    Triangulation::Face_handle near;
    for (const Point p : ring) {
      corners.push_back(triangulation.insert({p.x, p.y}, near));
      near = corners.back()->face();
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      insert_edge(triangulation, corners[i], corners[(i + 1) % corners.size()]);
    }
    if (triangulation.dimension() < 2) return invalid_data("the outline has no area");
    mark_inside(triangulation);
    return ring_triangles(triangulation, corners);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    // CGAL's text has several lines and names its sources.
    return invalid_data(kCannotBeFilled);
  }
}

}  // namespace felt
