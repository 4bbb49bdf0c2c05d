#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/motion/similarity.h"

namespace felt {

/// More strokes in one key drawing are not compared.
inline constexpr std::size_t kMaxMatchedStrokes = 5000;

/// A stroke of the first key drawing, or a part of it, that becomes a stroke of the second one, or
/// a part of it. Strokes are named by their index in the lists given to match_strokes().
struct StrokeMatch {
  std::optional<std::size_t> from;  ///< absent: the stroke appears
  std::optional<std::size_t> to;    ///< absent: the stroke disappears
  /// The parts of both strokes, as shares 0..1 of their lengths. Whole strokes, unless one stroke
  /// becomes two or two become one.
  double from_start = 0.0, from_end = 1.0;
  double to_start = 0.0, to_end = 1.0;
  bool reversed = false;  ///< the second stroke was drawn in the opposite direction
  bool is_given = false;  ///< the user gave this pair
  /// How much the strokes differ; 0 if they are equal and moved with the drawing. Without a partner
  /// 0.
  double cost = 0.0;

  friend bool operator==(const StrokeMatch&, const StrokeMatch&) = default;
};

/// Which strokes of two key drawings belong together. Every stroke of both is in at least one
/// match.
struct Correspondence {
  Similarity motion;                 ///< of the drawing as a whole
  std::vector<StrokeMatch> matches;  ///< by `from`, and then those that appear, by `to`
};

/// A pair of strokes that belong together because the user says so. If one of them is absent, the
/// other one has no partner.
struct GivenPair {
  std::optional<std::size_t> from, to;
};

/// Finds the strokes that belong together (docs/design/motion.md#correspondence): removes the
/// motion of the whole drawing, compares strokes by position, shape, length, turning and order, and
/// by how their neighbours moved, and assigns them with the least total cost. Then looks for
/// strokes that were split into two, or drawn as two and joined. Given pairs override this.
///
/// Fails with kLimitExceeded if a drawing has more than kMaxMatchedStrokes strokes, and with
/// kInvalidArgument if a given pair names a stroke that does not exist, or a stroke twice. Equal
/// input gives an equal result. Takes quadratic time in the number of strokes, apart from the
/// assignment.
Result<Correspondence> match_strokes(std::span<const StrokePtr> from, std::span<const StrokePtr> to,
                                     std::span<const GivenPair> given = {});

/// Returns the pair that a user means by a line drawn from a stroke of the first key drawing to a
/// stroke of the second: the strokes nearest to both ends. Returns nullopt if a drawing has no
/// stroke within `reach_mm` of its end.
std::optional<GivenPair> pair_by_line(std::span<const StrokePtr> from,
                                      std::span<const StrokePtr> to, Point start, Point end,
                                      double reach_mm = 20.0);

}  // namespace felt
