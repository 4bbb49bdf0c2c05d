#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "felt/io/svg/svg_path.h"

namespace felt {

/// The dashes of a contour, by arc length: pieces of its cubics. `pattern` has an even number of
/// lengths of 0 or more, drawn and left out in turns, with a sum above 0; `offset` is where in it
/// the contour begins. A dash of no length is a contour of one point, where `keep_dots` asks for
/// it. None where there would be more than `most` of them.
std::optional<std::vector<SvgContour>> svg_dashes(const SvgContour& contour,
                                                  std::span<const double> pattern, double offset,
                                                  bool keep_dots, std::size_t most);

}  // namespace felt
