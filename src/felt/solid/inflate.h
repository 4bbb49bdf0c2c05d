#pragma once

#include <optional>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/solid/outlines.h"
#include "felt/solid/solid.h"

namespace felt {

/// How outlines become bodies.
struct InflateOptions {
  static constexpr int kMinTriangles = 100;
  static constexpr int kMaxTriangles = 1'000'000;

  /// About how many triangles all bodies have together; kMinTriangles to kMaxTriangles. Narrow
  /// parts can need more. If absent, each body has as many as it needs to look smooth in a picture
  /// in which it is 1,200 pixels large, but all have at most about kMaxTriangles.
  std::optional<int> triangles{};
  double max_gap_mm = 2.0;  ///< gaps of the outline up to this size are closed, in mm; 0..32
  double thickness = 1.0;   ///< factor of the height; 0.05..20
  HoleChoice holes = HoleChoice::kKeep;
  FaultChoice faults = FaultChoice::kRefuse;
};

/// The bodies of a drawing, and sentences about what was left out.
struct InflatedDrawing {
  Solid solid;
  std::vector<std::string> notes;
};

/// Inflates the outlines of a drawing like balloons: wide parts become thick, narrow parts thin,
/// and the surface is smooth across the plane of the drawing. find_outlines() says which outlines
/// these are. The idea is that of Teddy (Igarashi, Matsuoka, Tanaka 1999,
/// <https://doi.org/10.1145/311535.311602>); the surface is that of inflated_heights().
///
/// Front and back are mirror images. If the outline of a body mirrors itself within a quarter of
/// the tolerance of the border, its body does so, too, up to rounding. The border is within 0.05 mm
/// of the outline (except for tips narrower than RingSpec::tip_mm, which are cut off). Every body
/// passes check_body().
///
/// The same drawing gives the same bytes. Fails if the options are out of range, if
/// find_outlines() fails, or if an outline touches itself, or almost so; the message says where.
/// With FaultChoice::kLeaveOut, such an outline is left out with a note if others remain.
Result<InflatedDrawing> inflate(const Document& document, const InflateOptions& options);

/// The size of an outline, or of several.
struct OutlineSize {
  double area_mm2 = 0.0;   ///< inside the outer curve, without the holes
  double length_mm = 0.0;  ///< of all curves, within a few percent
};

/// Returns the size of an outline.
OutlineSize size_of(const SolidOutline& outline) noexcept;

/// Inflates one outline. `origin` is the point of the page at x = y = 0 of the body. `whole` is the
/// size of all outlines that share `options.triangles`: that of this outline, if it is the only
/// one. Fails like inflate().
Result<SolidBody> inflate_outline(const SolidOutline& outline, Point origin,
                                  const OutlineSize& whole, const InflateOptions& options);

}  // namespace felt
