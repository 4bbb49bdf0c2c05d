#include "felt/stroke/outline/side_stretch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "felt/geometry/cubic.h"

namespace felt {
namespace {

// How it works: each piece is sampled at kSamples points of its edge.
//  1. If all samples are on a smooth edge and one cubic fits them, the cubic is collected. Later,
//     flush_curves replaces as many neighbouring curves as possible by one.
//  2. If the bend is tighter than the radius everywhere, the edge follows the centres of the bend
//     with straight lines.
//  3. Otherwise the piece is halved. If repeated halving does not help, strips along the flattened
//     centre line replace it.

/// Fits one cubic to points along a smooth edge.
///
/// Use: clear(); add() for each point in order; fit(). Keeps its buffers.
class EdgeFit {
 public:
  void clear() noexcept { points_.clear(); }
  void add(Point p) {
    if (points_.empty() || p != points_.back()) points_.push_back(p);
  }

  /// Fits the cubic from the first to the last point that starts along `begin` and ends along
  /// `end`, both unit vectors. Returns false if a point would be out of tolerance.
  bool fit(Vec begin, Vec end, double tolerance_mm, Cubic& c);

 private:
  bool fit_handles(Vec d0, Vec d1, Cubic& c) const noexcept;
  double move_parameters(const Cubic& c) noexcept;

