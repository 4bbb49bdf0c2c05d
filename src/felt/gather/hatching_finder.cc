#include "felt/gather/hatching_finder.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

/// Largest distance of a line of a hatching from its chord, as a share of the chord. Bent lines
/// beside each other are not told from the strips of a broad brush.
constexpr double kMaxBend = 0.05;
/// Smallest share of the shorter line along which both are the nearest to each other.
constexpr double kMinBeside = 0.5;
/// Largest standard deviation of the gap along two lines, as a share of the gap.
constexpr double kMaxGapDeviation = 0.3;
/// Largest ratio of two gaps of a hatching.
constexpr double kMaxGapRatio = 1.8;

bool is_straight(std::span<const Point> points) {
  if (points.size() < 2) return false;
  const Vec chord = points.back() - points.front();
  const double allowed = kMaxBend * dot(chord, chord);
  return std::all_of(points.begin(), points.end(), [&](Point p) {
    return std::fabs(cross(chord, p - points.front())) <= allowed;
  });
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
  double deviation_mm = 0.0;
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
      usual = {first->line, count / sections, mean};
      deviation_mm = std::sqrt(std::max(0.0, squares / count - mean * mean));
    }
    first = last;
  }
  return deviation_mm <= kMaxGapDeviation * usual.gap_mm ? usual : Neighbour{};
}

void HatchingFinder::end_line(std::uint32_t line, std::span<const Point> points) {
  if (is_straight(points)) {
    const auto sections = static_cast<double>(points.size() - 1);
    const auto crosses = [&](const Neighbour& n, Side other_side) {
      const std::vector<Nearest>& hits = hits_[other_side];
      return std::any_of(hits.begin(), hits.end(),
                         [&](const Nearest& hit) { return hit.line == n.line; });
    };
    const Neighbour below = usual_neighbour(hits_[kBelow], sections);
    const Neighbour above = usual_neighbour(hits_[kAbove], sections);
    if (!crosses(below, kAbove)) neighbours_[line][kBelow] = below;
    if (!crosses(above, kBelow)) neighbours_[line][kAbove] = above;
  }
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

double HatchingFinder::gap_mm(std::uint32_t a, std::uint32_t b) const {
  const auto& sides = neighbours_[a];
  return sides[kBelow].line == b ? sides[kBelow].gap_mm : sides[kAbove].gap_mm;
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

/// Numbers the parts of a row in which the gaps are alike.
void HatchingFinder::number_runs(const std::vector<std::uint32_t>& row, std::uint32_t& last,
                                 std::vector<Numbers>& numbers) const {
  for (std::size_t first = 0; first + 1 < row.size();) {
    double smallest = gap_mm(row[first], row[first + 1]), largest = smallest;
    std::size_t end = first + 2;
    for (; end < row.size(); ++end) {
      const double gap = gap_mm(row[end - 1], row[end]);
      if (std::max(largest, gap) > kMaxGapRatio * std::min(smallest, gap)) break;
      smallest = std::min(smallest, gap);
      largest = std::max(largest, gap);
    }
    if (end - first >= kMinLines) {
      ++last;
      for (std::size_t i = first; i < end; ++i)
        numbers[row[i]][numbers[row[i]][0] == 0 ? 0 : 1] = last;
    }
    first = end - 1;
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
