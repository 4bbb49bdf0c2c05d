#pragma once

#include <array>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/vec3.h"
#include "felt/stroke/stroke.h"

/// A closed surface. Triangles are counter-clockwise seen from outside; y points up and z to the
/// viewer (on the page y points down).
struct Mesh {
  std::vector<felt::Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  int outline_count = 0;  ///< the first points are the stroke's outline, with z = 0
};

/// Returns a closed stroke as a body: wide parts are thick, narrow parts thin (after Teddy:
/// Igarashi, Matsuoka, Tanaka 1999). Half of the thickness at a point is sqrt(u), where u solves
///
///   laplace u = -3 inside,   u = 0 on the outline
///
/// This is as simple as using the distance to the outline, but has no ridges: a long strip (-2)
/// becomes nearly round, a disc (-4) nearly a ball. Both sides share the outline.
///
/// `edges_across`: about how many triangles lie across a square of the same area. Fails if the
/// stroke is open, or if its outline crosses itself.
felt::Result<Mesh> inflated(const felt::Stroke& stroke, int edges_across = 32);

/// Returns the mesh as a Wavefront .obj, in mm.
std::string obj_text(const Mesh& mesh);
