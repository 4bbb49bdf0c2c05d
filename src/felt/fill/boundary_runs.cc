#include "felt/fill/boundary_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "felt/geometry/nearest.h"

namespace felt {
namespace {

constexpr double kSameShapeMm = 1e-3;  // an erased stroke's parts are this near to the stroke

double length_of(std::span<const Cubic> cubics) {
  double length = 0.0;
  for (const Cubic& c : cubics) length += arc_length(c, 1e-6);
  return length;
}

double u_at_length(std::span<const Cubic> segments, double length_mm) {
  double u = 0.0;
  for (const Cubic& c : segments) {
    const double length = arc_length(c, 1e-6);
    if (length_mm <= length) return u + parameter_at_length(c, length_mm, 1e-6);
    length_mm -= length;
    u += 1.0;
  }
  return u;
}

/// The nearest point of a stroke.
struct OnLine {
  StrokeId stroke;
  double u = 0.0;
  double distance_mm = std::numeric_limits<double>::infinity();
};

OnLine nearest_of(StrokeId id, const MeetingLine& line, Point p, double radius_mm) {
  OnLine best{id};
  double limit = radius_mm * radius_mm;
  for (std::size_t i = 0; i < line.segments.size(); ++i) {
    if (distance_squared(line.boxes[i], p) > limit) continue;
    const auto hit = nearest_within(line.segments[i], p, limit);
    if (!hit || (std::isfinite(best.distance_mm) && hit->distance_squared >= limit)) continue;
    limit = hit->distance_squared;
    best.u = static_cast<double>(i) + hit->t;
    best.distance_mm = std::sqrt(limit);
  }
  return best;
}

class RunFinder {
 public:
  RunFinder(const LineMeetings& now, std::span<const LineEdit> edits) : now_(now), edits_(edits) {}

  void add(const OldStep& step) {
    if (!step.piece.stroke) return;
    const LineEdit* edit = find_edit(step.piece.stroke);
    if (edit ? edit->after.size() == 1 : now_.find(step.piece.stroke) != nullptr) {
      add_on_one(step, edit, edit ? edit->after.front() : step.piece.stroke);
    } else {
      add_by_shape(step, edit);
    }
  }

  std::vector<BoundaryRun> runs() && {
    merge_at_seams();
    return std::move(runs_);
  }

 private:
  [[nodiscard]] const LineEdit* find_edit(StrokeId id) const {
    const auto found =
        std::find_if(edits_.begin(), edits_.end(), [&](const LineEdit& e) { return e.id == id; });
    return found == edits_.end() ? nullptr : &*found;
  }

  /// The stroke was replaced by one stroke: the same parameter if the number of segments is the
  /// same, the nearest point if the shape is, and otherwise the same share of the arc length.
  void add_on_one(const OldStep& step, const LineEdit* edit, StrokeId id) {
    const MeetingLine* line = now_.find(id);
    if (!line) return;
    const bool known = edit && edit->before;
    const int n = line->stroke->segment_count();
    const double high = std::max(step.piece.from, step.piece.to);
    if (known ? edit->before->segment_count() == n : high <= n) {
      runs_.push_back({id, step.piece.from, step.piece.to});
      return;
    }
    BoundaryRun run{id, 0.0, 0.0};
    for (const bool first : {true, false}) {
      const double u = first ? step.piece.from : step.piece.to;
      const Point p = first ? step.points.front() : step.points.back();
      (first ? run.from : run.to) = carry_over(u, p, known ? edit->before.get() : nullptr, *line);
    }
    runs_.push_back(run);
  }

  static double carry_over(double u, Point p, const Stroke* before, const MeetingLine& line) {
    const auto n = static_cast<double>(line.segments.size());
    if (u <= 0.0) return 0.0;
    if (before && u >= before->segment_count()) return n;
    const OnLine nearest = nearest_of({}, line, p, std::numeric_limits<double>::max());
    if (nearest.distance_mm <= kSameShapeMm || !before) return nearest.u;
    std::vector<Cubic> old;
    for (int i = 0; i < before->segment_count(); ++i) old.push_back(before->segment(i));
    const double share = length_of(cubics_between(old, 0.0, u)) / length_of(old);
    return u_at_length(line.segments, share * length_of(line.segments));
  }

  /// The stroke was divided, or nothing is known: looks for strokes that lie on the old piece.
  void add_by_shape(const OldStep& step, const LineEdit* edit) {
    constexpr int kSamples = 16;
    StrokeId last;
    for (std::size_t i = 0; i + 3 < step.points.size(); i += 3) {
      const Cubic c{{step.points[i], step.points[i + 1], step.points[i + 2], step.points[i + 3]}};
      for (int k = i == 0 ? 0 : 1; k <= kSamples; ++k) {
        const OnLine at = stroke_at(evaluate(c, static_cast<double>(k) / kSamples), edit, last);
        if (at.stroke && at.stroke == last) {
          runs_.back().to = at.u;
        } else {
          if (last) extend_to_tip(runs_.back(), true);
          if (at.stroke) {
            runs_.push_back({at.stroke, at.u, at.u});
            has_gap_before_ = i != 0 || k != 0;
          }
        }
        last = at.stroke;
        if (has_gap_before_ && last && runs_.back().to != runs_.back().from) {
          extend_to_tip(runs_.back(), false);
          has_gap_before_ = false;
        }
      }
    }
    has_gap_before_ = false;
  }

