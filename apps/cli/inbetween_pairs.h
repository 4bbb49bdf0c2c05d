#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "felt/base/result.h"
#include "felt/motion/inbetween.h"

namespace felt::cli {

/// A value of --pair: "3:5", "s3:s5", "3:none", or "2:3:5" for the step from the second to the
/// third key drawing. Strokes are named by their ids, as in the table of --matches.
struct PairArgument {
  std::size_t step = 0;  ///< 0: from the first to the second key drawing
  std::string from, to;  ///< "none": no stroke
};

/// Parses a value of --pair. Fails if it does not have one of these forms.
Result<PairArgument> parse_pair(const std::string& text);

/// Returns the pairs of a step, as indices in the strokes of its key drawings. Fails if a drawing
/// has no stroke with the id.
Result<std::vector<GivenPair>> pairs_of_step(std::span<const PairArgument> pairs, std::size_t step,
                                             const KeyStrokes& from, const KeyStrokes& to);

/// Returns the header of the table of --matches, and the rows of a step.
std::string matches_header();
std::string matches_rows(const Correspondence& correspondence, std::size_t step,
                         const KeyStrokes& from, const KeyStrokes& to);

}  // namespace felt::cli
