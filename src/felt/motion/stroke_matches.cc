#include "felt/motion/stroke_matches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "felt/geometry/polyline.h"
#include "felt/motion/assignment.h"
#include "felt/motion/group_motion.h"
#include "felt/motion/match_costs.h"
#include "felt/motion/split_matches.h"

namespace felt {
namespace {

/// The distance that costs 1, as a share of the diagonal of the drawing.
constexpr double kReachShare = 0.2;
constexpr int kMatchRounds = 8, kMinMatchRounds = 2;
constexpr double kSettledShare = 0.97;
/// The neighbours of a stroke that tell how it moved.
constexpr std::size_t kNeighbours = 24;
/// The cost from which two strokes do not belong together: in the first round, and later this
/// multiple of the usual cost and more.
constexpr double kFirstLimit = 1.2, kUsualFactor = 5.0, kMinLimit = 0.45;
/// The weight of the motion of the whole drawing in the motion of a stroke's neighbours.
constexpr double kWholeWeight = 0.02;
/// Long strokes are less easily taken for others, so their weight grows with this power of the
/// length.
constexpr double kLengthPower = 1.5;
/// Matches that cost less than this count fully when the motion of neighbours is estimated.
constexpr double kSureCost = 0.2;

std::vector<StrokeShape> shapes_of(std::span<const StrokePtr> strokes) {
  std::vector<StrokeShape> shapes;
  shapes.reserve(strokes.size());
  for (const StrokePtr& stroke : strokes) shapes.push_back(shape_of(*stroke));
  return shapes;
}

double rank_of(std::size_t i, std::size_t count) noexcept {
  return (static_cast<double>(i) + 0.5) / static_cast<double>(count);
}

/// The search for a correspondence.
class StrokeMatcher {
 public:
  StrokeMatcher(std::span<const StrokePtr> from, std::span<const StrokePtr> to,
                std::span<const GivenPair> given)
      : from_strokes_(from),
        to_strokes_(to),
        from_(shapes_of(from)),
        to_(shapes_of(to)),
        given_(given),
        partner_(from.size(), kUnassigned),
        costs_(from.size(), 0.0),
        from_fixed_(from.size(), false),
        to_fixed_(to.size(), false) {
    for (const GivenPair& pair : given) {
      if (pair.from) from_fixed_[*pair.from] = true;
      if (pair.to) to_fixed_[*pair.to] = true;
    }
  }

  Correspondence match() {
    motion_ = estimate_group_motion(from_, to_);
    scale_.reach_mm = std::max(kReachShare * std::max(diagonal_mm(from_), diagonal_mm(to_)), 1.0);
    local_.assign(from_.size(), motion_);
    find_neighbours();
    for (int round = 1; round <= kMatchRounds; ++round) {
      const std::vector<std::int32_t> before = partner_;
      const double cost_before = total_cost();
      move_shapes();
      assign();
      // What is known of the motion spreads from stroke to stroke as long as the costs fall.
      const bool is_settled = round > kMinMatchRounds && before == partner_ &&
                              total_cost() > kSettledShare * cost_before;
      if (is_settled || round == kMatchRounds) break;
      refine_motion();
      find_local_motions();
      choose_limit();
    }
    return result();
  }

 private:
  void move_shapes() {
    there_.clear();
    for (std::size_t i = 0; i < from_.size(); ++i) there_.push_back(moved(local_[i], from_[i]));
  }

  void assign() {
    CostTable table{from_.size(), to_.size(), {}};
    table.costs.assign(from_.size() * to_.size(), static_cast<float>(limit_));
    for (std::size_t i = 0; i < from_.size(); ++i) {
      if (from_fixed_[i]) continue;
      for (std::size_t k = 0; k < to_.size(); ++k) {
        if (!to_fixed_[k]) table.at(i, k) = static_cast<float>(cost_of(i, k).cost);
      }
    }
    partner_ = min_cost_assignment(table, static_cast<float>(limit_));
    for (const GivenPair& pair : given_) {
      if (pair.from && pair.to) partner_[*pair.from] = static_cast<std::int32_t>(*pair.to);
    }
    for (std::size_t i = 0; i < from_.size(); ++i) {
      if (partner_[i] == kUnassigned) continue;
      const MatchCost cost = cost_of(i, static_cast<std::size_t>(partner_[i]));
      costs_[i] = cost.cost;
      pairings_.resize(from_.size());
      pairings_[i] = cost.pairing;
    }
  }

