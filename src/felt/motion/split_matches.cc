#include "felt/motion/split_matches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "felt/geometry/polyline.h"

namespace felt {
namespace {

/// A split must be better by this than the matches that it replaces.
constexpr double kSplitGain = 0.08;
/// The ends of the halves may be this share of the length of the whole stroke apart, ...
constexpr double kMaxGapShare = 0.35;
/// ... and each half must be at least this share of it.
constexpr double kMinHalfShare = 0.08;
/// A split costs at most this share of the limit.
constexpr double kMaxSplitShare = 0.5;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// One stroke, and the two of the other drawing that it is or was.
struct SplitPair {
  std::size_t whole = 0, first = 0, second = 0;
  /// Whether the halves run in the opposite direction of the whole stroke.
  bool first_reversed = false, second_reversed = false;
  double cost = 0.0;
  double gain = 0.0;
};

/// Finds the strokes of `one` that are two strokes of `two`.
class SplitFinder {
 public:
  SplitFinder(const SplitSide& one, const SplitSide& two, const MatchScale& scale, double limit)
      : one_(one), two_(two), scale_(scale), limit_(limit) {}

  /// `partner` and `cost` are those of each stroke of `one`; `back` and `taken` are the partner of
  /// each stroke of `two`, and whether it must stay as it is.
  void set_matches(std::vector<std::size_t> partner, std::vector<double> cost,
                   std::vector<std::size_t> back, std::vector<bool> taken) {
    partner_ = std::move(partner);
    cost_ = std::move(cost);
    back_ = std::move(back);
    taken_ = std::move(taken);
  }

  [[nodiscard]] std::optional<SplitPair> best_for(std::size_t whole) const {
    std::optional<SplitPair> best;
    const std::vector<std::size_t> near = candidates(whole);
    for (std::size_t i = 0; i < near.size(); ++i) {
      for (std::size_t k = i + 1; k < near.size(); ++k) {
        const auto pair = halves(whole, near[i], near[k]);
        if (pair && pair->gain > (best ? best->gain : kSplitGain)) best = pair;
      }
    }
    return best;
  }

 private:
  /// Returns the strokes that may be a half: shorter ones nearby.
  [[nodiscard]] std::vector<std::size_t> candidates(std::size_t whole) const {
    constexpr std::size_t kMaxCandidates = 12;
    const StrokeShape& shape = one_.shapes[whole];
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < two_.shapes.size(); ++i) {
      const StrokeShape& half = two_.shapes[i];
      if (taken_[i] || half.closed || half.length_mm > 1.1 * shape.length_mm ||
          half.length_mm < kMinHalfShare * shape.length_mm) {
        continue;
      }
      const double apart = distance(half.centre, shape.centre);
      if (apart < 0.5 * shape.length_mm + scale_.reach_mm) near.emplace_back(apart, i);
    }
    std::sort(near.begin(), near.end());
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < std::min(near.size(), kMaxCandidates); ++i) {
      result.push_back(near[i].second);
    }
    // The partner is one of the halves more often than any other stroke.
    const std::size_t partner = partner_[whole];
    if (partner != kNone && std::find(result.begin(), result.end(), partner) == result.end()) {
      result.push_back(partner);
    }
    return result;
  }

  /// Returns the cost of the matches that a split would replace.
  [[nodiscard]] double present_cost(std::size_t whole, std::size_t first,
                                    std::size_t second) const {
    double sum = partner_[whole] == kNone ? 0.5 * limit_ : cost_[whole];
    for (const std::size_t half : {first, second}) {
      const std::size_t other = back_[half];
      if (other == kNone) sum += 0.5 * limit_;
      if (other != kNone && other != whole) sum += cost_[other];
    }
    return sum;
  }

  /// Returns the cost of the strokes that a split would leave without partner.
  [[nodiscard]] double cost_of_left(std::size_t whole, std::size_t first,
                                    std::size_t second) const {
    double sum = 0.0;
    for (const std::size_t half : {first, second}) {
      if (back_[half] != kNone && back_[half] != whole) sum += 0.5 * limit_;
    }
    const std::size_t partner = partner_[whole];
    if (partner != kNone && partner != first && partner != second) sum += 0.5 * limit_;
    return sum;
  }

  [[nodiscard]] std::optional<SplitPair> halves(std::size_t whole, std::size_t a,
                                                std::size_t b) const {
    const double present = present_cost(whole, a, b), left = cost_of_left(whole, a, b);
    std::optional<SplitPair> best;
    for (int way = 0; way < 4; ++way) {
      const bool turn_a = way % 2 == 1, turn_b = way / 2 == 1;
      std::vector<Point> line = two_.lines[a], rest = two_.lines[b];
      if (turn_a) std::reverse(line.begin(), line.end());
      if (turn_b) std::reverse(rest.begin(), rest.end());
      const double gap = distance(line.back(), rest.front());
      if (gap > kMaxGapShare * one_.shapes[whole].length_mm) continue;
      line.insert(line.end(), rest.begin(), rest.end());
      const MatchCost cost = match_cost(one_.shapes[whole], shape_of(line), scale_, 0.0, limit_);
      const double gain = present - left - cost.cost;
      if (cost.cost > kMaxSplitShare * limit_ || (best && gain <= best->gain)) continue;
      // If the whole stroke runs the other way, so do the halves, and the second one comes first.
      if (cost.pairing.reversed) {
        best = SplitPair{whole, b, a, !turn_b, !turn_a, cost.cost, gain};
      } else {
        best = SplitPair{whole, a, b, turn_a, turn_b, cost.cost, gain};
      }
    }
    return best;
  }

