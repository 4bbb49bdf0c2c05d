#include "felt/motion/stroke_blend.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "felt/base/constants.h"
#include "felt/motion/close_gap.h"
#include "felt/motion/common_pieces.h"
#include "felt/motion/mend_blend.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// Shorter edges have no direction of their own.
constexpr double kNoEdgeMm = 1e-9;
/// A joint that turns more than this in one of the strokes is a corner, whatever its kind.
constexpr double kSmoothRad = 1e-4;
/// fit_ends() turns and scales within these limits, if the ends are far enough apart for that.
constexpr double kMaxFitRad = 0.6, kMaxFitScale = 1.6, kMinChordShare = 0.15;

double wrapped(double angle_rad) noexcept {
  return std::remainder(angle_rad, kTau);
}

/// The three edges of the control polygon of a segment: their vectors, and directions that are also
/// defined for edges without length.
struct EdgeTriple {
  std::array<double, 3> lengths_mm{}, angles_rad{};
};

/// `before_rad` is the direction before the segment, for segments without length.
EdgeTriple edges_of(const Cubic& c, double before_rad) noexcept {
  EdgeTriple edges;
  std::array<bool, 3> has_angle{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec edge = c.p[i + 1] - c.p[i];
    edges.lengths_mm[i] = norm(edge);
    has_angle[i] = edges.lengths_mm[i] > kNoEdgeMm;
    if (has_angle[i]) edges.angles_rad[i] = std::atan2(edge.y, edge.x);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (has_angle[i]) continue;
    // A handle of length zero has the direction of the tangent: that of its neighbour.
    const std::size_t next = i == 2 ? 1 : i + 1, other = i == 0 ? 2 : 0;
    edges.angles_rad[i] = has_angle[next]    ? edges.angles_rad[next]
                          : has_angle[other] ? edges.angles_rad[other]
                                             : before_rad;
  }
  return edges;
}

/// Returns the part between two parameters of one segment; a point if they are equal.
Cubic piece_of(const Stroke& stroke, double u0, double u1) noexcept {
  const int i = std::min(static_cast<int>(u0), stroke.segment_count() - 1);
  return sub_segment(stroke.segment(i), u0 - i, std::min(u1 - i, 1.0));
}

/// Returns true if a cut at u leaves no corner.
bool is_smooth_at(const Stroke& stroke, double u) noexcept {
  const double joint = std::round(u);
  if (u != joint) return true;
  return stroke.joint(static_cast<int>(joint)) == JointKind::kSmooth;
}

/// Returns the mean of the points of a control polygon, weighted by the lengths of its edges.
Point centre_of(const BlendPose& pose) noexcept {
  Point at = pose.start;
  Vec sum{};
  double weight = 0.0;
  for (std::size_t i = 0; i < pose.lengths.size(); ++i) {
    const Vec edge = pose.lengths[i] * pose.directions[i];
    sum += pose.lengths[i] * (at + 0.5 * edge - Point{});
    weight += pose.lengths[i];
    at += edge;
  }
  return weight > 0.0 ? Point{} + sum / weight : pose.start;
}

Vec reach_of(const BlendPose& pose) noexcept {
  Vec sum{};
  for (std::size_t i = 0; i < pose.lengths.size(); ++i) {
    sum += pose.lengths[i] * pose.directions[i];
  }
  return sum;
}

/// Turns and scales a pose so that its ends come as far apart as they should.
void turn_and_scale(BlendPose& pose, Vec wanted) noexcept {
  const Vec chord = reach_of(pose);
  double length = 0.0;
  for (const double mm : pose.lengths) length += mm;
  if (norm(chord) < kMinChordShare * length || norm(wanted) < 0.5 * kMinChordShare * length) return;
  const double angle =
      std::clamp(std::atan2(cross(chord, wanted), dot(chord, wanted)), -kMaxFitRad, kMaxFitRad);
  const double scale = std::clamp(norm(wanted) / norm(chord), 1.0 / kMaxFitScale, kMaxFitScale);
  const double c = std::cos(angle), s = std::sin(angle);
  for (Vec& d : pose.directions) d = {c * d.x - s * d.y, s * d.x + c * d.y};
  for (double& mm : pose.lengths) mm *= scale;
}

