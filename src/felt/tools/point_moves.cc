#include "felt/tools/point_moves.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <vector>

#include "felt/stroke/arc_map.h"
#include "felt/stroke/edit/subdivide.h"
#include "felt/tools/brush_pull.h"
#include "felt/tools/handles.h"

namespace felt {
namespace {

constexpr double kMoveAccuracy = 1e-7;
/// Number of segments, at least, over which the displacement changes from one value to another.
constexpr int kFadePieces = 4;

/// Other cuts keep this distance from the points that are moved, so that those become joints.
constexpr double kStopRoomMm = 1.5 * kMinSegmentMm;

/// The displacement along a stroke, by arc length in the stroke before the move.
class MoveField {
 public:
  MoveField(const Stroke& stroke, const ArcMap& map, std::span<const PointMove> moves,
            const BrushOptions& options)
      : stroke_(stroke), map_(map), options_(options) {
    for (const PointMove& move : moves) add_stop(move);
    std::sort(stops_.begin(), stops_.end(),
              [](const Stop& a, const Stop& b) { return a.s_mm < b.s_mm; });
    if (!stroke.closed()) add_outside(stops_.front(), false);
    for (std::size_t i = 1; i < stops_.size(); ++i) add_between(stops_[i - 1], stops_[i]);
    if (!stroke.closed()) {
      add_outside(stops_.back(), true);
      return;
    }
    Stop next = stops_.front();
    next.s_mm += map.length_mm();
    add_between(stops_.back(), next);
  }

  struct Stop {
    double s_mm = 0.0, u = 0.0;
    Vec shift{};
  };
  [[nodiscard]] const std::vector<Stop>& stops() const noexcept { return stops_; }

  /// Returns the parameters at which the stroke must be divided, ascending.
  [[nodiscard]] std::vector<double> cuts() const {
    std::vector<double> us;
    for (const Fade& fade : fades_) {
      const int pieces = fade.from == fade.to ? 1 : kFadePieces;
      for (int k = 0; k <= pieces; ++k) {
        const double s = fade.begin_mm + (fade.end_mm - fade.begin_mm) * k / pieces;
        if (!is_near_stop(s, kStopRoomMm)) us.push_back(map_.u_at(s));
      }
    }
    // The exact parameters, because a conversion to a length and back would round them.
    for (const Stop& stop : stops_) us.push_back(stop.u);
    std::sort(us.begin(), us.end());
    return us;
  }

  struct Value {
    Vec shift{}, slope{};
  };
  [[nodiscard]] Value at(double s_mm) const {
    const double length = map_.length_mm();
    if (stroke_.closed() && !fades_.empty() && s_mm < fades_.front().begin_mm) s_mm += length;
    auto next = std::upper_bound(fades_.begin(), fades_.end(), s_mm,
                                 [](double s, const Fade& fade) { return s < fade.begin_mm; });
    if (next == fades_.begin()) return {};
    const Fade& fade = *(next - 1);
    const double way = fade.end_mm - fade.begin_mm;
    const double x = way > 0.0 ? (s_mm - fade.begin_mm) / way : 1.0;
    // Beyond the last fade nothing moves. Rounding must not end a fade early.
    if (x > 1.0) return x * way - way < 1e-6 ? Value{fade.to, {}} : Value{};
    const Vec change = fade.to - fade.from;
    return {fade.from + (1.0 - influence(x)) * change,
            way > 0.0 ? (-influence_slope(x) / way) * change : Vec{}};
  }

 private:
  /// A part of the stroke over which the displacement changes from one value to another.
  struct Fade {
    double begin_mm = 0.0, end_mm = 0.0;
    Vec from{}, to{};
  };

  /// Returns true if a stop is nearer along the stroke than `within_mm`.
  [[nodiscard]] bool is_near_stop(double s_mm, double within_mm) const {
    if (stop_lengths_.empty()) return false;
    if (stroke_.closed()) s_mm -= map_.length_mm() * std::floor(s_mm / map_.length_mm());
    const auto is_near = [&](double stop_mm) {
      return std::fabs(map_.way(stop_mm, s_mm)) < within_mm;
    };
    const auto next = stop_lengths_.lower_bound(s_mm);
    if (next != stop_lengths_.end() && is_near(*next)) return true;
    if (next != stop_lengths_.begin() && is_near(*std::prev(next))) return true;
    return is_near(*stop_lengths_.begin()) || is_near(*stop_lengths_.rbegin());
  }
  void add_stop(const PointMove& move) {
    const double s = map_.length_at(move.u);
    if (is_near_stop(s, kMinSegmentMm)) return;
    stops_.push_back({s, move.u, move.to - stroke_.position(move.u)});
    stop_lengths_.insert(s);
  }

