#pragma once

#include <cstddef>
#include <vector>

#include "felt/base/result.h"
#include "felt/io/svg/svg_scene.h"

namespace felt {

/// The widths that a PowerStroke of Inkscape says, in user units.
struct SvgPowerKnots {
  std::vector<WidthKnot> widths;   ///< from 0 to the end, linear in between
  std::vector<WidthKnot> written;  ///< the knots as the file has them, by their places
  bool is_sampled = false;         ///< `widths` are samples of a curve through the knots
};

/// Of a path with so many segments. Outside of the knots an open path keeps the width of the
/// nearest one, and a closed one goes on from the last to the first, as Inkscape does.
/// Error: no knots.
Result<SvgPowerKnots> svg_power_knots(const SvgVariableWidth& attributes, std::size_t segments,
                                      bool closed);

}  // namespace felt
