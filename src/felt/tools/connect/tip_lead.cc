#include "felt/tools/connect/tip_lead.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "felt/base/check.h"
#include "felt/stroke/edit/join.h"
#include "felt/stroke/edit/split.h"
#include "felt/tools/connect/tip_bend.h"

namespace felt {
namespace {

constexpr double kLeadAccuracy = 1e-3;
constexpr double kRadians = std::numbers::pi / 180.0;

/// Minimum length by which a stroke is extended. For a smaller gap it bends instead.
constexpr double kMinPieceMm = 0.5;

/// Number of samples of a segment from which its bending energy is computed.
constexpr int kEnergySamples = 24;

/// Strokes with fewer segments are changed as a whole.
constexpr int kFewSegments = 48;

/// Returns the number of segments at the end of the stroke that a bend may change. Together they
/// are at least twice as long as the longest bend.
int segments_at(const Stroke& stroke, StrokeTip tip) {
  constexpr double kEnoughMm = 2.0 * TipLead::kMaxFadeMm;
  const int n = stroke.segment_count();
  double length = 0.0;
  for (int i = 0; i < n; ++i) {
    if (i >= kFewSegments / 2 && length > kEnoughMm) return i;
    const int segment = tip == StrokeTip::kStart ? i : n - 1 - i;
    length += arc_length(stroke.segment(segment), kLeadAccuracy);
  }
  return n;
}

double length_mm(const Stroke& stroke) {
  double length = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    length += arc_length(stroke.segment(i), kLeadAccuracy);
  }
  return length;
}

Stroke part_at(const Stroke& stroke, StrokeTip tip) {
  const int n = stroke.segment_count();
  const int count = n < kFewSegments ? n : segments_at(stroke, tip);
  if (count == n) return stroke;
  const auto part =
      tip == StrokeTip::kStart ? sub_stroke(stroke, 0, count) : sub_stroke(stroke, n - count, n);
  return part ? *part : stroke;
}

/// Appends `more`. Requires the first point, width and tone of `more` to be the last ones of
/// `data`.
void append(StrokeData& data, const StrokeData& more, JointKind joint) {
  const auto n = static_cast<double>(data.points.size() / 3);
  data.points.insert(data.points.end(), more.points.begin() + 1, more.points.end());
  data.joints.push_back(joint);
  data.joints.insert(data.joints.end(), more.joints.begin(), more.joints.end());
  for (std::size_t k = 1; k < more.widths.size(); ++k) {
    const WidthKnot& knot = more.widths[k];
    data.widths.push_back({n + knot.u, knot.width_mm, knot.tone});
  }
}

/// Returns `stroke` extended at `tip` by `piece`, which begins at the tip. The piece has the width
/// and tone of the tip.
Result<Stroke> prolonged(const Stroke& stroke, StrokeTip tip, const Cubic& piece) {
  const bool start = tip == StrokeTip::kStart;
  const WidthKnot& ink = start ? stroke.widths().front() : stroke.widths().back();
  StrokeData data;
  data.points.assign(piece.p.begin(), piece.p.end());
  if (start) std::reverse(data.points.begin(), data.points.end());
  data.widths = {{0.0, ink.width_mm, ink.tone}, {1.0, ink.width_mm, ink.tone}};
  data.medium = stroke.medium();
  data.color = stroke.color();
  const Result<Stroke> more = Stroke::create(std::move(data));
  if (!more) return more;
  return start ? joined(*more, stroke) : joined(stroke, *more);
}

/// Returns a cubic from the end of `stroke`, along its tangent, to `target`. Its handles have the
/// length for a circular arc, 2/3 chord/(1 + cos), with the angle between handle and chord, but at
/// most the length of the chord. If no arrival direction is given, its curvature at the target is
/// zero.
Cubic bridge(const Stroke& stroke, StrokeTip tip, Point target, std::optional<Vec> arrival) {
  const Point from = tip_point(stroke, tip);
  const Vec direction = tip_direction(stroke, tip), chord = target - from;
  const auto handle = [&](Vec along) {
    const double length = norm(chord);
    return 2.0 / 3.0 * length / std::max(1.0 + dot(along, chord) / length, 2.0 / 3.0);
  };
  const Point out = from + handle(direction) * direction;
  const Point in = arrival ? target - handle(*arrival) * *arrival : lerp(out, target, 0.5);
  return {{from, out, in, target}};
}

/// Returns the integral of the squared curvature over the segments. Corners do not count.
double bending_energy(const Stroke& stroke) {
  double energy = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic c = stroke.segment(i);
    Vec last{};
    for (int k = 1; k <= kEnergySamples; ++k) {
      const Vec chord = evaluate(c, static_cast<double>(k) / kEnergySamples) -
                        evaluate(c, static_cast<double>(k - 1) / kEnergySamples);
      const double turn = k > 1 ? angle_between(last, chord) : 0.0;
      if (turn > 0.0) energy += 2.0 * turn * turn / (norm(last) + norm(chord));
      last = chord;
    }
  }
  return energy;
}

}  // namespace

