#include "felt/tactile/line_gaps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace felt {
namespace {

/// Junctions of the same two lines that are nearer than this along both lines count as one.
constexpr double kSameJunctionMm = 1.0;

/// Points of one fault are at most this far apart along their line.
constexpr double kBreakMm = 1.5;

/// Gaps that differ by less count as equally narrow, so that the position of a fault between
/// parallel lines is in the middle.
constexpr double kSameGapMm = 0.05;

/// Where two lines touch: the arc lengths on the first and on the second.
struct Junction {
  double a_mm, b_mm;
};

using LinePair = std::pair<std::uint32_t, std::uint32_t>;
using Junctions = std::map<LinePair, std::vector<Junction>>;

double widest_half(const TouchLines& lines) noexcept {
  double widest = 0.0;
  for (const TouchPoint& p : lines.points) widest = std::max(widest, p.half_mm);
  return widest;
}

double ink_gap(const TouchPoint& a, const TouchPoint& b) noexcept {
  return distance(a.at, b.at) - a.half_mm - b.half_mm;
}

/// Returns true if b counts as another part of the ink than a, and comes after it.
bool is_later(const TouchPoint& a, const TouchPoint& b) noexcept {
  return a.line != b.line ? a.line < b.line : a.along_mm < b.along_mm;
}

class GapSearch {
 public:
  GapSearch(const TouchLines& lines, double gap_mm)
      : lines_(lines), gap_mm_(gap_mm), grid_(lines.points, gap_mm + 2.0 * widest_half(lines)) {}

  std::vector<TactileFault> run() {
    find_junctions();
    std::vector<TactileFault> faults;
    for (const TouchLine& line : lines_.lines) add_faults(line, faults);
    return faults;
  }

  void find_junctions() {
    for (const TouchPoint& a : lines_.points) {
      grid_.visit_near(a.at, [&](std::uint32_t i) {
        const TouchPoint& b = lines_.points[i];
        if (!is_later(a, b) || ink_gap(a, b) > 0.0) return;
        if (a.line == b.line && is_joined_along(a, b)) return;
        add_junction(junctions_[{a.line, b.line}], {a.along_mm, b.along_mm});
      });
    }
  }

  [[nodiscard]] const Junctions& junctions() const noexcept { return junctions_; }

 private:
  struct Nearest {
    double gap_mm;
    std::uint32_t point;
  };
  /// A point of a line that is too near another line.
  struct NearPoint {
    double along_mm, gap_mm;
    Point middle;  ///< of the gap
  };
  using Series = std::vector<NearPoint>;

  static void add_junction(std::vector<Junction>& all, const Junction& made) {
    const bool is_known = std::any_of(all.rbegin(), all.rend(), [&](const Junction& j) {
      return std::abs(j.a_mm - made.a_mm) < kSameJunctionMm &&
             std::abs(j.b_mm - made.b_mm) < kSameJunctionMm;
    });
    if (!is_known) all.push_back(made);
  }

  [[nodiscard]] bool is_joined_along(const TouchPoint& a, const TouchPoint& b) const noexcept {
    const TouchLine& line = lines_.lines[a.line];
    return line.path_mm(a.along_mm, b.along_mm) <= kJoinedGaps * gap_mm_;
  }

  [[nodiscard]] bool is_joined(const TouchPoint& a, const TouchPoint& b) const {
    if (a.line == b.line && is_joined_along(a, b)) return true;
    const auto found = junctions_.find({a.line, b.line});
    if (found == junctions_.end()) return false;
    const TouchLine &first = lines_.lines[a.line], &second = lines_.lines[b.line];
    return std::any_of(found->second.begin(), found->second.end(), [&](const Junction& j) {
      return first.path_mm(a.along_mm, j.a_mm) + second.path_mm(b.along_mm, j.b_mm) <=
             kJoinedGaps * gap_mm_;
    });
  }

  /// Returns the nearest point of each line that is too near a point and not joined to it.
  [[nodiscard]] std::map<std::uint32_t, Nearest> too_near(const TouchPoint& a) const {
    std::map<std::uint32_t, Nearest> nearest;
    grid_.visit_near(a.at, [&](std::uint32_t i) {
      const TouchPoint& b = lines_.points[i];
      if (!is_later(a, b)) return;
      const double gap = ink_gap(a, b);
      if (gap <= 0.0 || gap >= gap_mm_) return;
      const auto best = nearest.find(b.line);
      if (best != nearest.end() && best->second.gap_mm <= gap) return;
      if (!is_joined(a, b)) nearest[b.line] = {gap, i};
    });
    return nearest;
  }

  [[nodiscard]] TactileFault fault_of(const TouchLine& line, std::uint32_t other,
                                      const Series& series) const {
    double narrowest = gap_mm_;
    for (const NearPoint& p : series) narrowest = std::min(narrowest, p.gap_mm);
    std::vector<Point> narrow;
    for (const NearPoint& p : series) {
      if (p.gap_mm < narrowest + kSameGapMm) narrow.push_back(p.middle);
    }
    return {TactileRule::kGap,
            narrow[narrow.size() / 2],
            narrowest,
            gap_mm_,
            series.back().along_mm - series.front().along_mm,
            line.stroke,
            lines_.lines[other].stroke};
  }

  void add_faults(const TouchLine& line, std::vector<TactileFault>& faults) const {
    std::map<std::uint32_t, Series> open;
    for (const TouchPoint& a : lines_.points_of(line)) {
      for (const auto& [other, near] : too_near(a)) {
        Series& series = open[other];
        if (!series.empty() && a.along_mm - series.back().along_mm > kBreakMm) {
          faults.push_back(fault_of(line, other, series));
          series.clear();
        }
        series.push_back({a.along_mm, near.gap_mm, lerp(a.at, lines_.points[near.point].at, 0.5)});
      }
    }
    for (const auto& [other, series] : open) faults.push_back(fault_of(line, other, series));
  }

  const TouchLines& lines_;
  double gap_mm_;
  TouchGrid grid_;
  Junctions junctions_;
};

}  // namespace

std::vector<TactileFault> find_line_gaps(const TouchLines& lines, double gap_mm) {
  return GapSearch(lines, gap_mm).run();
}

std::vector<std::vector<std::uint32_t>> shapes_of(const TouchLines& lines) {
  GapSearch search(lines, TouchLine::kStepMm);
  search.find_junctions();
  std::vector<std::uint32_t> root(lines.lines.size());
  std::iota(root.begin(), root.end(), 0U);
  const auto find = [&root](std::uint32_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  for (const auto& [pair, where] : search.junctions()) {
    const std::uint32_t a = find(pair.first), b = find(pair.second);
    root[std::max(a, b)] = std::min(a, b);
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> shapes;
  for (std::uint32_t i = 0; i < root.size(); ++i) shapes[find(i)].push_back(i);
  std::vector<std::vector<std::uint32_t>> all;
  for (auto& [first, members] : shapes) all.push_back(std::move(members));
  return all;
}

}  // namespace felt