  const SplitSide& one_;
  const SplitSide& two_;
  MatchScale scale_;
  double limit_;
  std::vector<std::size_t> partner_, back_;
  std::vector<double> cost_;
  std::vector<bool> taken_;
};

/// Replaces matches by splits. If `turned`, the whole strokes are those of the second drawing.
class SplitPass {
 public:
  SplitPass(const SplitSide& one, const SplitSide& two, const MatchScale& scale, double limit,
            bool turned, std::vector<StrokeMatch>& matches)
      : one_(one), two_(two), finder_(one, two, scale, limit), turned_(turned), matches_(matches) {}

  void run() {
    read_matches();
    std::vector<SplitPair> found;
    for (std::size_t i = 0; i < one_.shapes.size(); ++i) {
      if (whole_taken_[i] || one_.shapes[i].closed) continue;
      if (const auto pair = finder_.best_for(i)) found.push_back(*pair);
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const SplitPair& a, const SplitPair& b) { return a.gain > b.gain; });
    for (const SplitPair& pair : found) apply(pair);
  }

 private:
  using Index = std::optional<std::size_t> StrokeMatch::*;
  [[nodiscard]] Index whole_side() const { return turned_ ? &StrokeMatch::to : &StrokeMatch::from; }
  [[nodiscard]] Index half_side() const { return turned_ ? &StrokeMatch::from : &StrokeMatch::to; }

  void read_matches() {
    std::vector<std::size_t> partner(one_.shapes.size(), kNone), back(two_.shapes.size(), kNone);
    std::vector<double> cost(one_.shapes.size(), 0.0);
    std::vector<bool> taken(two_.shapes.size(), false);
    whole_taken_.assign(one_.shapes.size(), false);
    for (const StrokeMatch& match : matches_) {
      const auto whole = match.*whole_side(), half = match.*half_side();
      const bool is_part =
          match.from_end - match.from_start < 1.0 || match.to_end - match.to_start < 1.0;
      if (whole && (match.is_given || is_part)) whole_taken_[*whole] = true;
      if (half && (match.is_given || is_part)) taken[*half] = true;
      if (!whole || !half) continue;
      partner[*whole] = *half;
      back[*half] = *whole;
      cost[*whole] = match.cost;
    }
    half_taken_ = taken;
    finder_.set_matches(std::move(partner), std::move(cost), std::move(back), std::move(taken));
  }

  /// Makes the matches of a split, and leaves the former partners without partner.
  void apply(const SplitPair& pair) {
    if (whole_taken_[pair.whole] || half_taken_[pair.first] || half_taken_[pair.second]) return;
    whole_taken_[pair.whole] = half_taken_[pair.first] = half_taken_[pair.second] = true;
    std::vector<StrokeMatch> kept;
    for (const StrokeMatch& match : matches_) {
      const auto whole = match.*whole_side(), half = match.*half_side();
      const bool has_whole = whole == pair.whole;
      const bool has_half = half == pair.first || half == pair.second;
      if (!has_whole && !has_half) kept.push_back(match);
      StrokeMatch alone;
      if (has_whole && half && !has_half) alone.*half_side() = half;
      if (has_half && whole && !has_whole) {
        alone.*whole_side() = whole;
        whole_taken_[*whole] = true;
      }
      if (alone.from || alone.to) kept.push_back(alone);
    }
    const double first_mm = two_.shapes[pair.first].length_mm;
    const double share = first_mm / (first_mm + two_.shapes[pair.second].length_mm);
    kept.push_back(part(pair.whole, pair.first, 0.0, share, pair.first_reversed, pair.cost));
    kept.push_back(part(pair.whole, pair.second, share, 1.0, pair.second_reversed, pair.cost));
    matches_ = std::move(kept);
  }

  [[nodiscard]] StrokeMatch part(std::size_t whole, std::size_t half, double start, double end,
                                 bool reversed, double cost) const {
    StrokeMatch match;
    match.*whole_side() = whole;
    match.*half_side() = half;
    match.cost = cost;
    match.reversed = reversed;
    // If the whole stroke is the second one, the half keeps its direction, and the
    // part of the whole stroke runs the other way.
    (turned_ ? match.to_start : match.from_start) = start;
    (turned_ ? match.to_end : match.from_end) = end;
    return match;
  }

  const SplitSide& one_;
  const SplitSide& two_;
  SplitFinder finder_;
  bool turned_;
  std::vector<StrokeMatch>& matches_;
  std::vector<bool> whole_taken_, half_taken_;
};

}  // namespace

void match_split_strokes(const SplitSide& from, const SplitSide& to, const MatchScale& scale,
                         double limit, std::vector<StrokeMatch>& matches) {
  SplitPass(from, to, scale, limit, false, matches).run();
  SplitPass(to, from, scale, limit, true, matches).run();
}

}  // namespace felt