double mapped(const std::vector<double>& ends, double u) noexcept {
  const auto next = std::upper_bound(ends.begin(), ends.end(), u);
  if (next == ends.begin()) return 0.0;
  if (next == ends.end()) return static_cast<double>(ends.size() - 1);
  const auto i = static_cast<std::size_t>(next - ends.begin()) - 1;
  return static_cast<double>(i) + (u - ends[i]) / (ends[i + 1] - ends[i]);
}

double mapped_back(const std::vector<double>& ends, double v) noexcept {
  const auto i = std::min(static_cast<std::size_t>(std::max(v, 0.0)), ends.size() - 2);
  const double t = std::min(v - static_cast<double>(i), 1.0);
  return (1.0 - t) * ends[i] + t * ends[i + 1];
}

}  // namespace

StrokeBlend::StrokeBlend(const Stroke& a, const Stroke& b, const Similarity& motion)
    : closed_(a.closed() && b.closed()), motion_(motion) {
  CommonPieces pieces = common_pieces(a, b);
  a_u_ = std::move(pieces.a_u);
  b_u_ = std::move(pieces.b_u);
  add_edges(a, b);
  add_knots(a, b);
  set_look(a, b);
  BlendPose pose;
  for (const Edge& e : edges_) {
    pose.lengths.push_back(e.a_mm);
    pose.directions.push_back({std::cos(e.angle_rad), std::sin(e.angle_rad)});
  }
  pose.start = a.data().points.front();
  a_centre_ = centre_of(pose);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const double angle = edges_[i].angle_rad + edges_[i].turn_rad;
    pose.lengths[i] = edges_[i].b_mm * motion.scale;
    pose.directions[i] = {std::cos(angle), std::sin(angle)};
  }
  pose.start = b.data().points.front();
  b_centre_ = centre_of(pose);
}

void StrokeBlend::add_edges(const Stroke& a, const Stroke& b) {
  std::vector<bool> is_smooth;  // at the start of each piece
  double a_before = 0.0, b_before = 0.0;
  for (std::size_t k = 0; k + 1 < a_u_.size(); ++k) {
    const EdgeTriple ea = edges_of(piece_of(a, a_u_[k], a_u_[k + 1]), a_before);
    const EdgeTriple eb = edges_of(piece_of(b, b_u_[k], b_u_[k + 1]), b_before);
    is_smooth.push_back(is_smooth_at(a, a_u_[k]) && is_smooth_at(b, b_u_[k]));
    for (std::size_t i = 0; i < 3; ++i) {
      edges_.push_back({ea.lengths_mm[i], eb.lengths_mm[i] / motion_.scale, ea.angles_rad[i],
                        eb.angles_rad[i] - ea.angles_rad[i]});
    }
    a_before = ea.angles_rad[2];
    b_before = eb.angles_rad[2];
  }
  unwrap(is_smooth);
}

