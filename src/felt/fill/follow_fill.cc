#include "felt/fill/follow_fill.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "felt/fill/boundary_runs.h"
#include "felt/fill/curve_area.h"
#include "felt/fill/fill_shape.h"
#include "felt/geometry/affine.h"

namespace felt {
namespace {

constexpr double kJointMm = 1e-5;  // pieces that end this near to each other still meet

/// Returns true if the strokes still have the pieces of the loop, up to the ends, which the map may
/// have moved a little.
bool is_unchanged(const FillLoop& loop, const LineMeetings& now) {
  if (loop.pieces.empty()) return true;
  const auto steps = old_steps(loop);
  if (steps.empty()) return true;  // the references do not fit the points: nothing to follow
  return std::all_of(steps.begin(), steps.end(), [&](const OldStep& step) {
    if (!step.piece.stroke) return true;
    if (!now.find(step.piece.stroke)) return false;
    const LoopStep same{step.piece, step.points.front(), step.points.back()};
    const auto cubics = cubics_of_step(same, now);
    if (3 * cubics.size() + 1 != step.points.size()) return false;
    const auto& line = now.find(step.piece.stroke)->stroke;
    if (distance(line->position(step.piece.from), same.start) > kJointMm) return false;
    if (distance(line->position(step.piece.to), same.end) > kJointMm) return false;
    for (std::size_t i = 0; i < step.points.size(); ++i) {
      if (cubics[std::min(i / 3, cubics.size() - 1)].p[i / 3 < cubics.size() ? i % 3 : 3] !=
          step.points[i]) {
        return false;
      }
    }
    return true;
  });
}

/// The affine map that fits pairs of points best, by least squares about their centres.
class AffineFit {
 public:
  void add(Point from, Point to) { pairs_.emplace_back(from, to); }

  /// Returns the map, or nullopt if the points do not determine it or it misses one of them.
  [[nodiscard]] std::optional<Affine> map() const {
    if (pairs_.empty()) return std::nullopt;
    Vec from{}, to{};
    for (const auto& [p, q] : pairs_) from += p - Point{}, to += q - Point{};
    const auto n = static_cast<double>(pairs_.size());
    from = from / n, to = to / n;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    Vec by_x{}, by_y{};
    for (const auto& [p, q] : pairs_) {
      const Vec a = p - Point{} - from, b = q - Point{} - to;
      xx += a.x * a.x, xy += a.x * a.y, yy += a.y * a.y;
      by_x += a.x * b, by_y += a.y * b;
    }
    const double det = xx * yy - xy * xy;
    if (!(det > 1e-9 * (xx + yy) * (xx + yy))) return std::nullopt;
    const Vec ex = (yy * by_x - xy * by_y) / det, ey = (xx * by_y - xy * by_x) / det;
    Affine m{ex.x, ex.y, ey.x, ey.y, 0.0, 0.0};
    const Vec moved = to - apply(m, from);
    m.e = moved.x, m.f = moved.y;
    for (const auto& [p, q] : pairs_) {
      if (distance(apply(m, p), q) > kJointMm) return std::nullopt;
    }
    return m;
  }

 private:
  std::vector<std::pair<Point, Point>> pairs_;
};

/// Returns the loop of the same pieces, if these still meet, or have all moved by one affine map.
std::optional<FillLoop> moved_together(const FillLoop& loop, const LineMeetings& now) {
  const auto steps = old_steps(loop);
  std::vector<std::vector<Cubic>> parts;
  AffineFit fit;
  bool has_bridges = false;
  for (const OldStep& step : steps) {
    const MeetingLine* line = now.find(step.piece.stroke);
    const double high = std::max(step.piece.from, step.piece.to);
    parts.emplace_back();
    has_bridges = has_bridges || !step.piece.stroke;
    if (!step.piece.stroke) continue;
    if (!line || high > static_cast<double>(line->segments.size())) return std::nullopt;
    std::vector<Cubic>& part = parts.back() =
        cubics_between(line->segments, step.piece.from, step.piece.to);
    if (3 * part.size() + 1 != step.points.size()) return std::nullopt;
    for (std::size_t i = 0; i < part.size(); ++i) {
      for (std::size_t k = 0; k < 4; ++k) fit.add(step.points[3 * i + k], part[i].p[k]);
    }
  }
  std::optional<Affine> all;
  if (has_bridges && !(all = fit.map())) return std::nullopt;
  std::vector<LoopStep> result;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Point start = parts[i].empty() ? apply(*all, steps[i].points.front()) : parts[i][0].p[0];
    const Point end = parts[i].empty() ? apply(*all, steps[i].points.back()) : parts[i].back().p[3];
    result.push_back({steps[i].piece, start, end});
  }
  for (std::size_t i = 0; i < result.size(); ++i) {
    LoopStep& next = result[(i + 1) % result.size()];
    if (distance(result[i].end, next.start) > kJointMm) return std::nullopt;
    result[i].end = next.start;
  }
  return loop_of_steps(result, now);
}

enum class InsideOf : std::uint8_t { kAll, kSome, kNone };

InsideOf points_inside(const FillLoop& hole, const FillLoop& outer) {
  bool any = false, all = true;
  for (std::size_t i = 0; i + 3 < hole.points.size(); i += 3) {
    const auto& p = hole.points;
    for (const double t : {0.0, 0.37, 0.71}) {
      const Point at = evaluate(Cubic{{p[i], p[i + 1], p[i + 2], p[i + 3]}}, t);
      const bool inside = is_inside(outer.points, at);
      any = any || inside, all = all && inside;
    }
  }
  return all ? InsideOf::kAll : any ? InsideOf::kSome : InsideOf::kNone;
}

/// Follows one fill; see follow_fill().
class Follower {
 public:
  Follower(const Fill& fill, FillMap& map, std::span<const LineEdit> edits, WhenOpened when_opened)
      : fill_(fill), map_(map), now_(map.meetings()), edits_(edits), when_opened_(when_opened) {}

