#include "felt/stroke/edit/join.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "felt/stroke/edit/split.h"

namespace felt {
namespace {

/// The accuracy of lengths along a stroke, mm: finer than the eye can see.
constexpr double kLengthAccuracy = 1e-3;

/// A zero handle at a smooth joint gets this length, so that it has a direction of its own, which
/// does not change if control points elsewhere move. The curve moves by less than a micrometre.
constexpr double kStandingHandleMm = 1e-3;

tl::unexpected<Error> refuse(const char* why) {
  return fail(ErrorCode::kInvalidArgument, why);
}

/// Returns 1 at x = 0 and 0 from x = 1 on, with slope 0 at both.
double fade(double x) noexcept {
  return x < 1.0 ? 1.0 - x * x * (3.0 - 2.0 * x) : 0.0;
}

Cubic segment_of(const StrokeData& d, std::size_t i) {
  return {{d.points[3 * i], d.points[3 * i + 1], d.points[3 * i + 2], d.points[3 * i + 3]}};
}

/// Makes both handles at `at` collinear with `direction`; they keep their lengths.
void align(Point at, Vec direction, Point& before, Point& after) {
  const double in = std::max(distance(before, at), kStandingHandleMm);
  const double out = std::max(distance(after, at), kStandingHandleMm);
  before = at - in * direction;
  after = at + out * direction;
}

/// Returns the arc lengths from the tip to each joint, in the order of the joints.
std::vector<double> lengths_from_tip(const Stroke& stroke, StrokeTip tip) {
  const auto n = static_cast<std::size_t>(stroke.segment_count());
  std::vector<double> lengths(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    lengths[i + 1] = lengths[i] + arc_length(stroke.segment(static_cast<int>(i)), kLengthAccuracy);
  }
  if (tip == StrokeTip::kEnd) {
    const double whole = lengths.back();
    for (double& l : lengths) l = whole - l;
  }
  return lengths;
}

/// Appends the breakpoints of `more`, which start at n, up to `end`.
void append_profile(std::vector<WidthKnot>& knots, const std::vector<WidthKnot>& more, double n,
                    double end) {
  const auto add = [&](double u, const WidthKnot& k) { knots.push_back({u, k.width_mm, k.tone}); };
  // If both profiles agree at n, one breakpoint is enough; otherwise the step is one ulp wide.
  const WidthKnot &in = knots.back(), &out = more.front();
  if (in.width_mm != out.width_mm || in.tone != out.tone) add(std::nextafter(n, n + 1.0), out);
  for (std::size_t k = 1; k < more.size(); ++k) {
    if (const double u = n + more[k].u; u > knots.back().u) add(u, more[k]);
  }
  // Rounding may have moved the last u: set it exactly.
  knots.pop_back();
  add(end, more.back());
}

/// Appends `more` to `data`. Requires that the last point of `data` is the first of `more`.
void append(StrokeData& data, const StrokeData& more, JointKind joint) {
  const double n = static_cast<double>(data.points.size() / 3);
  data.points.insert(data.points.end(), more.points.begin() + 1, more.points.end());
  data.joints.push_back(joint);
  data.joints.insert(data.joints.end(), more.joints.begin(), more.joints.end());
  append_profile(data.widths, more.widths, n, static_cast<double>(data.points.size() / 3));
}

/// Stores in `data` the stroke with a joint at u and returns its number. If a cut there would leave
/// a sliver, uses the nearest joint other than the tip.
std::size_t cut_at(const Stroke& stroke, StrokeTip tip, double u, StrokeData& data) {
  const double n = stroke.segment_count();
  if (const auto parts = split(stroke, u); u != std::round(u) && parts) {
    data = parts->first.data();
    append(data, parts->second.data(), JointKind::kSmooth);
    return static_cast<std::size_t>(parts->first.segment_count());
  }
  data = stroke.data();
  const bool start = tip == StrokeTip::kStart;
  return static_cast<std::size_t>(std::clamp(std::round(u), start ? 1.0 : 0.0, start ? n : n - 1));
}

/// Returns the u at arc length `length` from the tip. `lengths` are the arc lengths from the tip to
/// the n + 1 joints.
double parameter_at(const Stroke& stroke, StrokeTip tip, const std::vector<double>& lengths,
                    double length) {
  std::size_t i = 0;  // the segment that contains arc length `length`
  const auto beyond = [&](std::size_t k) { return lengths[k] > length; };
  while (i + 2 < lengths.size() && beyond(i) == beyond(i + 1)) ++i;
  const Cubic c = stroke.segment(static_cast<int>(i));
  const double along = tip == StrokeTip::kStart ? length - lengths[i] : lengths[i] - length;
  return static_cast<double>(i) + parameter_at_length(c, along, kLengthAccuracy);
}

/// The part of a stroke that moves with one of its ends: from that end to a joint inserted where
/// the shift has faded to 0.
class TipZone {
 public:
  TipZone(const Stroke& stroke, StrokeTip tip, double reach, const std::vector<double>& lengths_mm)
      : tip_(tip), cut_(cut_at(stroke, tip, parameter_at(stroke, tip, lengths_mm, reach), data_)) {
    // Computes the lengths again for the new segments, from the end inwards.
    for (std::size_t i = 0; i < count(); ++i) {
      from_tip_.push_back(length_);
      length_ += arc_length(segment_of(data_, segment(i)), kLengthAccuracy);
    }
  }

