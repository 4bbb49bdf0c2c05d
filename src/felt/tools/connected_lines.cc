#include "felt/tools/connected_lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "felt/stroke/edit/point_marks.h"
#include "felt/stroke/edit/subdivide.h"
#include "felt/tools/junctions.h"

namespace felt {
namespace {

enum class Motion { kStays, kMapped, kBends };

/// Returns true if a handle at an unmarked smooth joint turns because the arm on the other side is
/// marked. `step` is -1 if that arm comes before the joint, +1 if it comes after it.
bool turns_at(const Stroke& stroke, const Selection::Marks& marks, int joint, int step) {
  const int n = stroke.segment_count();
  if (stroke.closed()) joint = step < 0 ? (joint + n - 1) % n + 1 : joint % n;
  if (stroke.joint(stroke.closed() && joint == 0 ? n : joint) != JointKind::kSmooth) return false;
  const std::vector<Point>& points = stroke.data().points;
  const auto at = [&](int k) { return static_cast<std::size_t>(3 * joint + step * k); };
  if (marks[at(0)]) return false;
  int arm = 1;
  while (arm < 3 && points[at(arm)] == points[at(0)]) ++arm;
  return marks[at(arm)] != 0;
}

/// Returns how the point at u of a line with these marks moves.
Motion motion_at(const Stroke& stroke, const Selection::Marks& marks, double u) {
  constexpr double kAtJoint = 1e-3;
  const double joint = std::round(u);
  if (std::fabs(u - joint) < kAtJoint) {
    return marks[3 * static_cast<std::size_t>(joint)] ? Motion::kMapped : Motion::kStays;
  }
  const auto segment = static_cast<int>(u);
  const auto first = marks.begin() + 3 * segment;
  const auto count = std::count(first, first + 4, std::uint8_t{1});
  if (count == 4) return Motion::kMapped;
  const bool turns =
      turns_at(stroke, marks, segment, -1) || turns_at(stroke, marks, segment + 1, 1);
  return count == 0 && !turns ? Motion::kStays : Motion::kBends;
}

/// Returns the control point index of the end at u of an open stroke, or nullopt if u is not an
/// end.
std::optional<std::size_t> end_at(const Stroke& stroke, double u) {
  if (stroke.closed()) return std::nullopt;
  const int n = stroke.segment_count();
  if (u <= 0.0) return std::size_t{0};
  if (u >= n) return 3 * static_cast<std::size_t>(n);
  return std::nullopt;
}

/// Marks an end and its handle.
void mark_end(Selection::Marks& marks, std::size_t end) {
  marks[end] = 1;
  marks[end == 0 ? 1 : end - 1] = 1;
}

/// Unmarks an end that lies on a locked stroke, and the handle of this end.
void hold_end(MovedLine& line, double u) {
  const auto end = end_at(*line.stroke, u);
  if (!end) return;
  line.marks[*end] = 0;
  line.marks[*end == 0 ? 1 : *end - 1] = 0;
  close_marks(*line.stroke, line.marks);
}

/// A line of the result while it is prepared. Parameters are those of the stroke in the document.
struct Draft {
  MovedLine line;
  StrokePtr before;
  Selection::Marks own;  // marks of the points of `before`; none if it is not selected
  bool is_selected = false;
  /// Points that become joints. True if the joint is marked.
  std::map<double, bool> cuts;
  /// Parameters of `before` with the numbers of their joints on line.stroke.
  std::vector<std::pair<double, int>> joints;
  std::vector<Junction> junctions;
  std::vector<double> held;  // ends on locked strokes
  /// The number of the line that leads the end, and the parameter of the point on that line.
  std::optional<std::pair<std::size_t, double>> leader;

