#include "felt/gather/line_affinity.h"

#include <algorithm>
#include <cmath>

#include "felt/gather/hatching_finder.h"
#include "felt/gather/odds_weights.h"
#include "felt/gather/percentile.h"

namespace felt {
namespace {

constexpr double kStepShare = 0.0075;                    // of the scale
constexpr double kReachShare = 0.06;                     // of the scale
constexpr double kHatchingReach = 1.5;                   // of the reach of pairs
constexpr std::uint64_t kMaxSectionTests = 400'000'000;  // some seconds
constexpr double kSmallest = 0.0005;  // of the scale: smaller gaps are those of copies

/// What the sections of one line say about another line.
struct OneSided {
  std::uint32_t other = 0;
  double gap = 0.0, wide_gap = 0.0;  // median and 90th percentile, mm
  double angle_sum = 0.0;
  std::uint32_t hits = 0;
};

struct GapHit {
  std::uint32_t other;
  double gap_mm, angle;
};

// Appends the widest gap up to the nearest crossing of each line on one side.
void add_side(std::span<const SectionHit> side, double reach_mm, std::vector<GapHit>& hits,
              std::size_t first) {
  double previous = 0.0, widest = 0.0;
  for (const SectionHit& hit : side) {
    const double offset = std::fabs(hit.offset_mm);
    if (offset > reach_mm) break;
    widest = std::max(widest, offset - previous);
    previous = offset;
    const auto same = [&](const GapHit& h) { return h.other == hit.line; };
    if (std::any_of(hits.begin() + static_cast<std::ptrdiff_t>(first), hits.end(), same)) continue;
    hits.push_back({hit.line, widest, std::acos(std::min(1.0, std::fabs(hit.cosine)))});
  }
}

/// Measures all lines, one after the other.
class PairMeter {
 public:
  PairMeter(std::span<const RoughLine> lines, double scale_mm, double ink_mm)
      : scale_mm_(scale_mm),
        grid_(lines, pair_sections(scale_mm)),
        sides_(lines.size()),
        hatchings_(lines.size(), ink_mm) {}

  /// Fails if the lines are too dense.
  [[nodiscard]] Result<std::vector<LinePair>> run() {
    const LineGrid::Crowd crowd = grid_.crowd();
    if (crowd.tests > kMaxSectionTests) {
      return fail(ErrorCode::kUnsupported,
                  "too many lines lie on each other near " +
                      std::to_string(std::lround(crowd.densest.x)) + "," +
                      std::to_string(std::lround(crowd.densest.y)) + " mm: comparing them takes " +
                      std::to_string(crowd.tests) + " tests, but at most 400000000 are allowed");
    }
    for (std::uint32_t i = 0; i < sides_.size(); ++i) measure(i);
    usual_gap_mm_ = percentile(nearest_mm_, 0.5);
    hatchings_of_ = hatchings_.hatchings();
    return pairs();
  }

 private:
  [[nodiscard]] std::vector<LinePair> pairs() const;
  void measure(std::uint32_t line);
  [[nodiscard]] const OneSided* find(std::uint32_t line, std::uint32_t other) const;
  [[nodiscard]] LinePair pair(std::uint32_t a, std::uint32_t b, const OneSided& ab,
                              const OneSided& ba) const;
  [[nodiscard]] double share(std::uint32_t line, const OneSided& side) const {
    return side.hits / static_cast<double>(grid_.points(line).size() - 1);
  }

