#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "felt/io/svg/svg_path_builder.h"

namespace felt {

/// Divides a contour by arc length into dashes, which are pieces of its cubics. `pattern` has an
/// even number of lengths, alternately of a dash and of a gap. Requires that no length is negative
/// and that their sum is above 0. The contour begins at `offset` in the pattern. If `keep_dots` is
/// set, a dash without length becomes a contour of a single point. Returns nullopt if the result
/// would have more than `max_dashes` dashes.
std::optional<std::vector<SvgContour>> svg_dashes(const SvgContour& contour,
                                                  std::span<const double> pattern, double offset,
                                                  bool keep_dots, std::size_t max_dashes);

/// Joins dashes of a pattern without gaps where the line is smooth. They stay separate at corners,
/// because the corner between two dashes is not filled.
std::vector<SvgContour> joined_dashes(std::vector<SvgContour> dashes);

}  // namespace felt