  /// The run ends at a cut, so the end of the stroke is there or up to one sample farther.
  void extend_to_tip(BoundaryRun& run, bool at_end) const {
    const MeetingLine* line = now_.find(run.stroke);
    if (!line || line->stroke->closed() || run.to == run.from) return;
    const bool forward = run.to > run.from;
    const auto n = static_cast<double>(line->segments.size());
    (at_end ? run.to : run.from) = forward == at_end ? n : 0.0;
  }

  [[nodiscard]] OnLine stroke_at(Point p, const LineEdit* edit, StrokeId preferred) const {
    OnLine best;
    const auto offer = [&](StrokeId id, const MeetingLine& line) {
      if (distance_squared(line.box, p) > kSameShapeMm * kSameShapeMm) return;
      const OnLine found = nearest_of(id, line, p, kSameShapeMm);
      if (!std::isfinite(found.distance_mm)) return;
      if (id == preferred || !best.stroke) best = found;
    };
    if (edit) {
      for (const StrokeId id : edit->after) {
        if (const MeetingLine* line = now_.find(id)) offer(id, *line);
      }
    } else {
      const Rect near = Rect{p.x, p.y, p.x, p.y}.inflated(kSameShapeMm);
      for (const StrokeId id : now_.lines_in(near)) offer(id, *now_.find(id));
    }
    return best;
  }

  [[nodiscard]] bool merge(BoundaryRun& a, const BoundaryRun& b) const {
    if (a.stroke != b.stroke) return false;
    const MeetingLine* line = now_.find(a.stroke);
    if (!line->stroke->closed()) return false;
    const auto n = static_cast<double>(line->segments.size());
    if (a.from != a.to && b.from != b.to && (a.to > a.from) != (b.to > b.from)) return false;
    const double turns = (a.to - b.from) / n;
    if (turns == 0.0 || turns != std::round(turns)) return false;
    a.to = b.to + turns * n;
    return true;
  }

  void merge_at_seams() {
    std::vector<BoundaryRun> merged;
    for (const BoundaryRun& run : runs_) {
      if (merged.empty() || !merge(merged.back(), run)) merged.push_back(run);
    }
    if (merged.size() > 1 && merge(merged.back(), merged.front())) merged.erase(merged.begin());
    runs_ = std::move(merged);
  }

  const LineMeetings& now_;
  std::span<const LineEdit> edits_;
  std::vector<BoundaryRun> runs_;
  bool has_gap_before_ = false;
};

/// How two neighbouring runs are joined: where the first ends and the second begins.
struct RunJoint {
  double first = 0.0, second = 0.0;
  std::vector<Point> path;  ///< from the first stroke to the second; one point if they meet
  double cost = std::numeric_limits<double>::infinity();
  bool gap = false;
};

class Joiner {
 public:
  Joiner(const LineMeetings& now, const JoinRules& rules) : now_(now), rules_(rules) {}

  [[nodiscard]] RunJoint join(const BoundaryRun& a, const BoundaryRun& b) const {
    const MeetingLine &first = *now_.find(a.stroke), &second = *now_.find(b.stroke);
    const Point end = at(first, a.to), start = at(second, b.from);
    RunJoint best;
    best.first = a.to, best.second = b.from;
    for (const Meeting& m : now_.between(a.stroke, b.stroke)) {
      if (a.stroke == b.stroke) {  // both orders give the same point, so the parameters decide
        offer(best, m.u, m.v, {m.point}, std::fabs(a.to - m.u) + std::fabs(b.from - m.v));
        offer(best, m.v, m.u, {m.point}, std::fabs(a.to - m.v) + std::fabs(b.from - m.u));
      } else {
        offer(best, m.u, m.v, {m.point}, distance(m.point, end) + distance(m.point, start));
      }
    }
    for (const TipLink& link : rules_.links) offer_link(best, link, a.stroke, b.stroke, end, start);
    if (!std::isfinite(best.cost)) best.gap = distance(end, start) > kSnapMm;
    if (!std::isfinite(best.cost))
      best.path = best.gap ? std::vector{end, start} : std::vector{end};
    best.first = near(best.first, a.to, first);
    best.second = near(best.second, b.from, second);
    return best;
  }

  [[nodiscard]] static Point at(const MeetingLine& line, double u) {
    const auto n = static_cast<double>(line.segments.size());
    return line.stroke->position(line.stroke->closed() ? u - n * std::floor(u / n) : u);
  }