  std::optional<Fill> run() {
    const bool same = std::all_of(fill_.loops.begin(), fill_.loops.end(),
                                  [&](const FillLoop& l) { return is_unchanged(l, now_); });
    if (same || fill_.loops.empty()) return fill_;
    Fill result{{}, fill_.color, fill_.max_gap_mm};
    auto outer = follow(fill_.loops.front(), false);
    if (!outer) {
      if (auto face = matching_face()) return face;
      outer = when_opened_ == WhenOpened::kClose ? join(fill_.loops.front(), true) : std::nullopt;
      if (!outer) return std::nullopt;
    }
    result.loops.push_back(std::move(*outer));
    for (std::size_t i = 1; i < fill_.loops.size(); ++i) {
      auto hole = follow(fill_.loops[i], true);
      if (!hole) continue;
      const InsideOf inside = points_inside(*hole, result.loops.front());
      if (inside == InsideOf::kSome) {
        if (auto face = matching_face()) return face;
      }
      if (inside == InsideOf::kAll) result.loops.push_back(std::move(*hole));
    }
    return result;
  }

 private:
  std::optional<FillLoop> follow(const FillLoop& loop, bool hole) {
    if (is_unchanged(loop, now_)) return loop;
    if (!is_cut(loop)) {
      if (auto moved = moved_together(loop, now_)) return moved;
    }
    // Without a part that has disappeared, its neighbours would be joined at an unrelated crossing.
    if (!has_lost_part(loop)) {
      if (auto joined = join(loop, false)) return joined;
    }
    return hole && when_opened_ == WhenOpened::kClose ? join(loop, true) : std::nullopt;
  }

  /// Returns true if one of the loop's strokes was divided or removed.
  [[nodiscard]] bool is_cut(const FillLoop& loop) const {
    return has_lost_part(loop) || std::any_of(edits_.begin(), edits_.end(), [&](const LineEdit& e) {
             return e.after.size() != 1 && has_piece(loop, e.id);
           });
  }

  static bool has_piece(const FillLoop& loop, StrokeId id) {
    return std::any_of(loop.pieces.begin(), loop.pieces.end(),
                       [&](const FillPiece& piece) { return piece.stroke == id; });
  }

  /// Returns true if one of the loop's strokes has left nothing behind.
  [[nodiscard]] bool has_lost_part(const FillLoop& loop) const {
    for (const FillPiece& piece : loop.pieces) {
      if (!piece.stroke) continue;
      const auto edit = std::find_if(edits_.begin(), edits_.end(),
                                     [&](const LineEdit& e) { return e.id == piece.stroke; });
      if (edit != edits_.end() ? edit->after.empty() : !now_.find(piece.stroke)) return true;
    }
    return false;
  }

  std::optional<FillLoop> join(const FillLoop& loop, bool close_gaps) {
    JoinRules rules{map_.links(fill_.max_gap_mm), close_gaps};
    // Cutting moves nothing, so a meeting elsewhere is another one.
    constexpr double kCutMoveMm = 0.1;
    if (is_cut(loop)) rules.max_move_mm = fill_.max_gap_mm + kCutMoveMm;
    return join_runs(runs_after(loop, now_, edits_), now_, rules);
  }

  /// Returns the fill of the face that agrees with the old shape by at least half of the area that
  /// both cover together; estimated with a grid of points.
  std::optional<Fill> matching_face() {
    constexpr int kGrid = 8;
    const PlanarMap& planar = map_.map(fill_.max_gap_mm);
    Rect box;
    for (const Point p : fill_.loops.front().points) box.extend(p);
    std::map<std::size_t, int> hits;
    for (int i = 0; i < kGrid * kGrid; ++i) {
      const Point p{box.x0 + box.width() * (i % kGrid + 0.5) / kGrid,
                    box.y0 + box.height() * (static_cast<double>(i / kGrid) + 0.5) / kGrid};
      if (!is_inside(fill_.loops.front().points, p)) continue;
      if (const auto loop = planar.loop_around(p)) ++hits[*loop];
    }
    const double cell = box.width() * box.height() / (kGrid * kGrid);
    const double before = std::fabs(area_of(fill_.loops.front()));
    std::optional<std::size_t> best;
    double best_share = 0.5;
    for (const auto& [loop, count] : hits) {
      const double shared = cell * count;
      const double share = shared / (before + planar.loops()[loop].area_mm2 - shared);
      if (share > best_share) best_share = share, best = loop;
    }
    if (!best) return std::nullopt;
    return map_.fill_of(*best, fill_.max_gap_mm, fill_.color).fill;
  }

  const Fill& fill_;
  FillMap& map_;
  const LineMeetings& now_;
  std::span<const LineEdit> edits_;
  WhenOpened when_opened_;
};

}  // namespace

std::optional<Fill> follow_fill(const Fill& fill, FillMap& map, std::span<const LineEdit> edits,
                                WhenOpened when_opened) {
  return Follower(fill, map, edits, when_opened).run();
}

}  // namespace felt
