#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "felt/gather/line_sections.h"

namespace felt {

/// Finds lines that are copies of each other, in either direction, and returns for each line the
/// index of the copy that represents it. A line without copies represents itself. Copies have their
/// lengths, ends and seven points in between in the same cells of a grid of `tolerance_mm` > 0, so
/// copies never differ by more than that at these points, but two lines that are as near may still
/// count as different. Lines without length have no copies. Which lines are copies does not depend
/// on their order. Takes O(n log n) time for n lines.
std::vector<std::uint32_t> copied_lines(std::span<const RoughLine> lines, double tolerance_mm);

}  // namespace felt