  [[nodiscard]] MatchCost cost_of(std::size_t i, std::size_t k) const {
    const double ranks = std::fabs(rank_of(i, from_.size()) - rank_of(k, to_.size()));
    const double limit = from_fixed_[i] ? 1e300 : limit_;
    return match_cost(there_[i], to_[k], scale_, ranks, limit);
  }

  [[nodiscard]] double total_cost() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      sum += partner_[i] == kUnassigned ? 0.5 * limit_ : costs_[i];
    }
    return sum;
  }

  void refine_motion() {
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      if (partner_[i] == kUnassigned) continue;
      const StrokeShape& to = to_[static_cast<std::size_t>(partner_[i])];
      for (std::size_t p = 1; p < kShapePoints; p += 7) {
        pairs.push_back(
            {from_[i].points[p], paired_point(to, pairings_[i], p), std::sqrt(from_[i].length_mm)});
      }
    }
    // Few strokes do not tell a motion of the whole from motions of their own.
    if (pairs.size() >= 8) motion_ = fit_robust_similarity(pairs, motion_);
    moved_.clear();
    for (const StrokeShape& shape : from_) {
      const StrokeShape there = moved(motion_, shape);
      for (std::size_t p = 0; p < kShapePoints; p += (kShapePoints - 1) / 2) {
        moved_.push_back(there.points[p]);
      }
    }
  }

  void find_neighbours() {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      near.clear();
      for (std::size_t k = 0; k < from_.size(); ++k) {
        if (k != i) near.emplace_back(distance_squared(from_[i].centre, from_[k].centre), k);
      }
      const std::size_t kept = std::min(near.size(), kNeighbours);
      std::partial_sort(near.begin(), near.begin() + static_cast<std::ptrdiff_t>(kept), near.end());
      neighbours_.emplace_back();
      for (std::size_t k = 0; k < kept; ++k) neighbours_.back().push_back(near[k].second);
    }
  }

  /// Estimates for each stroke how its neighbours moved: the similarity that fits their points
  /// best, weighted by the inverse fourth power of their distance (moving least squares; Schaefer,
  /// McPhail and Warren, 2006, doi:10.1145/1141911.1141920). The stroke itself does not count.
  void find_local_motions() {
    constexpr std::size_t kStep = (kShapePoints - 1) / 2;
    const double near = 0.1 * scale_.reach_mm;
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      pairs.clear();
      const Point at = from_[i].centre;
      for (const std::size_t k : neighbours_[i]) {
        for (std::size_t p = 0; p < kShapePoints; p += kStep) {
          const Point from = from_[k].points[p];
          const double apart = distance_squared(at, from) + near * near;
          const double weight = std::pow(from_[k].length_mm, kLengthPower) / (apart * apart);
          pairs.push_back({from, moved_[3 * k + p / kStep], kWholeWeight * weight});
          if (partner_[k] == kUnassigned) continue;
          const double sure = kSureCost / std::max(costs_[k], kSureCost);
          const StrokeShape& to = to_[static_cast<std::size_t>(partner_[k])];
          pairs.push_back({from, paired_point(to, pairings_[k], p), weight * sure});
        }
      }
      local_[i] = fit_similarity(pairs).value_or(motion_);
    }
  }

  /// Strokes that differ much more than usual do not belong together.
  void choose_limit() {
    std::vector<double> costs;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      if (partner_[i] != kUnassigned && !from_fixed_[i]) costs.push_back(costs_[i]);
    }
    if (costs.size() < 4) return;
    const auto middle = costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2);
    std::nth_element(costs.begin(), middle, costs.end());
    limit_ = std::clamp(0.3 + kUsualFactor * *middle, kMinLimit, kFirstLimit);
  }

  [[nodiscard]] Correspondence result() {
    Correspondence result{motion_, {}};
    std::vector<bool> has_partner(to_.size(), false);
    for (std::size_t i = 0; i < from_.size(); ++i) {
      StrokeMatch match;
      match.from = i;
      match.is_given = from_fixed_[i];
      if (partner_[i] != kUnassigned) {
        match.to = static_cast<std::size_t>(partner_[i]);
        match.reversed = pairings_[i].reversed;
        match.cost = costs_[i];
        has_partner[*match.to] = true;
      }
      result.matches.push_back(match);
    }
    for (std::size_t k = 0; k < to_.size(); ++k) {
      if (has_partner[k]) continue;
      StrokeMatch match;
      match.to = k;
      match.is_given = to_fixed_[k];
      result.matches.push_back(match);
    }
    find_splits(result.matches);
    std::stable_sort(result.matches.begin(), result.matches.end(), is_before);
    return result;
  }

  void find_splits(std::vector<StrokeMatch>& matches) const {
    SplitSide from{there_, {}}, to{to_, {}};
    for (std::size_t i = 0; i < from_.size(); ++i) {
      from.lines.push_back(coarse_line(*from_strokes_[i]));
      for (Point& p : from.lines.back()) p = moved(local_[i], p);
    }
    for (const StrokePtr& stroke : to_strokes_) to.lines.push_back(coarse_line(*stroke));
    match_split_strokes(from, to, scale_, limit_, matches);
  }

  static bool is_before(const StrokeMatch& a, const StrokeMatch& b) noexcept {
    const std::size_t last = kMaxMatchedStrokes + 1;
    const std::size_t a_from = a.from.value_or(last), b_from = b.from.value_or(last);
    if (a_from != b_from) return a_from < b_from;
    if (a.from_start != b.from_start) return a.from_start < b.from_start;
    return a.to.value_or(last) < b.to.value_or(last);
  }

  std::span<const StrokePtr> from_strokes_, to_strokes_;
  std::vector<StrokeShape> from_, to_, there_;  // there_: where from_ is expected in the second key
  std::span<const GivenPair> given_;
  Similarity motion_;
  MatchScale scale_;
  double limit_ = kFirstLimit;
  std::vector<Similarity> local_;  // the motion of each stroke, as its neighbours tell
  std::vector<std::vector<std::size_t>> neighbours_;
  std::vector<Point> moved_;  // three points of each stroke, moved with the whole drawing
  std::vector<std::int32_t> partner_;
  std::vector<double> costs_;
  std::vector<ShapePairing> pairings_;
  std::vector<bool> from_fixed_, to_fixed_;
};

