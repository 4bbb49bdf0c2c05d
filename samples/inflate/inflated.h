#pragma once

#include <array>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/vec3.h"
#include "felt/stroke/stroke.h"

/// A closed surface. Triangles turn counter-clockwise seen from outside, y points up, z to the
/// viewer (the sheet has y downwards).
struct Mesh {
  std::vector<felt::Vec3> points;
  std::vector<std::array<int, 3>> triangles;
  int outline_count = 0;  ///< the first points are the stroke's outline, z = 0
};

/// A closed stroke as a body: wide parts fat, narrow parts thin (after Teddy: Igarashi, Matsuoka,
/// Tanaka 1999). Half of its thickness at a place is sqrt(u), where u solves
///
///   laplace u = -3 inside,   u = 0 on the outline
///
/// which is as simple as a distance to the outline, and has no ridge where that one has: a long
/// strip (-2) becomes nearly round, a disc (-4) nearly a ball. Both sides share the outline.
///
/// `edges_across`: about how many triangles lie across a square of the same area.
/// Error: an open stroke, or one whose outline crosses itself.
felt::Result<Mesh> inflated(const felt::Stroke& stroke, int edges_across = 32);

/// As a Wavefront .obj, in mm.
std::string obj_text(const Mesh& mesh);