 private:
  void offer(RunJoint& best, double first, double second, std::vector<Point> path,
             double cost) const {
    if (cost < best.cost && cost <= rules_.max_move_mm)
      best = {first, second, std::move(path), cost, false};
  }

  void offer_link(RunJoint& best, const TipLink& link, StrokeId a, StrokeId b, Point end,
                  Point start) const {
    for (const bool turned : {false, true}) {
      const LinkEnd &from = turned ? link.to : link.from, &to = turned ? link.from : link.to;
      if (from.stroke != a || to.stroke != b) continue;
      std::vector<Point> path{from.point};
      if (link.corner) path.push_back(*link.corner);
      path.push_back(to.point);
      offer(best, from.u, to.u, std::move(path),
            distance(from.point, end) + distance(to.point, start));
    }
  }

  /// Returns u plus as many turns around a closed stroke as bring it nearest to `old`.
  static double near(double u, double old, const MeetingLine& line) {
    if (!line.stroke->closed()) return u;
    const auto n = static_cast<double>(line.segments.size());
    return u + n * std::round((old - u) / n);
  }

  const LineMeetings& now_;
  const JoinRules& rules_;
};

/// Appends the steps of a run from `start` to `end`, divided at the seam of a closed stroke.
void append_steps(std::vector<LoopStep>& steps, const BoundaryRun& run, const MeetingLine& line,
                  Point start, Point end) {
  const auto n = static_cast<double>(line.segments.size());
  const bool forward = run.to > run.from;
  double from = run.from;
  while (line.stroke->closed()) {
    const double seam =
        forward ? n * (std::floor(from / n) + 1.0) : n * (std::ceil(from / n) - 1.0);
    if (forward ? seam >= run.to : seam <= run.to) break;
    const double base = n * std::floor((forward ? from : seam) / n);
    const Point middle = line.stroke->data().points.front();
    steps.push_back({{run.stroke, from - base, seam - base}, start, middle});
    from = seam, start = middle;
  }
  const double base = line.stroke->closed() ? n * std::floor(std::min(from, run.to) / n) : 0.0;
  steps.push_back({{run.stroke, from - base, run.to - base}, start, end});
}

/// Returns true if the run still goes the same way, and at most once around.
bool keeps_direction(const BoundaryRun& before, const BoundaryRun& after, const MeetingLine& line) {
  const double length = after.to - after.from;
  const auto n = static_cast<double>(line.segments.size());
  return std::fabs(length) > 1e-9 && std::fabs(length) <= n &&
         (length > 0.0) == (before.to > before.from);
}

}  // namespace

std::vector<BoundaryRun> runs_after(const FillLoop& loop, const LineMeetings& now,
                                    std::span<const LineEdit> edits) {
  RunFinder finder(now, edits);
  for (const OldStep& step : old_steps(loop)) finder.add(step);
  auto runs = std::move(finder).runs();
  std::erase_if(runs, [](const BoundaryRun& run) { return run.from == run.to; });
  return runs;
}

std::optional<FillLoop> join_runs(const std::vector<BoundaryRun>& runs, const LineMeetings& now,
                                  const JoinRules& rules) {
  if (runs.empty()) return std::nullopt;
  std::vector<LoopStep> steps;
  const MeetingLine* only = now.find(runs.front().stroke);
  const bool whole =
      runs.size() == 1 && only->stroke->closed() &&
      std::fabs(runs.front().to - runs.front().from) == static_cast<double>(only->segments.size());
  const Joiner joiner(now, rules);
  std::vector<RunJoint> joints;  // joints[i] follows runs[i]
  for (std::size_t i = 0; i < runs.size() && !whole; ++i) {
    joints.push_back(joiner.join(runs[i], runs[(i + 1) % runs.size()]));
    if (joints.back().gap && !rules.close_gaps) return std::nullopt;
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const MeetingLine& line = *now.find(runs[i].stroke);
    if (whole) {
      const Point p = Joiner::at(line, runs[i].from);
      append_steps(steps, runs[i], line, p, p);
      break;
    }
    const RunJoint &before = joints[(i + runs.size() - 1) % runs.size()], &after = joints[i];
    const BoundaryRun run{runs[i].stroke, before.second, after.first};
    if (!keeps_direction(runs[i], run, line)) return std::nullopt;
    append_steps(steps, run, line, before.path.back(), after.path.front());
    for (std::size_t k = 1; k < after.path.size(); ++k) {
      steps.push_back({{}, after.path[k - 1], after.path[k]});
    }
  }
  FillLoop loop = loop_of_steps(steps, now);
  constexpr double kNothingMm2 = 1e-9;
  if (!(std::fabs(area_of(loop)) > kNothingMm2)) return std::nullopt;
  return loop;
}

}  // namespace felt
