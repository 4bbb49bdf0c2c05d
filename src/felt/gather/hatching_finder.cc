#include "felt/gather/hatching_finder.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

/// Smallest share of the shorter line along which both are the nearest to each other.
constexpr double kMinBeside = 0.5;
/// Largest standard deviation of the gap along two lines, as a share of the gap.
constexpr double kMaxGapDeviation = 0.3;
/// Largest ratio of two gaps of a hatching.
constexpr double kMaxGapRatio = 1.8;

/// A kind of hatching: the more lines, the less regular they may be.
struct HatchingKind {
  std::size_t lines;  ///< at least
  double bend;        ///< largest distance of a line from its chord, as a share of the chord
  double deviation;   ///< largest standard deviation of a gap, as a share of the gap
  double beside;      ///< smallest share of the shorter line of two that lies beside the other
  double gap_inks;    ///< smallest gap, in widths of the ink
  double gap_share;   ///< the same, as a share of the shorter line
};
/// The values leave the groups of the labelled drawings of StrokeStrip as they are
/// (docs/design/gather.md).
constexpr HatchingKind kKinds[] = {{2, 0.02, 0.15, 0.8, 1.5, 0.015},  // parallels
                                   {2, 0.6, 0.05, 0.8, 1.5, 0.015},   // bent parallels
                                   {4, 0.05, 0.3, 0.5, 0.0, 0.0},     // straight lines
                                   {5, 0.5, 0.2, 0.5, 0.0, 0.0}};     // bent lines

/// Returns the largest distance of a point from the chord of a line, as a share of the chord; for a
/// line that nearly returns to its start, that of a half circle.
double bend_of(std::span<const Point> points, double length_mm) {
  constexpr double kRing = 0.5, kRingChord = 0.1;
  const Vec chord = points.back() - points.front();
  if (norm(chord) <= kRingChord * length_mm) return kRing;
  double largest = 0.0;
  for (const Point p : points) {
    largest = std::max(largest, std::fabs(cross(chord, p - points.front())));
  }
  return largest / dot(chord, chord);
}

}  // namespace

void HatchingFinder::add(const LineSection& section) {
  const auto add_nearest = [&](std::span<const SectionHit> side, Side to) {
    if (side.empty()) return;
    hits_[to].push_back({side.front().line, std::fabs(side.front().offset_mm)});
  };
  add_nearest(section.below, kBelow);
  add_nearest(section.above, kAbove);
}

/// Returns the line with the most hits, or none if its gap is irregular.
HatchingFinder::Neighbour HatchingFinder::usual_neighbour(std::vector<Nearest>& hits,
                                                          double sections) {
  std::stable_sort(hits.begin(), hits.end(),
                   [](const Nearest& a, const Nearest& b) { return a.line < b.line; });
  Neighbour usual;
  for (auto first = hits.begin(); first != hits.end();) {
    double sum = 0.0, squares = 0.0;
    auto last = first;
    for (; last != hits.end() && last->line == first->line; ++last) {
      sum += last->gap_mm;
      squares += last->gap_mm * last->gap_mm;
    }
    const auto count = static_cast<double>(last - first);
    if (count / sections > usual.share) {
      const double mean = sum / count;
      usual = {first->line, count / sections, mean,
               std::sqrt(std::max(0.0, squares / count - mean * mean))};
    }
    first = last;
  }
  return usual.deviation_mm <= kMaxGapDeviation * usual.gap_mm ? usual : Neighbour{};
}

void HatchingFinder::end_line(std::uint32_t line, std::span<const Point> points) {
  double length_mm = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length_mm += distance(points[i - 1], points[i]);
  if (length_mm > 0.0) shapes_[line] = {bend_of(points, length_mm), length_mm};
  const double sections = std::max(1.0, static_cast<double>(points.size()) - 1.0);
  const auto crosses = [&](const Neighbour& n, Side other_side) {
    const std::vector<Nearest>& hits = hits_[other_side];
    return std::any_of(hits.begin(), hits.end(),
                       [&](const Nearest& hit) { return hit.line == n.line; });
  };
  const Neighbour below = usual_neighbour(hits_[kBelow], sections);
  const Neighbour above = usual_neighbour(hits_[kAbove], sections);
  if (!crosses(below, kAbove)) neighbours_[line][kBelow] = below;
  if (!crosses(above, kBelow)) neighbours_[line][kAbove] = above;
  for (std::vector<Nearest>& hits : hits_) hits.clear();
}

