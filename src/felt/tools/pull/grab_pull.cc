#include "felt/tools/pull/grab_pull.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/stroke/arc_map.h"
#include "felt/tools/pull/refit.h"

namespace felt {
namespace {

/// Divides the strand on both sides of the point at arc length s0, each `away_mm` along the stroke
/// from that point.
void divide_around(Strand& strand, const ArcMap& map, double s0, double away_mm) {
  const double length = map.length_mm();
  for (const double side : {-1.0, 1.0}) {
    double s = s0 + side * away_mm;
    if (strand.closed()) s -= length * std::floor(s / length);
    if (!(s > 0.0 && s < length)) continue;
    const StrandPlace place = strand.locate(map.u_at(s));
    strand.divide(place.segment, place.t);
  }
}

}  // namespace

GrabPull::GrabPull(StrokePtr snapshot, double u0, const GrabOptions& options)
    : snapshot_(std::move(snapshot)), strand_(snapshot_), origin_(snapshot_->position(u0)) {
  u0 = std::clamp(u0, 0.0, static_cast<double>(snapshot_->segment_count()));
  if (options.affected_mm > 0.0) {
    // The segment and its two neighbours each get a third of the length.
    const ArcMap map(*snapshot_);
    const double s0 = map.length_at(u0);
    divide_around(strand_, map, s0, options.affected_mm / 6.0);
    divide_around(strand_, map, s0, options.affected_mm / 2.0);
  }
  place_ = strand_.locate(u0);
  strand_.prepare(place_.segment);
  weights_ = edit_weights(options.weights, place_.t,
                          strand_.compliance(place_.segment, place_.t, options.pins_joints));
}

bool GrabPull::moves_left() const noexcept {
  if (strand_.previous(place_.segment) < 0) return false;
  return weights_.w[0] != 0.0 || strand_.joint(place_.segment) == JointKind::kSmooth;
}

bool GrabPull::moves_right() const noexcept {
  if (strand_.next(place_.segment) < 0) return false;
  return weights_.w[3] != 0.0 || strand_.joint(place_.segment + 1) == JointKind::kSmooth;
}

int GrabPull::first_joint() const noexcept {
  return moves_left() ? strand_.previous(place_.segment) : place_.segment;
}

int GrabPull::last_joint() const noexcept {
  return (moves_right() ? strand_.next(place_.segment) : place_.segment) + 1;
}

Result<Strand> GrabPull::bent(Vec displacement) const {
  if (!std::isfinite(displacement.x) || !std::isfinite(displacement.y)) {
    return fail(ErrorCode::kInvalidArgument, "the displacement of a pull is not finite");
  }
  if (!(weights_.gain(place_.t) > 0.0)) {
    return fail(ErrorCode::kInvalidData, "the grabbed point depends on no movable control point");
  }
  Strand strand = strand_;
  // Starts at the current position of the point. It has moved by a micrometre when zero-length
  // handles got a length (R21).
  const Point from = evaluate(strand.segment(place_.segment), place_.t);
  if (!strand.bend(place_.segment, place_.t, weights_, origin_ + displacement - from)) {
    return fail(ErrorCode::kInvalidData, "the pull would reduce a segment to a point");
  }
  return strand;
}

Result<Stroke> GrabPull::at(Vec displacement) const {
  if (displacement == Vec{}) return *snapshot_;
  const Result<Strand> strand = bent(displacement);
  return strand ? strand->stroke() : tl::unexpected(strand.error());
}

Result<Stroke> GrabPull::finished(Vec displacement) const {
  if (displacement == Vec{}) return *snapshot_;
  const Result<Strand> strand = bent(displacement);
  return strand ? with_good_shapes(*strand) : tl::unexpected(strand.error());
}

}  // namespace felt