  std::vector<Point> points_;
  std::vector<double> t_;
};

/// Maximum number of rounds of fitting the curve and moving the parameters of the points along it.
constexpr int kRounds = 4;
/// Maximum error, in multiples of the tolerance, at which a fit is continued.
constexpr double kHopelessStretch = 8.0;
/// The share of the tolerance allowed at the points, because the error is a little larger between
/// them.
constexpr double kShareAtPoints = 0.8;

/// Finds the handle lengths of the cubic between the end points by least squares of the distances
/// to the points at their parameters. Returns false if the result is not sensible. Uses the normal
/// equations of Schneider, "An algorithm for automatically fitting digitized curves", 1990.
bool EdgeFit::fit_handles(Vec d0, Vec d1, Cubic& c) const noexcept {
  const Point p0 = points_.front(), p3 = points_.back();
  double c00 = 0, c01 = 0, c11 = 0, x0 = 0, x1 = 0;
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    const double u = t_[i], w = 1.0 - u;
    const double b1 = 3 * w * w * u, b2 = 3 * w * u * u;
    const Vec base = lerp(p0, p3, u * u * (3 - 2 * u)) - points_[i];
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

/// Moves each parameter towards the nearest point of the curve by Newton's method. Returns the
/// largest squared distance of a point from the curve at its parameter.
double EdgeFit::move_parameters(const Cubic& c) noexcept {
  constexpr int kSteps = 2;
  // Powers of t are evaluated three times as fast as Bernstein polynomials.
  const Vec c1 = 3.0 * (c.p[1] - c.p[0]);
  const Vec c2 = 3.0 * ((c.p[2] - c.p[1]) - (c.p[1] - c.p[0]));
  const Vec c3 = (c.p[3] - c.p[0]) - c1 - c2;
  double worst = 0.0;
  for (std::size_t i = 1; i + 1 < points_.size(); ++i) {
    const Vec start = c.p[0] - points_[i];
    const auto off_at = [&](double t) { return start + t * (c1 + t * (c2 + t * c3)); };
    double t = t_[i];
    Vec off = off_at(t);
    for (int step = 0; step < kSteps; ++step) {
      const Vec v = c1 + t * (2.0 * c2 + 3.0 * t * c3);
      const double curve = norm_squared(v) + dot(off, 2.0 * c2 + 6.0 * t * c3);
      if (curve > 0.0) t = std::clamp(t - dot(off, v) / curve, 0.0, 1.0);
      off = off_at(t);
    }
    t_[i] = t;
    worst = std::max(worst, norm_squared(off));
  }
  return worst;
}

bool EdgeFit::fit(Vec begin, Vec end, double tolerance_mm, Cubic& c) {
  if (points_.size() < 2) return false;
  t_.assign(points_.size(), 0.0);
  for (std::size_t i = 1; i < points_.size(); ++i) {
    t_[i] = t_[i - 1] + distance(points_[i - 1], points_[i]);
  }
  const double length = t_.back();
  if (!(length > 0.0)) return false;
  for (double& t : t_) t /= length;
  const double limit = kShareAtPoints * tolerance_mm;
  for (int round = 0; round < kRounds; ++round) {
    if (!fit_handles(begin, -end, c)) return false;
    const double worst = move_parameters(c);
    if (worst <= limit * limit) return true;
    if (!(worst <= kHopelessStretch * kHopelessStretch * tolerance_mm * tolerance_mm)) return false;
  }
  return false;
}

/// Maximum number of halvings of a piece if its edge is only partly smooth.
constexpr int kMaxHalvings = 6;
/// The number of samples of an edge, including its ends.
constexpr std::size_t kSamples = 9;
/// The cosine of the largest angle between neighbouring samples; a larger angle may hide a cusp.
constexpr double kSlowTurn = 0.5;
/// The cosine of the largest kink, and the largest gap in multiples of the tolerance, across which
/// two curves of the edge may be merged.
constexpr double kSmallKink = 0.97, kSmallGap = 2.0;
/// The tolerance of the lines inside tight bends, as a share of the whole tolerance.
constexpr double kInsideShare = 0.4;

/// A point of the left edge, and its point on the centre line.
struct EdgePoint {
  Dab dab;
  EnvelopeFrame frame;
  Point place;  ///< `share` of the radius away from the centre line
  /// 1 on the true edge. Less if the bend is tighter than the radius, so that the edge would run
  /// backwards: `place` is then the centre of the bend.
  double share = 1.0;
  /// False if the piece has no edge, because the centre line stands still or the radius grows
  /// faster than the arc length.
  bool is_regular = false;
};

/// Larger derivatives than this are no rounding errors of coordinates (tangent()).
constexpr double kMovingMm = 1e-3;

EdgePoint edge_at(const InkPiece& piece, double t) noexcept {
  const Vec v = derivative(piece.center, t), a = second_derivative(piece.center, t);
  const double v2 = norm_squared(v), ds = std::sqrt(v2);
  const double dr = piece.radius_derivative(t), r = piece.radius(t);
  EdgePoint e;
  e.dab = {evaluate(piece.center, t), r};
  // Far from a standstill, the derivative has the direction, and tangent() need not look for it.
  const bool moves = t > 0.0 && t < 1.0 && v2 > kMovingMm * kMovingMm;
  e.frame = EnvelopeFrame::of(moves ? v / ds : tangent(piece.center, t), dr, ds);
  // The normal is at the angle acos(-slope) from the tangent and turns with both. As t grows, the
  // point at the fraction s of the normal moves forward by `onward` - s * `backward`.
  e.is_regular = e.frame.height > 0.0 && ds > 0.0;
  if (e.is_regular) {
    const double turning = cross(v, a) / v2;
    const double leaning =
        (piece.bend_mm.second_derivative(t) - dr * dot(v, a) / v2) / (ds * e.frame.height);
    const double onward = ds * e.frame.height, backward = r * (turning + leaning);
    if (backward >= onward) e.share = onward / backward;
  }
  e.place = e.dab.center + (e.share * r) * e.frame.normal();
  return e;
}

/// Returns the number of lines that keep within the tolerance of a part of a piece.
int lines_of(const InkPiece& piece, double t0, double t1, double tolerance_mm) noexcept {
  const double bends = std::ceil((t1 - t0) * piece.bend_mm.steps(tolerance_mm, 1));
  return std::max(flatten_steps(piece.center, t1 - t0, tolerance_mm), static_cast<int>(bends));
}

using Samples = std::array<EdgePoint, kSamples>;

bool turns_slowly(const EdgePoint& a, const EdgePoint& b) noexcept {
  return dot(a.frame.tangent, b.frame.tangent) >= kSlowTurn &&
         dot(a.frame.normal(), b.frame.normal()) >= kSlowTurn;
}

/// Returns true if the strip between two points is a simple quadrilateral. If their normals cross,
/// the bend is tightest in between, and a part of the strip would have the wrong orientation.
bool is_simple(const EdgePoint& a, const EdgePoint& b) noexcept {
  const Vec between = b.dab.center - a.dab.center;
  const Vec p = a.place - a.dab.center, q = b.place - b.dab.center;
  const double turn = cross(p, q);
  if (turn == 0.0) return true;
  // Solves a.center + s p = b.center + t q.
  const double s = cross(between, q) / turn, t = cross(between, p) / turn;
  return s <= 0.0 || s >= 1.0 || t <= 0.0 || t >= 1.0;
}

class LeftEdge {
 public:
  LeftEdge(double tolerance_mm, std::vector<SideStretch>& out)
      : tolerance_mm_(tolerance_mm), out_(out) {}

  void append(const InkPiece& piece) { append(piece, 0.0, 1.0, kMaxHalvings); }

  /// Appends everything that is still collected. Call it at the end.
  void finish() {
    flush_curves();
    flush_inside();
  }

 private:
  /// Curve k belongs to the kSamples samples of `curve_samples_` that start at k * kSamples.
  struct Curve {
    Cubic cubic;
  };

  void append(const InkPiece& piece, double t0, double t1, int halvings) {
    Samples samples;
    std::size_t regular = 0, on_edge = 0;
    bool slow = true, lines = true;
    for (std::size_t i = 0; i < kSamples; ++i) {
      EdgePoint& e = samples[i];
      e = edge_at(piece, t0 + (t1 - t0) * static_cast<double>(i) / (kSamples - 1));
      regular += e.is_regular ? 1 : 0;
      on_edge += e.is_regular && e.share == 1.0 ? 1 : 0;
      slow = slow && (i == 0 || turns_slowly(samples[i - 1], e));
      lines = lines && (i == 0 || lines_will_do(samples[i - 1], e));
    }
    Cubic c;
    if (on_edge == kSamples && slow && fit(samples, c)) return add_curve(samples, c);
    const bool last = halvings == 0 || lines_of(piece, t0, t1, tolerance_mm_) == 1;
    const bool is_inside = on_edge == 0 || last;
    if (regular == kSamples && slow && lines && is_inside) return add_inside(samples);
    if (regular == 0 || last) return append_lines(piece, t0, t1);
    const double middle = 0.5 * (t0 + t1);
    append(piece, t0, middle, halvings - 1);
    append(piece, middle, t1, halvings - 1);
  }

  /// Fits one cubic to the samples of one or more neighbours. If there are several neighbours,
  /// every second or fourth sample is enough, because each neighbour is smooth.
  bool fit(std::span<const EdgePoint> samples, Cubic& c) {
    const std::size_t count = samples.size() / kSamples;
    if (count > 1 && dot(samples.front().frame.normal(), samples.back().frame.normal()) < 0.0) {
      return false;
    }
    const std::size_t step = count == 1 ? 1 : count < 4 ? 2 : 4;
    fit_.clear();
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (i % kSamples % step == 0) fit_.add(samples[i].place);
    }
    // The edge is at a right angle to its normal.
    return fit_.fit(-perp(samples.front().frame.normal()), -perp(samples.back().frame.normal()),
                    tolerance_mm_, c);
  }

  // --- Curves

  /// Returns true if a line from sample `a` to the next one, `b`, may replace the edge. If `a` or
  /// `b` is on the true edge, the edge may bulge between them, by r (1 - cos(turn / 2)).
  [[nodiscard]] bool lines_will_do(const EdgePoint& a, const EdgePoint& b) const noexcept {
    if (!is_simple(a, b)) return false;
    if (a.share < 1.0 && b.share < 1.0) return true;
    return a.dab.radius_mm * norm_squared(b.frame.normal() - a.frame.normal()) <=
           4.0 * tolerance_mm_;
  }

  /// Returns true if one curve may continue from `a`, the end of a curve, to `b`, the start of its
  /// neighbour.
  [[nodiscard]] bool runs_on(const EdgePoint& a, const EdgePoint& b) const noexcept {
    return distance(a.place, b.place) <= kSmallGap * tolerance_mm_ &&
           dot(a.frame.normal(), b.frame.normal()) > kSmallKink;
  }

  void add_curve(const Samples& samples, const Cubic& c) {
    flush_inside();
    if (!curves_.empty() && !runs_on(curve_samples_.back(), samples.front())) flush_curves();
    curves_.push_back({c});
    curve_samples_.insert(curve_samples_.end(), samples.begin(), samples.end());
  }

  [[nodiscard]] std::span<const EdgePoint> samples_of(std::size_t first, std::size_t last) const {
    return std::span(curve_samples_).subspan(first * kSamples, (last - first) * kSamples);
  }

  /// Replaces neighbours by one curve while that stays within the tolerance. Finds the longest run
  /// by doubling, then by bisection.
  void flush_curves() {
    for (std::size_t first = 0; first < curves_.size();) {
      Cubic best = curves_[first].cubic, longer;
      std::size_t good = first + 1, bad = curves_.size() + 1;
      for (std::size_t step = 1; good < curves_.size() && bad > good + 1;) {
        const std::size_t next =
            bad <= curves_.size() ? good + (bad - good) / 2 : std::min(good + step, curves_.size());
        if (fit(samples_of(first, next), longer)) {
          best = longer;
          good = next;
          step *= 2;
        } else {
          bad = next;
        }
      }
      emit_curve(samples_of(first, good), best);
      first = good;
    }
    curves_.clear();
    curve_samples_.clear();
  }

  void emit_curve(std::span<const EdgePoint> s, const Cubic& c) {
    const EdgePoint& a = s.front();
    const EdgePoint& b = s.back();
    out_.push_back({.from = a.dab,
                    .to = b.dab,
                    .begin = a.frame,
                    .end = b.frame,
                    .begin_length_mm = distance(a.dab.center, s[kSamples - 1].dab.center),
                    .end_length_mm = distance(s[s.size() - kSamples].dab.center, b.dab.center),
                    .start = a.place,
                    .finish = b.place,
                    .curved = true,
                    .handle0 = c.p[1],
                    .handle1 = c.p[2]});
  }

  // --- Inside of tight bends

  void add_inside(const Samples& samples) {
    flush_curves();
    if (!inside_.empty() && !(inside_.back().dab == samples.front().dab &&
                              inside_.back().frame.normal() == samples.front().frame.normal())) {
      flush_inside();
    }
    inside_.insert(inside_.end(), samples.begin() + (inside_.empty() ? 0 : 1), samples.end());
  }

  /// Returns true if a line from sample `a` to sample `b` may replace all samples between them.
  [[nodiscard]] bool may_skip(std::size_t a, std::size_t b) const noexcept {
    const Point p = inside_[a].place, q = inside_[b].place;
    if (dot(inside_[a].frame.normal(), inside_[b].frame.normal()) < 0.0) return false;
    if (!is_simple(inside_[a], inside_[b])) return false;
    const Vec way = q - p;
    const double length = norm(way), near = kInsideShare * tolerance_mm_;
    for (std::size_t k = a + 1; k < b; ++k) {
      const Vec to = inside_[k].place - p;
      if (length <= near ? norm(to) > near : std::fabs(cross(way, to)) > near * length)
        return false;
      if (length > near && (dot(way, to) < 0.0 || dot(way, to) > length * length)) return false;
    }
    return true;
  }

  void flush_inside() {
    for (std::size_t a = 0; a + 1 < inside_.size();) {
      std::size_t b = a + 1;
      while (b + 1 < inside_.size() && may_skip(a, b + 1)) ++b;
      emit_line(inside_[a], inside_[b]);
      a = b;
    }
    inside_.clear();
  }

  void emit_line(const EdgePoint& a, const EdgePoint& b) {
    const double length = distance(a.dab.center, b.dab.center);
    out_.push_back({.from = a.dab,
                    .to = b.dab,
                    .begin = a.frame,
                    .end = b.frame,
                    .begin_length_mm = length,
                    .end_length_mm = length,
                    .start = a.place,
                    .finish = b.place,
                    .starts_inside = a.share < 1.0,
                    .finishes_inside = b.share < 1.0});
  }

  // --- Strips along the flattened centre line, if there is no edge

  void append_lines(const InkPiece& piece, double t0, double t1) {
    finish();
    const auto dab = [&](double t) { return Dab{evaluate(piece.center, t), piece.radius(t)}; };
    const int steps = lines_of(piece, t0, t1, 0.5 * tolerance_mm_);
    EdgePoint from, to;
    from.dab = dab(t0);
    for (int i = 1; i <= steps; ++i) {
      to.dab = dab(t0 + (t1 - t0) * i / steps);
      const Vec way = to.dab.center - from.dab.center;
      const double length = norm(way), dr = to.dab.radius_mm - from.dab.radius_mm;
      if (length > 0.0 || dr != 0.0) {
        from.frame = to.frame =
            EnvelopeFrame::of(length > 0.0 ? normalized(way) : piece.heading, dr, length);
        for (EdgePoint* e : {&from, &to}) {
          e->place = e->dab.center + e->dab.radius_mm * e->frame.normal();
        }
        emit_line(from, to);
      }
      from.dab = to.dab;
    }
  }

  double tolerance_mm_;
  std::vector<SideStretch>& out_;
  EdgeFit fit_;
  std::vector<Curve> curves_;
  std::vector<EdgePoint> curve_samples_, inside_;
};

}  // namespace

void append_left_edge(std::span<const InkPiece> pieces, double tolerance_mm,
                      std::vector<SideStretch>& out) {
  LeftEdge edge(tolerance_mm, out);
  for (const InkPiece& piece : pieces) edge.append(piece);
  edge.finish();
}

}  // namespace felt