/// Returns the neighbour of a line on one side if the line is also a neighbour of it.
const HatchingFinder::Neighbour* HatchingFinder::next(std::uint32_t line, Side side) const {
  const Neighbour& there = neighbours_[line][side];
  if (there.line == kNoLine) return nullptr;
  for (const Neighbour& back : neighbours_[there.line]) {
    if (back.line == line && std::max(there.share, back.share) >= kMinBeside) return &there;
  }
  return nullptr;
}

HatchingFinder::Couple HatchingFinder::couple(std::uint32_t a, std::uint32_t b) const {
  Couple couple{.bend = std::max(shapes_[a].bend, shapes_[b].bend),
                .length_mm = std::min(shapes_[a].length_mm, shapes_[b].length_mm)};
  for (const auto& [line, other] : {std::pair(b, a), std::pair(a, b)}) {
    for (const Neighbour& n : neighbours_[line]) {
      if (n.line != other) continue;
      couple.gap_mm = n.gap_mm;
      couple.deviation = std::max(couple.deviation, n.deviation_mm / n.gap_mm);
      couple.beside = std::max(couple.beside, n.share);
    }
  }
  return couple;
}

/// Returns the lines beside each other, beginning with a line that has at most one neighbour.
std::vector<std::uint32_t> HatchingFinder::row_from(std::uint32_t line,
                                                    std::vector<bool>& visited) const {
  std::vector<std::uint32_t> row{line};
  visited[line] = true;
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const Side side : {kBelow, kAbove}) {
      const Neighbour* n = next(row.back(), side);
      if (!n || visited[n->line]) continue;
      visited[n->line] = true;
      row.push_back(n->line);
      goes_on = true;
      break;
    }
  }
  return row;
}

/// Returns the number of couples from `first` on that `fits` and whose gaps are alike.
std::size_t HatchingFinder::run_length(std::span<const Couple> couples, std::size_t first,
                                       const std::function<bool(std::size_t)>& fits) {
  double smallest = couples[first].gap_mm, largest = smallest;
  std::size_t end = first;
  for (; end < couples.size() && fits(end); ++end) {
    smallest = std::min(smallest, couples[end].gap_mm);
    largest = std::max(largest, couples[end].gap_mm);
    if (largest > kMaxGapRatio * smallest) break;
  }
  return end - first;
}

/// Numbers the parts of a row that are hatchings.
void HatchingFinder::number_runs(const std::vector<std::uint32_t>& row, std::uint32_t& last,
                                 std::vector<Numbers>& numbers) const {
  std::vector<Couple> couples;
  for (std::size_t i = 0; i + 1 < row.size(); ++i) couples.push_back(couple(row[i], row[i + 1]));
  std::vector<bool> is_held(couples.size(), false);
  for (const HatchingKind& kind : kKinds) {
    const auto fits = [&](std::size_t i) {
      return couples[i].bend <= kind.bend && couples[i].deviation <= kind.deviation &&
             couples[i].beside >= kind.beside && couples[i].gap_mm >= kind.gap_inks * ink_mm_ &&
             couples[i].gap_mm >= kind.gap_share * couples[i].length_mm;
    };
    for (std::size_t first = 0, length; first < couples.size();
         first += std::max<std::size_t>(length, 1)) {
      length = run_length(couples, first, fits);
      for (std::size_t i = first; length + 1 >= kind.lines && i < first + length; ++i)
        is_held[i] = true;
    }
  }
  for (std::size_t first = 0, length; first < couples.size();
       first += std::max<std::size_t>(length, 1)) {
    length = run_length(couples, first, [&](std::size_t i) { return is_held[i]; });
    if (length == 0) continue;
    ++last;
    for (std::size_t i = first; i <= first + length; ++i)
      numbers[row[i]][numbers[row[i]][0] == 0 ? 0 : 1] = last;
  }
}

std::vector<HatchingFinder::Numbers> HatchingFinder::hatchings() const {
  std::vector<Numbers> numbers(neighbours_.size(), Numbers{});
  std::vector<bool> visited(neighbours_.size(), false);
  std::uint32_t last = 0;
  for (std::uint32_t i = 0; i < neighbours_.size(); ++i) {
    const bool is_end = (next(i, kBelow) != nullptr) != (next(i, kAbove) != nullptr);
    if (is_end && !visited[i]) number_runs(row_from(i, visited), last, numbers);
  }
  return numbers;
}

bool share_hatching(const HatchingFinder::Numbers& a, const HatchingFinder::Numbers& b) noexcept {
  return std::any_of(a.begin(), a.end(), [&](std::uint32_t n) {
    return n != 0 && std::find(b.begin(), b.end(), n) != b.end();
  });
}

}  // namespace felt
