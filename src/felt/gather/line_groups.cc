#include "felt/gather/line_groups.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <queue>
#include <string>

#include "felt/gather/copied_lines.h"
#include "felt/gather/line_affinity.h"
#include "felt/geometry/rect.h"

namespace felt {
namespace {

constexpr std::size_t kMaxRoughLines = 200'000;
constexpr double kCopyShare = 0.0005;  // of the scale: copies do not differ by more
constexpr double kMaxOdds = 8.0;       // one pair must not decide alone
constexpr double kAgainst = 3.0;       // weight of evidence against, because wrong groups are
                                       // worse than missing lines
constexpr double kBias = -0.15;
constexpr double kVeto = -1e9;  // evidence against a pair that nothing outweighs

/// The evidence between two groups.
struct Candidate {
  double evidence = 0.0;
  std::uint32_t a = 0, b = 0;

  friend bool operator<(const Candidate& x, const Candidate& y) {
    if (x.evidence != y.evidence) return x.evidence < y.evidence;
    return x.a != y.a ? x.a > y.a : x.b > y.b;
  }
};

/// Merges groups, the strongest evidence first.
class GroupMerger {
 public:
  GroupMerger(std::size_t lines, std::span<const LinePair> pairs, const GroupOptions& options)
      : links_(lines), parent_(lines) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (const LinePair& pair : pairs) {
      if (pair.in_hatching && options.keeps_hatchings) {
        link(pair.a, pair.b, kVeto);
        continue;
      }
      double odds = std::clamp(log_odds(pair) - kBias + options.leniency, -kMaxOdds, kMaxOdds);
      if (odds < 0.0) odds *= kAgainst;
      // Longer overlaps say more, but not in proportion: neighbouring sections are not independent.
      link(pair.a, pair.b, odds * std::sqrt(std::max(pair.overlap, 1e-4)));
    }
  }

  std::vector<std::uint32_t> run() {
    while (!queue_.empty()) {
      const Candidate best = queue_.top();
      queue_.pop();
      const auto at = links_[best.a].find(best.b);
      if (at == links_[best.a].end() || at->second != best.evidence) continue;  // outdated
      merge(best.a, best.b);
    }
    std::vector<std::uint32_t> groups(parent_.size());
    for (std::uint32_t i = 0; i < groups.size(); ++i) groups[i] = root(i);
    return groups;
  }

 private:
  void link(std::uint32_t a, std::uint32_t b, double evidence) {
    links_[a][b] = links_[b][a] = evidence;
    if (evidence > 0.0) queue_.push({evidence, std::min(a, b), std::max(a, b)});
  }

  // Moves the links of b to a.
  void merge(std::uint32_t a, std::uint32_t b) {
    if (links_[a].size() < links_[b].size()) std::swap(a, b);
    links_[a].erase(b);
    links_[b].erase(a);
    for (const auto& [other, evidence] : links_[b]) {
      links_[other].erase(b);
      const auto at = links_[a].find(other);
      link(a, other, evidence + (at == links_[a].end() ? 0.0 : at->second));
    }
    links_[b].clear();
    parent_[b] = a;
  }

  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  std::vector<std::map<std::uint32_t, double>> links_;
  std::vector<std::uint32_t> parent_;
  std::priority_queue<Candidate> queue_;
};

// Numbers the groups from 0 in the order of their first lines.
void renumber(std::vector<std::uint32_t>& groups) {
  constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<std::uint32_t> number(groups.size(), kNone);
  std::uint32_t next = 0;
  for (std::uint32_t& group : groups) {
    if (number[group] == kNone) number[group] = next++;
    group = number[group];
  }
}

Result<std::vector<std::uint32_t>> groups_at_scale(std::span<const RoughLine> lines,
                                                   const GroupOptions& options, double scale_mm) {
  const std::vector<std::uint32_t> copy_of = copied_lines(lines, kCopyShare * scale_mm);
  std::vector<std::uint32_t> index_of(lines.size(), 0);
  std::vector<RoughLine> unique;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (copy_of[i] != i) continue;
    index_of[i] = static_cast<std::uint32_t>(unique.size());
    unique.push_back(lines[i]);
  }
  const Result<std::vector<LinePair>> pairs = line_pairs(unique, scale_mm, options.ink_mm);
  if (!pairs) return tl::unexpected(pairs.error());
  std::vector<std::uint32_t> groups = GroupMerger(unique.size(), *pairs, options).run();
  std::vector<std::uint32_t> result(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) result[i] = groups[index_of[copy_of[i]]];
  renumber(result);
  return result;
}

}  // namespace

Result<std::vector<std::uint32_t>> line_groups(std::span<const RoughLine> lines,
                                               const GroupOptions& options) {
  if (lines.size() > kMaxRoughLines) {
    return fail(ErrorCode::kInvalidArgument,
                std::to_string(lines.size()) + " strokes, but at most 200000 can be gathered");
  }
  Rect box;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    for (const Point p : lines[i]) {
      if (!is_in_range(p)) {
        return fail(ErrorCode::kInvalidArgument,
                    "stroke " + std::to_string(i) + " has a coordinate beyond 1e9 mm");
      }
      box.extend(p);
    }
  }
  const double scale_mm =
      options.scale_mm > 0.0 ? options.scale_mm : std::hypot(box.width(), box.height());
  if (!(scale_mm > 0.0) || !std::isfinite(scale_mm)) {
    std::vector<std::uint32_t> alone(lines.size());
    std::iota(alone.begin(), alone.end(), 0U);
    return alone;
  }
  return groups_at_scale(lines, options, scale_mm);
}

}  // namespace felt