void StrokeBlend::unwrap(const std::vector<bool>& is_smooth) {
  // The turn of each edge, without jumps from edge to edge.
  double before = motion_.angle_rad, sum = 0.0, weights = 0.0;
  for (Edge& e : edges_) {
    e.turn_rad = before + wrapped(e.turn_rad - before);
    before = e.turn_rad;
    sum += (e.a_mm + e.b_mm) * e.turn_rad;
    weights += e.a_mm + e.b_mm;
  }
  // The stroke as a whole turns as little as possible relative to the drawing.
  double mean = weights > 0.0 ? sum / weights : 0.0;
  const double shift = kTau * std::round((motion_.angle_rad - mean) / kTau);
  mean += shift;
  double spread = 0.0, wrapped_spread = 0.0, c = 0.0, s = 0.0;
  for (Edge& e : edges_) {
    e.turn_rad += shift;
    c += (e.a_mm + e.b_mm) * std::cos(e.turn_rad);
    s += (e.a_mm + e.b_mm) * std::sin(e.turn_rad);
  }
  const double middle = mean + wrapped(std::atan2(s, c) - mean);
  for (const Edge& e : edges_) {
    spread += (e.a_mm + e.b_mm) * std::fabs(e.turn_rad - mean);
    wrapped_spread += (e.a_mm + e.b_mm) * std::fabs(wrapped(e.turn_rad - middle));
  }
  // A small loop in one stroke only would turn the rest of it by a full turn. If both strokes have
  // much the same directions without such turns, they are left out.
  const bool has_loops = wrapped_spread < 0.8 * weights && spread > 2.0 * wrapped_spread + weights;
  const double base = motion_.angle_rad + wrapped(middle - motion_.angle_rad);
  for (Edge& e : edges_) {
    if (has_loops) e.turn_rad = base + wrapped(e.turn_rad - base);
  }
  const std::size_t pieces = is_smooth.size();
  for (std::size_t k = 0; k < pieces; ++k) {
    if (k == 0 && !closed_) continue;
    const Edge& in = edges_[3 * (k == 0 ? pieces : k) - 1];
    Edge& out = edges_[3 * k];
    const double a_turn = wrapped(out.angle_rad - in.angle_rad), turn = out.turn_rad - in.turn_rad;
    const double b_turn = turn + a_turn;  // at the seam, both may have turned round k times
    const bool smooth =
        is_smooth[k] && std::fabs(a_turn) < kSmoothRad && std::fabs(b_turn) < kSmoothRad;
    if (smooth) {
      out.angle_rad = in.angle_rad;
      out.turn_rad = in.turn_rad;
    }
    joints_.push_back(smooth ? JointKind::kSmooth : JointKind::kCorner);
  }
  // The kind of the seam is the last one.
  if (closed_) std::rotate(joints_.begin(), joints_.begin() + 1, joints_.end());
}

void StrokeBlend::add_knots(const Stroke& a, const Stroke& b) {
  const auto add = [&](double v, double a_u, double b_u) {
    knots_.push_back({v, knot_at(a.widths(), a_u), knot_at(b.widths(), b_u)});
  };
  for (const WidthKnot& k : a.widths()) {
    const double v = mapped(a_u_, k.u);
    add(v, k.u, mapped_back(b_u_, v));
    knots_.back().a = k;
  }
  for (const WidthKnot& k : b.widths()) {
    const double v = mapped(b_u_, k.u);
    add(v, mapped_back(a_u_, v), k.u);
    knots_.back().b = k;
  }
  const double end = static_cast<double>(a_u_.size() - 1);
  std::stable_sort(knots_.begin(), knots_.end(),
                   [](const Knot& x, const Knot& y) { return x.v < y.v; });
  knots_.front().v = 0.0;
  knots_.back().v = end;
  std::vector<Knot> kept{knots_.front()};
  for (std::size_t i = 1; i + 1 < knots_.size(); ++i) {
    const bool is_new = knots_[i].v > kept.back().v && knots_[i].v < end;
    if (is_new) kept.push_back(knots_[i]);
  }
  kept.push_back(knots_.back());
  knots_ = std::move(kept);
}

void StrokeBlend::set_look(const Stroke& a, const Stroke& b) {
  a_medium_ = a.medium();
  b_medium_ = b.medium();
  a_color_ = a.color();
  b_color_ = b.color();
}