  [[nodiscard]] bool is_whole() const { return is_selected && all_marked(own); }
  /// Returns the parameter of a point on line.stroke.
  [[nodiscard]] double u_now(double u) const {
    if (line.stroke == before) return u;
    const auto next = std::upper_bound(joints.begin(), joints.end(), u,
                                       [](double v, const auto& k) { return v < k.first; });
    const auto& [u0, first] = *(next - 1);
    if (next == joints.end()) return first;
    return first + (next->second - first) * (u - u0) / (next->first - u0);
  }
  [[nodiscard]] Motion motion(double u) const {
    const Motion motion = motion_at(*line.stroke, line.marks, u_now(u));
    return leader && motion == Motion::kMapped ? Motion::kBends : motion;
  }
};

bool is_same_place(double u, double v) {
  return std::fabs(u - v) < 1e-6;
}

/// Divides the stroke of a draft at its cuts. Returns false if this is impossible.
bool divide(Draft& draft) {
  std::vector<double> us;
  for (int i = 0; i <= draft.before->segment_count(); ++i) us.push_back(i);
  for (const auto& [u, is_marked] : draft.cuts) us.push_back(u);
  std::sort(us.begin(), us.end());
  us.erase(std::unique(us.begin(), us.end()), us.end());
  std::vector<int> joints;
  auto divided = subdivided(*draft.before, us, &joints);
  if (!divided) return false;
  draft.line.stroke = draft.before;
  if (divided->segment_count() != draft.before->segment_count()) {
    draft.line.stroke = std::make_shared<const Stroke>(*std::move(divided));
  }
  draft.joints.clear();
  for (std::size_t k = 0; k < us.size(); ++k) draft.joints.emplace_back(us[k], joints[k]);
  return true;
}

/// Marks the points of line.stroke according to the selection, the cuts and the held ends.
void mark(Draft& draft) {
  Selection::Marks& marks = draft.line.marks;
  marks.assign(draft.line.stroke->data().points.size(), 0);
  const auto joint_point = [&](double u) {
    return 3 * static_cast<std::size_t>(std::lround(draft.u_now(u)));
  };
  for (std::size_t i = 0; i + 1 < draft.own.size(); i += 3) {
    const auto u = static_cast<double>(i / 3);
    const std::size_t first = joint_point(u), last = joint_point(u + 1.0);
    const auto from = draft.own.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::all_of(from, from + 4, [](std::uint8_t m) { return m != 0; })) {
      std::fill(marks.begin() + static_cast<std::ptrdiff_t>(first),
                marks.begin() + static_cast<std::ptrdiff_t>(last) + 1, std::uint8_t{1});
      continue;
    }
    for (const auto& [to, k] : {std::pair{first, i}, std::pair{first + 1, i + 1},
                                std::pair{last - 1, i + 2}, std::pair{last, i + 3}}) {
      if (draft.own[k]) marks[to] = 1;
    }
  }
  for (const auto& [u, is_marked] : draft.cuts) {
    if (!is_marked) continue;
    if (const auto end = end_at(*draft.before, u)) {
      mark_end(marks, *end == 0 ? 0 : marks.size() - 1);
    } else {
      marks[joint_point(u)] = 1;
    }
  }
  close_marks(*draft.line.stroke, marks);
  if (draft.is_whole()) return;
  for (const double u : draft.held) hold_end(draft.line, draft.u_now(u));
}

/// Finds the lines that move and the points at which they move, in rounds: in each round, the lines
/// that are new or have changed demand that the lines with which they share points move with them.
class Following {
 public:
  Following(const Document& document, const StrokeIndex& index)
      : document_(document), index_(index) {}

  ConnectedLines run(std::vector<MovedLine> selected) {
    for (MovedLine& line : selected) add(std::move(line), true);
    while (!changed_.empty()) {
      for (const std::size_t k : std::exchange(changed_, {})) visit(k);
      add_new();
      for (const std::size_t k : changed_) update(drafts_[k]);
    }
    ConnectedLines result;
    for (std::size_t k = 0; k < drafts_.size(); ++k) {
      result.may_part = result.may_part || may_part(k);
    }
    for (Draft& draft : drafts_) {
      if (draft.leader) {
        const auto [leader, u] = *draft.leader;
        draft.line.leader = MovedLine::Leader{leader, drafts_[leader].u_now(u)};
      }
    }
    for (Draft& draft : drafts_) {
      draft.line.is_selected_whole = draft.is_whole();
      result.lines.push_back(std::move(draft.line));
    }
    return result;
  }

 private:
  /// Adds a line that is selected or follows, and returns its number.
  std::size_t add(MovedLine line, bool is_selected) {
    const std::size_t number = drafts_.size();
    numbers_.emplace(line.id, number);
    changed_.insert(number);
    Draft draft;
    draft.before = document_.find(line.id);
    draft.junctions = junctions_of(document_, index_, line.id, *draft.before);
    draft.own = line.marks;
    draft.is_selected = is_selected;
    draft.line = std::move(line);
    for (const Junction& j : draft.junctions) {
      if (!j.editable && end_at(*draft.before, j.u)) draft.held.push_back(j.u);
    }
    // A line that moves as a whole keeps its shape, even if it separates from a locked line.
    if (!draft.is_whole()) {
      for (const double u : draft.held) hold_end(draft.line, u);
    }
    drafts_.push_back(std::move(draft));
    return number;
  }

