#pragma once

#include <span>
#include <vector>

#include "felt/geometry/cubic.h"
#include "felt/solid/ring.h"

namespace felt {

/// The mirror symmetry of an area: `count` axes through the centre, at equal angles.
struct MirrorAxes {
  Point centre;            ///< of the area
  double angle_rad = 0.0;  ///< of one of the axes, from +x to +y: that nearest to +y
  int count = 0;           ///< 0: the area mirrors itself nowhere
};

/// Finds the mirror axes of the area inside the curves (the outer one, then holes; of any
/// orientation). `rings` are polygons that follow the curves. An axis counts if the mirror image of
/// the border is within `tolerance_mm` of it. At most kMaxAxes axes are looked for; a disc, which
/// has more, gets four.
///
/// If z is the complex position relative to the centre, mirroring at an axis of angle a maps z to
/// e^(2ia) conj(z). A symmetric area therefore has moments m_k = integral z^k with arg m_k = k a
/// modulo pi, which leaves k angles to test for each k. The moments are integrals along the curves,
/// exact up to rounding.
MirrorAxes find_mirror_axes(std::span<const std::vector<Cubic>> curves, std::span<const Ring> rings,
                            double tolerance_mm);

inline constexpr int kMaxAxes = 16;

}  // namespace felt
