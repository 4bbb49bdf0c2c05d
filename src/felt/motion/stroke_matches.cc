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
constexpr int kMatchRounds = 3;
/// The cost from which two strokes do not belong together: in the first round, and later this
/// multiple of the usual cost and more.
constexpr double kFirstLimit = 1.2, kUsualFactor = 5.0, kMinLimit = 0.45;
/// How far the neighbours tell where a stroke goes: the share of the distance that they explain.
constexpr double kNeighbourShare = 0.8;

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
    shifts_.assign(from_.size(), {});
    for (int round = 0; round < kMatchRounds; ++round) {
      move_shapes();
      assign();
      if (round + 1 == kMatchRounds) break;
      refine_motion();
      move_shapes();
      find_shifts();
      choose_limit();
    }
    return result();
  }

 private:
  void move_shapes() {
    there_.clear();
    for (std::size_t i = 0; i < from_.size(); ++i) {
      StrokeShape shape = moved(motion_, from_[i]);
      for (Point& p : shape.points) p += shifts_[i];
      shape.centre += shifts_[i];
      there_.push_back(shape);
    }
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

  void refine_motion() {
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      if (partner_[i] == kUnassigned) continue;
      const StrokeShape& to = to_[static_cast<std::size_t>(partner_[i])];
      for (std::size_t p = 1; p < kShapePoints; p += 7) {
        pairs.push_back({from_[i].points[p], paired_point(to, pairings_[i], p),
                         std::sqrt(from_[i].length_mm)});
      }
    }
    // Few strokes do not tell a motion of the whole from motions of their own.
    if (pairs.size() >= 8) motion_ = fit_robust_similarity(pairs, motion_);
  }

  /// Sets for each stroke how its neighbours moved in addition to the drawing.
  void find_shifts() {
    const double near = 0.25 * scale_.reach_mm;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      shifts_[i] = {};
      const Point at = moved(motion_, from_[i].centre);
      Vec sum{};
      double weights = 1e-3 / (near * near);
      for (std::size_t k = 0; k < from_.size(); ++k) {
        if (k == i || partner_[k] == kUnassigned) continue;
        const Point other = moved(motion_, from_[k].centre);
        const double weight = 1.0 / (distance_squared(at, other) + near * near);
        sum += weight * (to_[static_cast<std::size_t>(partner_[k])].centre - other);
        weights += weight;
      }
      shifts_[i] = (kNeighbourShare / weights) * sum;
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
      for (Point& p : from.lines.back()) p = moved(motion_, p) + shifts_[i];
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
  std::vector<Vec> shifts_;
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
    return fail(ErrorCode::kLimitExceeded, "has more than " + std::to_string(kMaxMatchedStrokes) +
                                               " strokes");
  }
  if (auto ok = check_given(given, from.size(), to.size()); !ok) return tl::unexpected(ok.error());
  return StrokeMatcher(from, to, given).match();
}

std::optional<GivenPair> pair_by_line(std::span<const StrokePtr> from,
                                      std::span<const StrokePtr> to, Point start, Point end,
                                      double reach_mm) {
  const auto first = nearest_stroke(from, start, reach_mm), second = nearest_stroke(to, end, reach_mm);
  if (!first || !second) return std::nullopt;
  return GivenPair{first, second};
}

}  // namespace felt
