#include "felt/solid/body_boolean.h"

#include "felt/geometry/triangle_tree.h"

// Without GMP, the exact arithmetic is that of Boost, and nothing must be linked.
#define CGAL_DISABLE_GMP 1
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace felt {
namespace cgal_boolean {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Face = Mesh::Face_index;

/// Edges and triangles that are thinner than this share of the others are removed. Files store
/// floats, and check_body() wants a sine of 1e-5.
constexpr double kMinShare = 1e-3;
constexpr int kSliverPasses = 12;

Vec3 point_of(const Mesh& mesh, Vertex v) {
  const auto& p = mesh.point(v);
  return {p.x(), p.y(), p.z()};
}

Mesh mesh_of(const SolidBody& body) {
  Mesh mesh;
  mesh.reserve(static_cast<Mesh::size_type>(body.points.size()),
               static_cast<Mesh::size_type>(3 * body.triangles.size() / 2),
               static_cast<Mesh::size_type>(body.triangles.size()));
  for (const Vec3& p : body.points) mesh.add_vertex({p.x, p.y, p.z});
  for (const auto& [a, b, c] : body.triangles) mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  return mesh;
}

/// Returns the points and triangles of a mesh, in the order in which the mesh has them.
SolidBody body_of(const Mesh& mesh) {
  SolidBody body;
  std::vector<std::uint32_t> numbers(mesh.num_vertices() + mesh.number_of_removed_vertices());
  for (const Vertex v : mesh.vertices()) {
    numbers[v] = static_cast<std::uint32_t>(body.points.size());
    body.points.push_back(point_of(mesh, v));
  }
  for (const Face f : mesh.faces()) {
    SolidBody::Triangle corners{};
    std::size_t k = 0;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) {
      corners[k++ % 3] = numbers[v];
    }
    body.triangles.push_back(corners);
  }
  return body;
}

/// Removes the thin edges and triangles of a mesh.
class SliverRemoval {
 public:
  explicit SliverRemoval(Mesh& mesh) : mesh_(mesh) {}

  void run() {
    double sum = 0.0;
    for (const auto e : mesh_.edges()) sum += length(mesh_.halfedge(e));
    min_edge_ = kMinShare * sum / std::max<double>(mesh_.number_of_edges(), 1.0);
    for (int pass = 0; pass < kSliverPasses; ++pass) {
      if (!remove_once()) break;
    }
  }

 private:
  [[nodiscard]] double length(Halfedge h) const {
    return norm(point_of(mesh_, mesh_.target(h)) - point_of(mesh_, mesh_.source(h)));
  }
  /// Returns the height of a triangle above its longest edge `h`, as a share of that edge.
  [[nodiscard]] double height_share(Halfedge h) const {
    const Vec3 a = point_of(mesh_, mesh_.source(h)), b = point_of(mesh_, mesh_.target(h));
    const Vec3 c = point_of(mesh_, mesh_.target(mesh_.next(h)));
    const double twice = norm_squared(b - a);
    return twice > 0.0 ? norm(cross(b - a, c - a)) / twice : 0.0;
  }
  [[nodiscard]] Halfedge longest(Face f) const {
    Halfedge best = mesh_.halfedge(f);
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f))) {
      if (length(h) > length(best)) best = h;
    }
    return best;
  }
  [[nodiscard]] Halfedge shortest(Face f) const {
    Halfedge best = mesh_.halfedge(f);
    for (const Halfedge h : mesh_.halfedges_around_face(mesh_.halfedge(f))) {
      if (length(h) < length(best)) best = h;
    }
    return best;
  }
  bool remove_once();
  bool collapse(Halfedge h);
  bool flip(Halfedge h);

  Mesh& mesh_;
  double min_edge_ = 0.0;
};

/// Replaces the source of a halfedge by its target.
bool SliverRemoval::collapse(Halfedge h) {
  if (mesh_.number_of_faces() <= 8) return false;
  const auto e = mesh_.edge(h);
  if (!CGAL::Euler::does_satisfy_link_condition(e, mesh_)) return false;
  const auto at = mesh_.point(mesh_.target(h));
  const Vertex left = CGAL::Euler::collapse_edge(e, mesh_);
  mesh_.point(left) = at;
  return true;
}

/// Gives the two triangles of an edge their other diagonal.
bool SliverRemoval::flip(Halfedge h) {
  const Vertex c = mesh_.target(mesh_.next(h));
  const Vertex d = mesh_.target(mesh_.next(mesh_.opposite(h)));
  if (c == d || mesh_.halfedge(c, d) != Mesh::null_halfedge()) return false;
  CGAL::Euler::flip_edge(h, mesh_);
  return true;
}

bool SliverRemoval::remove_once() {
  bool changed = false;
  std::vector<Face> faces(mesh_.faces().begin(), mesh_.faces().end());
  for (const Face f : faces) {
    if (mesh_.is_removed(f)) continue;
    const Halfedge small = shortest(f);
    if (length(small) < min_edge_ && collapse(small)) {
      changed = true;
      continue;
    }
    const Halfedge wide = longest(f);
    if (height_share(wide) >= kMinShare) continue;
    // A needle has one short edge; a cap has none, and its middle corner lies on the longest edge.
    const bool is_needle = length(small) < 0.1 * length(wide);
    changed = (is_needle && collapse(small)) || flip(wide) || changed;
  }
  return changed;
}

}  // namespace cgal_boolean

Result<SolidBody> combine(const SolidBody& a, const SolidBody& b, BodyBoolean operation) {
  using namespace cgal_boolean;
  try {
    Mesh first = mesh_of(a), second = mesh_of(b), out;
    const auto careful = CGAL::parameters::throw_on_self_intersection(true);
    const bool is_manifold =
        operation == BodyBoolean::kUnion
            ? PMP::corefine_and_compute_union(first, second, out, careful)
            : PMP::corefine_and_compute_difference(first, second, out, careful);
    if (!is_manifold) return invalid_data("parts of the body would meet in only a point or a line");
    SliverRemoval(out).run();
    return body_of(out);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const PMP::Corefinement::Self_intersection_exception&) {
    return invalid_data("the surface of the body crosses itself there");
  } catch (const std::exception&) {
    // CGAL's text has several lines and names its sources.
    return invalid_data("the surfaces cannot be joined");
  }
}

bool crosses_itself(const SolidBody& body) {
  return cgal_boolean::PMP::does_self_intersect(cgal_boolean::mesh_of(body));
}

void remove_slivers(SolidBody& body) {
  cgal_boolean::Mesh mesh = cgal_boolean::mesh_of(body);
  cgal_boolean::SliverRemoval(mesh).run();
  SolidBody rest = cgal_boolean::body_of(mesh);
  body.points = std::move(rest.points);
  body.triangles = std::move(rest.triangles);
}

}  // namespace felt