void StrokeBlend::pose(double t, BlendPose& pose) const {
  pose.lengths.resize(edges_.size());
  pose.directions.resize(edges_.size());
  const double scale = std::pow(motion_.scale, t);
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    const Edge& e = edges_[i];
    const double angle = e.angle_rad + t * e.turn_rad;
    pose.lengths[i] = scale * ((1.0 - t) * e.a_mm + t * e.b_mm);
    pose.directions[i] = {std::cos(angle), std::sin(angle)};
  }
  if (closed_) close_gap(pose.lengths, pose.directions, -reach_of(pose));
  pose.start = {};
  pose.start += carried(motion_, a_centre_, b_centre_, t) - centre_of(pose);
  pose.end = closed_ ? pose.start : pose.start + reach_of(pose);
}

void StrokeBlend::fit_ends(BlendPose& pose, std::optional<Point> start, std::optional<Point> end) {
  if (!start && !end) return;
  if (start && end) {
    turn_and_scale(pose, *end - *start);
    const Vec wanted = *end - *start;
    close_gap(pose.lengths, pose.directions, wanted - reach_of(pose));
    const Vec reach = reach_of(pose), left = wanted - reach;
    pose.start = *start + 0.5 * left;
    pose.end = norm(left) < 1e-9 ? *end : pose.start + reach;
    return;
  }
  const Vec shift = start ? *start - pose.start : *end - pose.end;
  pose.start += shift;
  pose.end += shift;
}

Result<Stroke> StrokeBlend::stroke(double t, const BlendPose& pose) const {
  StrokeData data;
  data.closed = closed_;
  data.joints = joints_;
  data.points.reserve(pose.lengths.size() + 1);
  Point at = pose.start;
  data.points.push_back(at);
  const std::size_t pieces = pose.lengths.size() / 3;
  for (std::size_t k = 0; k < pieces; ++k) {
    const auto edge = [&](std::size_t i) {
      return pose.lengths[3 * k + i] * pose.directions[3 * k + i];
    };
    const bool is_last = k + 1 == pieces;
    const Point next = is_last ? pose.end : at + edge(0) + edge(1) + edge(2);
    data.points.push_back(at + edge(0));
    data.points.push_back(next - edge(2));
    data.points.push_back(next);
    at = next;
  }
  data.widths.reserve(knots_.size());
  for (const Knot& k : knots_) {
    data.widths.push_back({k.v, (1.0 - t) * k.a.width_mm + t * k.b.width_mm,
                           std::clamp((1.0 - t) * k.a.tone + t * k.b.tone, 0.0, 1.0)});
  }
  data.medium = t < 0.5 ? a_medium_ : b_medium_;
  data.color = blended(a_color_, b_color_, t);
  return mended_blend(std::move(data));
}

double StrokeBlend::parameter_of_a(double u) const noexcept {
  return mapped(a_u_, u);
}

double StrokeBlend::parameter_of_b(double u) const noexcept {
  return mapped(b_u_, u);
}

Point StrokeBlend::position(const BlendPose& pose, double v) noexcept {
  const std::size_t pieces = pose.lengths.size() / 3;
  const auto k = std::min(static_cast<std::size_t>(std::max(v, 0.0)), pieces - 1);
  Point at = pose.start;
  for (std::size_t i = 0; i < 3 * k; ++i) at += pose.lengths[i] * pose.directions[i];
  Cubic c{{at, at, at, at}};
  for (std::size_t i = 0; i < 3; ++i) {
    c.p[i + 1] = c.p[i] + pose.lengths[3 * k + i] * pose.directions[3 * k + i];
  }
  return evaluate(c, v - static_cast<double>(k));
}

Rgba blended(Rgba a, Rgba b, double t) noexcept {
  const double a_weight = (1.0 - t) * a.a, b_weight = t * b.a, sum = a_weight + b_weight;
  const auto channel = [&](std::uint8_t x, std::uint8_t y) {
    const double value = sum > 0.0 ? (a_weight * x + b_weight * y) / sum : (1.0 - t) * x + t * y;
    return static_cast<std::uint8_t>(std::lround(value));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b),
          static_cast<std::uint8_t>(std::lround(sum))};
}

}  // namespace felt