  void shift(Vec by, Point target) {
    std::vector<Vec> tangents;
    for (std::size_t i = 0; i < count(); ++i) tangents.push_back(tangent_at(joint(i)));
    for (std::size_t i = 0; i < count(); ++i) {
      move(joint(i), fade(from_tip_[i] / length_) * by, tangents[i]);
    }
    align_cut();
    (tip_ == StrokeTip::kStart ? data_.points.front() : data_.points.back()) = target;
  }

  [[nodiscard]] StrokeData take() && { return std::move(data_); }

 private:
  [[nodiscard]] std::size_t segments() const { return data_.points.size() / 3; }
  /// Returns the number of segments in the zone, which is also the number of joints that move.
  [[nodiscard]] std::size_t count() const {
    return tip_ == StrokeTip::kStart ? cut_ : segments() - cut_;
  }
  // Return the number of the i-th segment or joint from the end inwards.
  [[nodiscard]] std::size_t segment(std::size_t i) const {
    return tip_ == StrokeTip::kStart ? i : segments() - 1 - i;
  }
  [[nodiscard]] std::size_t joint(std::size_t i) const {
    return tip_ == StrokeTip::kStart ? i : segments() - i;
  }
  [[nodiscard]] bool is_smooth(std::size_t j) const {
    return j > 0 && j < segments() && data_.joints[j - 1] == JointKind::kSmooth;
  }
  [[nodiscard]] Vec tangent_at(std::size_t j) const {
    return is_smooth(j) ? tangent(segment_of(data_, j - 1), 1.0) : Vec{};
  }

  /// Moves a joint with its handles. A smooth joint keeps its tangent.
  void move(std::size_t j, Vec by, Vec direction) {
    const std::size_t k = 3 * j;
    data_.points[k] += by;
    if (j > 0) data_.points[k - 1] += by;
    if (j < segments()) data_.points[k + 1] += by;
    if (is_smooth(j)) align(data_.points[k], direction, data_.points[k - 1], data_.points[k + 1]);
  }

  /// Aligns the handle on the moving side of the cut with the handle on the other side, which
  /// stays.
  void align_cut() {
    if (!is_smooth(cut_)) return;
    const bool start = tip_ == StrokeTip::kStart;
    const Point at = data_.points[3 * cut_];
    const Vec direction =
        start ? -tangent(segment_of(data_, cut_), 0.0) : tangent(segment_of(data_, cut_ - 1), 1.0);
    Point& handle = data_.points[start ? 3 * cut_ - 1 : 3 * cut_ + 1];
    handle = at + std::max(distance(handle, at), kStandingHandleMm) * direction;
  }

