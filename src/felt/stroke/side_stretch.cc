#include "felt/stroke/side_stretch.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "felt/geometry/nearest.h"

namespace felt {
namespace {

/// Halvings of a piece on which the edge is smooth in parts only.
constexpr int kMaxHalvings = 6;
/// Places at which an edge is looked at, ends included.
constexpr int kSamples = 9;
/// Rounds of moving the parameters of the samples along the fitted curve and fitting again.
constexpr int kRounds = 3;

/// A place on the left edge.
struct EdgePoint {
  EnvelopeFrame frame;
  Point place;
  /// How fast the edge moves on per parameter; 0 or less where it runs backwards because the bend
  /// is tighter than the radius.
  double speed = 0.0;
};

EdgePoint edge_at(const InkPiece& piece, double t) noexcept {
  const Vec v = derivative(piece.center, t), a = second_derivative(piece.center, t);
  const double v2 = norm_squared(v), ds = std::sqrt(v2);
  const double dr = piece.radius1_mm - piece.radius0_mm, r = piece.radius(t);
  EdgePoint e;
  e.frame = EnvelopeFrame::of(tangent(piece.center, t), dr, ds);
  e.place = evaluate(piece.center, t) + r * e.frame.normal();
  // The normal lies at the angle acos(-slope) from the tangent and turns with both.
  if (e.frame.height > 0.0 && ds > 0.0) {
    const double turning = cross(v, a) / v2;
    const double leaning = -dr * dot(v, a) / (v2 * ds) / e.frame.height;
    e.speed = ds * e.frame.height - r * (turning + leaning);
  }
  return e;
}

/// Direction in which the left edge runs at a place with this normal.
Vec along(const EnvelopeFrame& frame) noexcept {
  return -perp(frame.normal());
}

using Samples = std::array<EdgePoint, kSamples>;

/// Handle lengths of the cubic between the end samples that leaves least squares of distance to
/// the samples at the given parameters; false when there is no sensible answer. The normal
/// equations of Schneider, "An algorithm for automatically fitting digitized curves", 1990.
bool fit_handles(const Samples& s, const std::array<double, kSamples>& t, Cubic& c) noexcept {
  const Point p0 = s.front().place, p3 = s.back().place;
  const Vec d0 = along(s.front().frame), d1 = -along(s.back().frame);
  double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0;
  for (std::size_t i = 1; i + 1 < kSamples; ++i) {
    const double u = t[i], w = 1.0 - u;
    const double b1 = 3 * w * w * u, b2 = 3 * w * u * u;
    const Vec base = lerp(p0, p3, u * u * (3 - 2 * u)) - s[i].place;
    c00 += b1 * b1;
    c01 += b1 * b2 * dot(d0, d1);
    c11 += b2 * b2;
    x0 -= b1 * dot(d0, base);
    x1 -= b2 * dot(d1, base);
  }
  const double det = c00 * c11 - c01 * c01;
  const double chord = distance(p0, p3);
  double h0 = chord / 3, h1 = chord / 3;
  if (det > 1e-9 * c00 * c11) {
    h0 = (x0 * c11 - x1 * c01) / det;
    h1 = (x1 * c00 - x0 * c01) / det;
  }
  c = Cubic{{p0, p0 + h0 * d0, p3 + h1 * d1, p3}};
  return h0 > 0.0 && h1 > 0.0 && h0 + h1 < 3.0 * chord;
}

/// Fits one cubic to the edge; false when it would leave the tolerance at a sample.
bool fit_edge(const Samples& s, double tolerance_mm, Cubic& c) noexcept {
  std::array<double, kSamples> t;
  for (std::size_t i = 0; i < kSamples; ++i) t[i] = static_cast<double>(i) / (kSamples - 1);
  for (int round = 0; round < kRounds; ++round) {
    if (!fit_handles(s, t, c)) return false;
    double worst = 0.0;
    for (std::size_t i = 1; i + 1 < kSamples; ++i) {
      const Nearest n = nearest(c, s[i].place);
      worst = std::max(worst, n.distance_squared);
      t[i] = n.t;
    }
    // Between the samples a cubic strays little more than at them.
    if (worst <= 0.64 * tolerance_mm * tolerance_mm) return true;
  }
  return false;
}

/// False when the edge may hide a cusp between two samples.
bool turns_slowly(const Samples& s) noexcept {
  for (std::size_t i = 1; i < kSamples; ++i) {
    if (dot(s[i - 1].frame.tangent, s[i].frame.tangent) < 0.5) return false;
    if (dot(s[i - 1].frame.normal(), s[i].frame.normal()) < 0.5) return false;
  }
  return true;
}

class LeftEdge {
 public:
  LeftEdge(const InkPiece& piece, double tolerance_mm, std::vector<SideStretch>& out)
      : piece_(piece), tolerance_mm_(tolerance_mm), out_(out) {}

  void append(double t0, double t1, int halvings) {
    Samples samples;
    int smooth = 0;
    for (int i = 0; i < kSamples; ++i) {
      EdgePoint& e = samples[static_cast<std::size_t>(i)];
      e = edge_at(piece_, t0 + (t1 - t0) * i / (kSamples - 1));
      smooth += e.speed > 0.0 ? 1 : 0;
    }
    Cubic c;
    if (smooth == kSamples && turns_slowly(samples) && fit_edge(samples, tolerance_mm_, c)) {
      append_curve(samples, t0, t1, c);
    } else if (smooth == 0 || halvings == 0 ||
               flatten_steps(piece_.center, t1 - t0, tolerance_mm_) == 1) {
      append_lines(t0, t1);
    } else {
      const double middle = 0.5 * (t0 + t1);
      append(t0, middle, halvings - 1);
      append(middle, t1, halvings - 1);
    }
  }

 private:
  [[nodiscard]] Dab dab(double t) const noexcept {
    return {evaluate(piece_.center, t), piece_.radius(t)};
  }

  void append_curve(const Samples& s, double t0, double t1, const Cubic& c) {
    const Dab from = dab(t0), to = dab(t1);
    out_.push_back({from, to, s.front().frame, s.back().frame, distance(from.center, to.center),
                    true, c.p[1], c.p[2]});
  }

  void append_lines(double t0, double t1) {
    const int steps = flatten_steps(piece_.center, t1 - t0, tolerance_mm_);
    Dab from = dab(t0);
    for (int i = 1; i <= steps; ++i) {
      const Dab to = dab(t0 + (t1 - t0) * i / steps);
      const Vec way = to.center - from.center;
      const double length = norm(way), dr = to.radius_mm - from.radius_mm;
      const Vec heading = length > 0.0 ? normalized(way) : piece_.heading;
      if (length > 0.0 || dr != 0.0) {
        const auto frame = EnvelopeFrame::of(heading, dr, length);
        out_.push_back({from, to, frame, frame, length, false, {}, {}});
      }
      from = to;
    }
  }

  const InkPiece& piece_;
  double tolerance_mm_;
  std::vector<SideStretch>& out_;
};

}  // namespace

void append_left_edge(const InkPiece& piece, double tolerance_mm, std::vector<SideStretch>& out) {
  LeftEdge(piece, tolerance_mm, out).append(0.0, 1.0, kMaxHalvings);
}

}  // namespace felt
