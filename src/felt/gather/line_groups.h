#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/gather/line_sections.h"

namespace felt {

/// Settings for finding the strips of rough lines.
struct GroupOptions {
  /// The size that gaps are compared with, in mm; > 0. By default the diagonal of the lines' box.
  double scale_mm = 0.0;
  /// Added to the evidence for each pair: positive values make larger groups.
  double leniency = 0.0;
  /// Keeps the lines of hatchings (HatchingFinder) apart. Switch it off for lines that the user has
  /// chosen to gather.
  bool keeps_hatchings = true;
  /// The usual width of the lines, in mm: parallels whose ink nearly touches are one line.
  double ink_mm = 0.0;
};

/// Finds the rough lines that a person drew as one line, and returns the group of each line: groups
/// are numbered from 0 in the order of their first lines. Lines without length are groups of their
/// own. The result does not depend on the direction of a line, and a different order of lines only
/// changes the numbers.
///
/// Pairs of lines that lie beside each other get the logarithm of the odds that they belong
/// together (log_odds). Groups grow greedily by the pair of groups with the largest sum, until no
/// sum is positive: greedy additive edge contraction (Keuper et al., "Efficient Decomposition of
/// Image and Mesh Graphs by Lifted Multicuts", ICCV 2015, doi:10.1109/ICCV.2015.204). Negative
/// evidence keeps neighbouring strips apart even if single lines of both touch. Lines of a hatching
/// (HatchingFinder) never belong together.
///
/// Fails with kInvalidArgument if a coordinate is not finite or exceeds kMaxCoordinateMm, or if
/// there are more than 200,000 lines, and with kUnsupported and the position if so many lines lie
/// on each other there that comparing them would take too long. Copies of a line (copied_lines,
/// within 0.05 % of the scale) are compared only once.
Result<std::vector<std::uint32_t>> line_groups(std::span<const RoughLine> lines,
                                               const GroupOptions& options = {});

}  // namespace felt