  StrokeTip tip_;
  StrokeData data_;
  std::size_t cut_;  // the joint at the inner end of the zone; it stays
  std::vector<double> from_tip_;
  double length_ = 0.0;
};

/// Returns the kind of a joint with these directions on both sides.
JointKind kind_of(Vec in, Vec out, double smooth_below_deg) {
  const double deg = angle_between(in, out) * (180.0 / std::numbers::pi);
  return deg < smooth_below_deg ? JointKind::kSmooth : JointKind::kCorner;
}

/// Rotates the handles of two segments at their common joint to their average direction. Requires
/// that `before` ends where `after` starts.
void make_smooth(StrokeData& data, std::size_t before, std::size_t after, Vec in, Vec out) {
  // A zero handle at the other end of either segment takes its direction from the handle that
  // rotates, so give it a length first.
  if (before > 0 && data.joints[before - 1] == JointKind::kSmooth) {
    Point* p = &data.points[3 * before];
    if (p[1] == p[0]) p[1] = p[0] + kStandingHandleMm * tangent(segment_of(data, before), 0.0);
  }
  const bool open_end = after + 1 >= data.points.size() / 3;
  if (!open_end && data.joints[after] == JointKind::kSmooth) {
    Point* p = &data.points[3 * after];
    if (p[2] == p[3]) p[2] = p[3] - kStandingHandleMm * tangent(segment_of(data, after), 1.0);
  }
  align(data.points[3 * after], normalized(in + out), data.points[3 * before + 2],
        data.points[3 * after + 1]);
}

}  // namespace

Result<Stroke> with_tip_at(const Stroke& stroke, StrokeTip tip, Point target, double fade_mm) {
  if (stroke.closed()) return refuse("a closed stroke has no end to move");
  if (!is_finite(target)) return refuse("the position of the end of a stroke is not finite");
  const Point from = tip_point(stroke, tip);
  const Vec shift = target - from;
  if (shift == Vec{}) return stroke;
  const auto lengths = lengths_from_tip(stroke, tip);
  const double reach = std::min(fade_mm, 0.5 * std::max(lengths.front(), lengths.back()));
  if (!(1.5 * norm(shift) <= reach)) return refuse("the stroke is too short to reach that far");

  TipZone zone(stroke, tip, reach, lengths);
  zone.shift(shift, target);
  return Stroke::create(std::move(zone).take());
}

Result<Stroke> joined(const Stroke& first, const Stroke& second, double smooth_below_deg) {
  if (first.closed() || second.closed()) return refuse("a closed stroke has no end to join");
  if (tip_point(first, StrokeTip::kEnd) != tip_point(second, StrokeTip::kStart)) {
    return refuse("strokes that do not meet cannot be joined");
  }
  const Vec in = tip_direction(first, StrokeTip::kEnd);
  const Vec out = -tip_direction(second, StrokeTip::kStart);
  const JointKind kind = kind_of(in, out, smooth_below_deg);
  StrokeData data = first.data();
  const std::size_t n = data.points.size() / 3;
  append(data, second.data(), kind);
  if (kind == JointKind::kSmooth) make_smooth(data, n - 1, n, in, out);
  return Stroke::create(std::move(data));
}

Result<Stroke> closed(const Stroke& stroke, double smooth_below_deg) {
  if (stroke.closed()) return refuse("the stroke is already closed");
  if (tip_point(stroke, StrokeTip::kEnd) != tip_point(stroke, StrokeTip::kStart)) {
    return refuse("a stroke whose ends do not meet cannot be closed");
  }
  const Vec in = tip_direction(stroke, StrokeTip::kEnd);
  const Vec out = -tip_direction(stroke, StrokeTip::kStart);
  const JointKind kind = kind_of(in, out, smooth_below_deg);
  StrokeData data = stroke.data();
  data.closed = true;
  data.joints.push_back(kind);
  if (kind == JointKind::kSmooth) make_smooth(data, data.points.size() / 3 - 1, 0, in, out);
  return Stroke::create(std::move(data));
}

}  // namespace felt
