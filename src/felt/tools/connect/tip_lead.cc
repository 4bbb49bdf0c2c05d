#include "felt/tools/connect/tip_lead.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/base/check.h"
#include "felt/stroke/join.h"
#include "felt/stroke/split.h"
#include "felt/tools/connect/tip_bend.h"

namespace felt {
namespace {

constexpr double kLengthAccuracy = 1e-3;

/// A shorter piece is not grown: the stroke bends a little less instead.
constexpr double kShortestPieceMm = 0.5;

/// Strokes of fewer segments are worked on whole.
constexpr int kFewSegments = 48;

/// The number of segments at the end that are long enough for every bend: twice the longest fade.
int segments_at(const Stroke& stroke, StrokeTip tip) {
  constexpr double kEnoughMm = 2.0 * TipLead::kFadePerShift * TipLead::kMostBendMm;
  const int n = stroke.segment_count();
  double length = 0.0;
  for (int i = 0; i < n; ++i) {
    if (i >= kFewSegments / 2 && length > kEnoughMm) return i;
    const int segment = tip == StrokeTip::kStart ? i : n - 1 - i;
    length += arc_length(stroke.segment(segment), kLengthAccuracy);
  }
  return n;
}

double length_mm(const Stroke& stroke) {
  double length = 0.0;
  for (int i = 0; i < stroke.segment_count(); ++i) {
    length += arc_length(stroke.segment(i), kLengthAccuracy);
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

/// Appends `more`, whose first point is the last one of `data`; widths and tones agree there.
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

/// A straight stroke of one width and tone and of the look of `like`.
Result<Stroke> straight_piece(Point from, Point to, const WidthKnot& ink, const Stroke& like) {
  const Cubic line = straight(from, to);
  StrokeData data;
  data.points.assign(line.p.begin(), line.p.end());
  data.widths = {{0.0, ink.width_mm, ink.tone}, {1.0, ink.width_mm, ink.tone}};
  data.material = like.material();
  data.color = like.color();
  return Stroke::create(std::move(data));
}

}  // namespace

TipLead::TipLead(const Stroke& stroke, StrokeTip tip)
    : tip_(tip), part_(part_at(stroke, tip)), length_mm_(length_mm(part_)) {
  FELT_CHECK(!stroke.closed());
  most_bend_mm_ = std::min(0.25 * length_mm_, kMostBendMm);
  const int n = stroke.segment_count(), m = part_.segment_count();
  if (m == n) return;
  const bool start = tip == StrokeTip::kStart;
  const auto rest = start ? sub_stroke(stroke, m, n) : sub_stroke(stroke, 0, n - m);
  joint_ = stroke.joint(start ? m : n - m);
  rest_ = rest->data();  // cuts at joints are always possible
}

Result<Stroke> TipLead::at(Point target) const {
  if (!is_finite(target)) {
    return fail(ErrorCode::kInvalidArgument, "the place for the end of a stroke is not finite");
  }
  const Result<Stroke> part = bent_and_grown(target);
  return part ? whole(*part) : part;
}

Result<Stroke> TipLead::bent_and_grown(Point target) const {
  const Point from = tip_point(part_, tip_);
  const double shift = distance(from, target);
  const bool grows = shift > most_bend_mm_;
  const double bend =
      grows ? std::min(most_bend_mm_, std::max(shift - kShortestPieceMm, 0.0)) : shift;
  const double fade = std::min(std::max(kLeastFadeMm, kFadePerShift * bend), 0.5 * length_mm_);
  if (!grows) return with_tip_bent(part_, tip_, target, fade);
  const Point to = from + (bend / shift) * (target - from);
  Result<Stroke> bent = with_tip_bent(part_, tip_, to, fade);
  if (!bent) return bent;
  const bool start = tip_ == StrokeTip::kStart;
  const WidthKnot& ink = start ? bent->widths().front() : bent->widths().back();
  const Result<Stroke> piece =
      start ? straight_piece(target, to, ink, part_) : straight_piece(to, target, ink, part_);
  if (!piece) return piece;
  return start ? joined(*piece, *bent) : joined(*bent, *piece);
}

Result<Stroke> TipLead::whole(const Stroke& part) const {
  if (rest_.points.empty()) return part;
  const bool start = tip_ == StrokeTip::kStart;
  StrokeData data = start ? part.data() : rest_;
  append(data, start ? rest_ : part.data(), joint_);
  return Stroke::create(std::move(data));
}

}  // namespace felt