TipLead::TipLead(const Stroke& stroke, StrokeTip tip)
    : tip_(tip), part_(part_at(stroke, tip)), length_mm_(length_mm(part_)) {
  FELT_CHECK(!stroke.closed());
  small_gap_mm_ = std::min(0.125 * length_mm_, kMaxSmallGapMm);
  const int n = stroke.segment_count(), m = part_.segment_count();
  if (m == n) return;
  const bool start = tip == StrokeTip::kStart;
  const auto rest = start ? sub_stroke(stroke, m, n) : sub_stroke(stroke, 0, n - m);
  joint_ = stroke.joint(start ? m : n - m);
  rest_ = rest->data();  // cutting at a joint never fails
}

Result<Stroke> TipLead::at(Point target) const {
  if (!is_finite(target)) {
    return fail(ErrorCode::kInvalidArgument, "the position of the end of a stroke is not finite");
  }
  return whole(bent(target, std::nullopt));
}

Result<Stroke> TipLead::at(Point target, Vec arrival) const {
  const Point from = tip_point(part_, tip_);
  if (!is_finite(target) || distance(from, target) <= small_gap_mm_) return at(target);
  const Vec direction = tip_direction(part_, tip_);
  const bool is_along = angle_between(direction, arrival) < kSmoothJoinBelowDeg * kRadians;
  Result<Stroke> one = bent(target, is_along ? std::optional(arrival) : std::nullopt);
  Result<Stroke> other = prolonged(part_, tip_, bridge(part_, tip_, target, arrival));
  if (!other) return whole(one);
  const bool bends = one && is_along && bending_energy(*one) < bending_energy(*other);
  return whole(bends ? one : other);
}

/// Extends the stroke straight ahead, then bends it by the remaining shift, over a reach that grows
/// with that shift. If the bend fails, bridges the gap with a cubic.
Result<Stroke> TipLead::bent(Point target, std::optional<Vec> arrival) const {
  const Point from = tip_point(part_, tip_);
  const Vec direction = tip_direction(part_, tip_);
  const double gap = distance(from, target);
  double ahead = dot(target - from, direction);
  Result<Stroke> stroke = part_;
  if (ahead >= kMinPieceMm) {
    stroke = prolonged(part_, tip_, straight(from, from + ahead * direction));
    if (!stroke) return stroke;
  } else {
    ahead = 0.0;
  }
  const Vec shift = target - tip_point(*stroke, tip_);
  const double far = norm(shift), half = 0.5 * length_mm_;
  const double reach =
      std::max(std::min(std::max(kMinFadeMm, kFadePerShift * far), ahead + half),
               std::min(kMinFadePerShift * far, ahead + std::min(1.9 * half, kMaxFadeMm)));
  // The turn that makes the curvature at the end zero. It is blended in if the gap is larger than
  // small_gap_mm_.
  const double x = std::clamp(gap / small_gap_mm_ - 1.0, 0.0, 1.0);
  const Vec turn =
      arrival ? direction - *arrival : (-1.5 * x * x * (3.0 - 2.0 * x) / reach) * shift;
  Result<Stroke> bent = with_tip_bent(*stroke, tip_, target, reach, turn);
  return bent ? bent : prolonged(part_, tip_, bridge(part_, tip_, target, arrival));
}

Result<Stroke> TipLead::whole(const Result<Stroke>& part) const {
  if (!part || rest_.points.empty()) return part;
  const bool start = tip_ == StrokeTip::kStart;
  StrokeData data = start ? part->data() : rest_;
  append(data, start ? rest_ : part->data(), joint_);
  return Stroke::create(std::move(data));
}

}  // namespace felt