Result<void> check_given(std::span<const GivenPair> given, std::size_t from, std::size_t to) {
  std::vector<bool> from_used(from, false), to_used(to, false);
  const auto use = [](const std::optional<std::size_t>& i, std::vector<bool>& used,
                      const char* key) -> Result<void> {
    if (!i) return {};
    const std::string name = "stroke " + std::to_string(*i + 1) + " of the " + key + " drawing";
    if (*i >= used.size()) return fail(ErrorCode::kInvalidArgument, name + " does not exist");
    if (used[*i]) return fail(ErrorCode::kInvalidArgument, name + " is in two given pairs");
    used[*i] = true;
    return {};
  };
  for (const GivenPair& pair : given) {
    if (auto ok = use(pair.from, from_used, "first"); !ok) return ok;
    if (auto ok = use(pair.to, to_used, "second"); !ok) return ok;
  }
  return {};
}

std::optional<std::size_t> nearest_stroke(std::span<const StrokePtr> strokes, Point p,
                                          double reach_mm) {
  std::optional<std::size_t> nearest;
  double least = reach_mm * reach_mm;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const double squared = nearest_on_polyline(coarse_line(*strokes[i]), p).distance_squared;
    if (squared > least) continue;
    least = squared;
    nearest = i;
  }
  return nearest;
}

}  // namespace

Result<Correspondence> match_strokes(std::span<const StrokePtr> from, std::span<const StrokePtr> to,
                                     std::span<const GivenPair> given) {
  if (std::max(from.size(), to.size()) > kMaxMatchedStrokes) {
    return fail(ErrorCode::kLimitExceeded,
                "has more than " + std::to_string(kMaxMatchedStrokes) + " strokes");
  }
  if (auto ok = check_given(given, from.size(), to.size()); !ok) return tl::unexpected(ok.error());
  return StrokeMatcher(from, to, given).match();
}

std::optional<GivenPair> pair_by_line(std::span<const StrokePtr> from,
                                      std::span<const StrokePtr> to, Point start, Point end,
                                      double reach_mm) {
  const auto first = nearest_stroke(from, start, reach_mm),
             second = nearest_stroke(to, end, reach_mm);
  if (!first || !second) return std::nullopt;
  return GivenPair{first, second};
}

}  // namespace felt