  void visit(std::size_t k) {
    for (std::size_t i = 0; i < drafts_[k].junctions.size(); ++i) {
      const Junction j = drafts_[k].junctions[i];
      if (!j.editable) continue;
      const Motion motion = drafts_[k].motion(j.u);
      const auto known = numbers_.find(j.other);
      if (known != numbers_.end()) {
        meet(k, j.u, motion, known->second, j.other_u);
      } else if (motion == Motion::kMapped) {
        demands_[j.other].push_back(j.other_u);
      } else if (motion == Motion::kBends) {
        led_[j.other] = {{k, j.u}, j.other_u};
      }
    }
  }

  /// Makes two lines move equally at a point that they share, if one of them can.
  void meet(std::size_t k, double u, Motion motion, std::size_t other, double other_u) {
    const Motion other_motion = drafts_[other].motion(other_u);
    if (motion == other_motion || drafts_[k].leader || drafts_[other].leader) return;
    if (motion == Motion::kMapped) return demand(other, other_u, true);
    if (other_motion == Motion::kMapped) return demand(k, u, true);
    const bool bends = motion == Motion::kBends;
    if (!drafts_[bends ? other : k].is_selected) return;  // an end that follows
    demand(bends ? k : other, bends ? u : other_u, false);
  }

  /// Demands that the point of a line is a joint, and is marked or not.
  void demand(std::size_t k, double u, bool is_marked) {
    Draft& draft = drafts_[k];
    const auto is_here = [u](double v) { return is_same_place(u, v); };
    if (std::any_of(draft.held.begin(), draft.held.end(), is_here)) return;
    auto cut = draft.cuts.lower_bound(u - 1e-6);
    if (cut == draft.cuts.end() || !is_here(cut->first)) {
      cut = draft.cuts.emplace(u, false).first;
    } else if (cut->second || !is_marked) {
      return;
    }
    cut->second = is_marked;
    changed_.insert(k);
  }

  /// Divides and marks a line according to its demands.
  static void update(Draft& draft) {
    if (draft.leader || draft.cuts.empty()) return;
    if (divide(draft)) mark(draft);
  }

  /// Adds the strokes that follow since the last round.
  void add_new() {
    for (auto& [id, us] : std::exchange(demands_, {})) {
      led_.erase(id);
      MovedLine line;
      line.id = id;
      line.stroke = document_.find(id);
      line.marks.resize(line.stroke->data().points.size());
      const std::size_t number = add(std::move(line), false);
      for (const double u : us) demand(number, u, true);
    }
    for (const auto& [id, led] : std::exchange(led_, {})) {
      MovedLine line;
      line.id = id;
      line.stroke = document_.find(id);
      const auto end = end_at(*line.stroke, led.second);
      if (!end) continue;
      line.marks.resize(line.stroke->data().points.size());
      mark_end(line.marks, *end);
      close_marks(*line.stroke, line.marks);
      drafts_[add(std::move(line), false)].leader = led.first;
    }
  }

  /// Returns true if a line may part from another one or from a locked stroke.
  [[nodiscard]] bool may_part(std::size_t k) const {
    const Draft& draft = drafts_[k];
    return std::any_of(draft.junctions.begin(), draft.junctions.end(), [&](const Junction& j) {
      const Motion motion = draft.motion(j.u);
      if (!j.editable) return motion != Motion::kStays && !draft.is_whole();
      const auto known = numbers_.find(j.other);
      if (known == numbers_.end()) return motion != Motion::kStays;
      const Draft& other = drafts_[known->second];
      return motion == Motion::kBends || motion != other.motion(j.other_u);
    });
  }

  const Document& document_;
  const StrokeIndex& index_;
  std::vector<Draft> drafts_;
  std::map<StrokeId, std::size_t> numbers_;  // of drafts_
  std::set<std::size_t> changed_;
  std::map<StrokeId, std::vector<double>> demands_;  // on strokes that do not follow yet
  std::map<StrokeId, std::pair<std::pair<std::size_t, double>, double>> led_;
};

}  // namespace

ConnectedLines connected_lines(const Document& document, const StrokeIndex& index,
                               std::vector<MovedLine> selected) {
  return Following(document, index).run(std::move(selected));
}

}  // namespace felt