  void add(double begin_mm, double end_mm, Vec from, Vec to) {
    if (end_mm > begin_mm) fades_.push_back({begin_mm, end_mm, from, to});
  }
  void add_outside(const Stop& stop, bool is_after) {
    const BrushReach reach = brush_reach(stroke_, map_, stop.u, options_);
    const double s = stop.s_mm;
    if (is_after) {
      const double held = s + reach.after.held_mm;
      add(s, held, stop.shift, stop.shift);
      add(held, held + reach.after.way_mm, stop.shift, {});
    } else {
      const double held = s - reach.before.held_mm;
      add(held - reach.before.way_mm, held, {}, stop.shift);
      add(held, s, stop.shift, stop.shift);
    }
  }
  void add_between(const Stop& a, const Stop& b) {
    const double way = b.s_mm - a.s_mm;
    if (way > options_.radius_mm) {
      const BrushSide after = brush_reach(stroke_, map_, a.u, options_).after;
      const BrushSide before = brush_reach(stroke_, map_, b.u, options_).before;
      if (after.held_mm + after.way_mm + before.held_mm + before.way_mm <= way) {
        add_outside(a, true);
        add_outside(b, false);
        return;
      }
    }
    add(a.s_mm, b.s_mm, a.shift, b.shift);
  }

  const Stroke& stroke_;
  const ArcMap& map_;
  const BrushOptions& options_;
  std::vector<Stop> stops_;
  std::set<double> stop_lengths_;
  std::vector<Fade> fades_;  // in order along the stroke
};

/// Returns a segment whose ends have these displacements.
Cubic moved_segment(const Cubic& c, const MoveField::Value& first, const MoveField::Value& last) {
  return {{c.p[0] + first.shift, c.p[1] + first.shift + distance(c.p[0], c.p[1]) * first.slope,
           c.p[2] + last.shift - distance(c.p[2], c.p[3]) * last.slope, c.p[3] + last.shift}};
}

/// Moves the joint nearest to a point that could not become a joint, with its handles, so that the
/// curve passes through the target of the point.
void follow_stop(StrokeData& data, double u, Point target) {
  const std::size_t n = data.points.size() / 3;
  const std::size_t i = std::min(static_cast<std::size_t>(u), n - 1);
  const double t = u - static_cast<double>(i);
  const Point* p = &data.points[3 * i];
  const Vec rest = target - evaluate(Cubic{{p[0], p[1], p[2], p[3]}}, t);
  if (norm(rest) < 1e-9) return;
  const double near = std::min(t, 1.0 - t), far = 1.0 - near;
  const Vec shift = rest / (far * far * (far + 3.0 * near));
  const std::size_t j = t < 0.5 ? i : i + 1;
  data.points[3 * j] += shift;
  if (j > 0) data.points[3 * j - 1] += shift;
  if (j < n) data.points[3 * j + 1] += shift;
  if (!data.closed || (j > 0 && j < n)) return;
  data.points[j > 0 ? 0 : 3 * n] = data.points[3 * j];
  data.points[j > 0 ? 1 : 3 * n - 1] += shift;
}

Result<Stroke> moved_by(const Stroke& stroke, const MoveField& field) {
  Result<Stroke> divided = subdivided(stroke, field.cuts());
  if (!divided) return divided;
  const ArcMap map(*divided, kMoveAccuracy);
  StrokeData data = divided->data();
  const auto n = static_cast<std::size_t>(divided->segment_count());
  std::vector<MoveField::Value> values;
  for (int i = 0; i <= divided->segment_count(); ++i) values.push_back(field.at(map.start_of(i)));
  if (data.closed) values.back() = values.front();
  const auto moves = [&](std::size_t i) {
    return values[i].shift != Vec{} || values[i + 1].shift != Vec{};
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (moves(i)) give_handles(data, i);
  }
  const std::vector<Point> still = data.points;
  const auto before = [&](std::size_t i) {
    return Cubic{{still[3 * i], still[3 * i + 1], still[3 * i + 2], still[3 * i + 3]}};
  };
  for (std::size_t i = 0; i < n; ++i) {
    if (!moves(i)) continue;
    const Cubic c = moved_segment(before(i), values[i], values[i + 1]);
    std::copy(c.p.begin(), c.p.end(), data.points.begin() + static_cast<std::ptrdiff_t>(3 * i));
    keep_length(data, i, before(i));
  }
  if (data.closed) data.points.back() = data.points.front();
  for (std::size_t i = data.closed ? 0 : 1; i < n; ++i) {
    const bool is_moved = moves(i) || moves(i > 0 ? i - 1 : n - 1);
    if (is_moved) keep_smooth(data, i, tangent(before(i), 0.0));
  }
  for (const MoveField::Stop& stop : field.stops()) {
    follow_stop(data, map.u_at(stop.s_mm), stroke.position(stop.u) + stop.shift);
  }
  return Stroke::create(std::move(data));
}

}  // namespace

Result<Stroke> with_points_moved(const StrokePtr& stroke, std::span<const PointMove> moves,
                                 const BrushOptions& options) {
  if (moves.empty()) return *stroke;
  const ArcMap map(*stroke, kMoveAccuracy);
  const MoveField field(*stroke, map, moves, options);
  const auto& stops = field.stops();
  if (stops.size() == 1) return BrushPull(stroke, stops.front().u, options).at(stops.front().shift);
  return moved_by(*stroke, field);
}

}  // namespace felt
