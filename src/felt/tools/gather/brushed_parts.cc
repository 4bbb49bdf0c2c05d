#include "felt/tools/gather/brushed_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace felt {
namespace {

constexpr double kBrushedShare = 0.5;  // of the radius
constexpr double kWholeShare = 0.5;    // of the stroke

/// A run of brushed points, by row (see PartFinder).
struct PartRun {
  std::size_t first = 0, last = 0;
  bool is_forward = true;
};

/// Numbers the points of a stroke in rows: the row of an open stroke is the stroke; that of a
/// closed stroke starts at a point that is not brushed, if there is one, and ends there.
class PartFinder {
 public:
  PartFinder(const BrushedStroke& brushed, double radius_mm)
      : brushed_(brushed), radius_mm_(radius_mm), closed_(brushed.stroke->closed()) {
    const std::size_t n = brushed_.points.size();
    while (closed_ && start_ < n && is_on(start_)) ++start_;
    if (start_ == n) start_ = 0;
    lengths_.push_back(0.0);
    for (std::size_t k = 1; k < n + (closed_ ? 1 : 0); ++k) {
      lengths_.push_back(lengths_.back() +
                         distance(brushed_.points[index(k - 1)], brushed_.points[index(k)]));
    }
    find_runs();
  }

  [[nodiscard]] std::vector<StrokePart> parts() const;

 private:
  [[nodiscard]] std::size_t index(std::size_t k) const {
    return (start_ + k) % brushed_.points.size();
  }
  [[nodiscard]] bool is_on(std::size_t i) const {
    return brushed_.along_mm[i] >= kBrushedShare * radius_mm_;
  }
  [[nodiscard]] std::size_t last() const { return lengths_.size() - 1; }
  [[nodiscard]] double length(const PartRun& run) const {
    return lengths_[run.last] - lengths_[run.first];
  }
  void find_runs();
  [[nodiscard]] std::vector<StrokePart> whole() const;
  [[nodiscard]] StrokePart part(std::size_t first, std::size_t last) const;

  const BrushedStroke& brushed_;
  double radius_mm_;
  bool closed_;
  std::size_t start_ = 0;
  std::vector<double> lengths_;
  std::vector<PartRun> runs_;
};

void PartFinder::find_runs() {
  std::optional<PartRun> run;
  const double shortest_mm = std::min(radius_mm_, kWholeShare * lengths_.back());
  const auto finish = [&] {
    if (run && length(*run) >= shortest_mm) runs_.push_back(*run);
  };
  for (std::size_t k = 0; k < lengths_.size(); ++k) {
    if (!is_on(index(k))) continue;
    const bool is_forward = brushed_.sense_mm[index(k)] >= 0.0;
    if (run && run->is_forward == is_forward && lengths_[k] - lengths_[run->last] <= radius_mm_) {
      run->last = k;
      continue;
    }
    finish();
    run = PartRun{k, k, is_forward};
  }
  finish();
}

StrokePart PartFinder::part(std::size_t first, std::size_t last) const {
  StrokePart result;
  result.u0 = brushed_.us[index(first)];
  result.u1 = brushed_.us[index(last)];
  for (std::size_t k = first; k <= last; ++k) result.points.push_back(index(k));
  return result;
}

// Returns the whole stroke, cut between runs of opposite directions.
std::vector<StrokePart> PartFinder::whole() const {
  std::vector<std::size_t> cuts{0};
  for (std::size_t i = 0; i + 1 < runs_.size(); ++i) {
    if (runs_[i].is_forward == runs_[i + 1].is_forward) continue;
    cuts.push_back((runs_[i].last + runs_[i + 1].first) / 2);
  }
  cuts.push_back(last());
  std::vector<StrokePart> result;
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) result.push_back(part(cuts[i], cuts[i + 1]));
  if (result.size() == 1) result.front().is_whole = true;
  return result;
}

std::vector<StrokePart> PartFinder::parts() const {
  double sum_mm = 0.0;
  for (const PartRun& run : runs_) sum_mm += length(run);
  if (runs_.empty()) return {};
  if (sum_mm >= kWholeShare * lengths_.back()) return whole();
  std::vector<StrokePart> result;
  for (PartRun run : runs_) {
    if (!closed_ && lengths_[run.first] < radius_mm_) run.first = 0;
    if (!closed_ && lengths_.back() - lengths_[run.last] < radius_mm_) run.last = last();
    result.push_back(part(run.first, run.last));
  }
  return result;
}

}  // namespace

std::vector<StrokePart> brushed_parts(const BrushedStroke& brushed, double radius_mm) {
  return PartFinder(brushed, radius_mm).parts();
}

RoughLine line_of(const BrushedStroke& brushed, const StrokePart& part) {
  RoughLine line;
  for (const std::size_t i : part.points) line.push_back(brushed.points[i]);
  return line;
}

std::vector<StrokePart> remainders(const Stroke& stroke, const std::vector<StrokePart>& parts) {
  std::vector<StrokePart> result;
  if (parts.empty() || parts.front().is_whole) return result;
  const auto add = [&](double u0, double u1) {
    if (u0 != u1) result.push_back({.u0 = u0, .u1 = u1, .is_whole = false, .points = {}});
  };
  if (!stroke.closed()) add(0.0, parts.front().u0);
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) add(parts[i].u1, parts[i + 1].u0);
  if (stroke.closed()) {
    add(parts.back().u1, parts.front().u0);
  } else {
    add(parts.back().u1, stroke.segment_count());
  }
  return result;
}

}  // namespace felt