  double scale_mm_;
  LineGrid grid_;
  std::vector<std::vector<OneSided>> sides_;  // of each line, sorted by `other`
  std::vector<double> nearest_mm_;            // from each section to the nearest other line
  double usual_gap_mm_ = 0.0;
  HatchingFinder hatchings_;
  std::vector<HatchingFinder::Numbers> hatchings_of_;  // of each line
};

void PairMeter::measure(std::uint32_t line) {
  std::vector<GapHit> hits;
  const double reach_mm = kReachShare * scale_mm_;
  grid_.sections(line, [&](const LineSection& section) {
    // A line that crosses on both sides counts on the nearer one.
    hatchings_.add(section);
    const std::size_t first = hits.size();
    const bool above_first = section.below.empty() ||
                             (!section.above.empty() &&
                              section.above.front().offset_mm < -section.below.front().offset_mm);
    add_side(above_first ? section.above : section.below, reach_mm, hits, first);
    if (hits.size() > first) nearest_mm_.push_back(hits[first].gap_mm);
    add_side(above_first ? section.below : section.above, reach_mm, hits, first);
  });
  hatchings_.end_line(line, grid_.points(line));
  std::stable_sort(hits.begin(), hits.end(),
                   [](const GapHit& a, const GapHit& b) { return a.other < b.other; });
  std::vector<double> gaps;
  for (std::size_t i = 0; i < hits.size();) {
    OneSided side{.other = hits[i].other};
    gaps.clear();
    for (; i < hits.size() && hits[i].other == side.other; ++i) {
      gaps.push_back(hits[i].gap_mm);
      side.angle_sum += hits[i].angle;
    }
    side.hits = static_cast<std::uint32_t>(gaps.size());
    side.gap = percentile(gaps, 0.5);
    side.wide_gap = percentile(gaps, 0.9);
    sides_[line].push_back(side);
  }
}

const OneSided* PairMeter::find(std::uint32_t line, std::uint32_t other) const {
  const std::vector<OneSided>& sides = sides_[line];
  const auto at = std::lower_bound(sides.begin(), sides.end(), other,
                                   [](const OneSided& s, std::uint32_t o) { return s.other < o; });
  return at != sides.end() && at->other == other ? &*at : nullptr;
}

LinePair PairMeter::pair(std::uint32_t a, std::uint32_t b, const OneSided& ab,
                         const OneSided& ba) const {
  const double hits = ab.hits + ba.hits;
  const auto mean = [&](double x, double y) { return (ab.hits * x + ba.hits * y) / hits; };
  const auto relative = [&](double mm) { return mm / scale_mm_ + kSmallest; };
  const double gap = relative(mean(ab.gap, ba.gap));
  const double share_a = share(a, ab), share_b = share(b, ba);
  LinePair pair{.a = a, .b = b};
  pair.in_hatching = share_hatching(hatchings_of_[a], hatchings_of_[b]);
  pair.overlap = std::max(share_a * grid_.length_mm(a), share_b * grid_.length_mm(b)) / scale_mm_;
  pair.features = {std::log(gap),
                   std::log(relative(mean(ab.wide_gap, ba.wide_gap))),
                   std::log(gap / relative(usual_gap_mm_)),
                   (ab.angle_sum + ba.angle_sum) / hits,
                   std::min(share_a, share_b),
                   std::log(std::max(pair.overlap, 1e-6) / gap)};
  return pair;
}

std::vector<LinePair> PairMeter::pairs() const {
  std::vector<LinePair> result;
  constexpr OneSided kNothing;
  for (std::uint32_t i = 0; i < sides_.size(); ++i) {
    for (const OneSided& side : sides_[i]) {
      const OneSided* back = find(side.other, i);
      if (i < side.other) {
        result.push_back(pair(i, side.other, side, back ? *back : kNothing));
      } else if (!back) {
        result.push_back(pair(side.other, i, kNothing, side));
      }
    }
  }
  std::sort(result.begin(), result.end(), [](const LinePair& x, const LinePair& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  });
  return result;
}

}  // namespace

SectionOptions pair_sections(double scale_mm) {
  return {.step_mm = kStepShare * scale_mm, .reach_mm = kHatchingReach * kReachShare * scale_mm};
}

Result<std::vector<LinePair>> line_pairs(std::span<const RoughLine> lines, double scale_mm,
                                         double ink_mm) {
  return PairMeter(lines, scale_mm, ink_mm).run();
}

std::array<double, kOddsTerms> odds_terms(
    const std::array<double, LinePair::kFeatures>& features,
    const std::array<double, LinePair::kFeatures>& mean,
    const std::array<double, LinePair::kFeatures>& spread) noexcept {
  std::array<double, LinePair::kFeatures + 1> z{1.0};
  for (std::size_t i = 0; i < LinePair::kFeatures; ++i) {
    z[i + 1] = std::clamp((features[i] - mean[i]) / spread[i], -3.0, 3.0);
  }
  std::array<double, kOddsTerms> terms{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    for (std::size_t k = i; k < z.size(); ++k) terms[n++] = z[i] * z[k];
  }
  return terms;
}

double log_odds(const LinePair& pair) noexcept {
  const std::array<double, kOddsTerms> terms = odds_terms(pair.features, kOddsMean, kOddsSpread);
  double odds = 0.0;
  for (std::size_t i = 0; i < terms.size(); ++i) odds += kOddsWeights[i] * terms[i];
  return odds;
}

}  // namespace felt
