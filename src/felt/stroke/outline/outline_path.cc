#include "felt/stroke/outline/outline_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/stroke/drawn_profile.h"
#include "felt/stroke/outline/side_stretch.h"

namespace felt {
namespace {

/// Turns that move the edge by less than this are considered rounding errors.
constexpr double kNoticeableMm = 1e-6;

/// Returns the stroke cut at joints and width breakpoints.
std::vector<InkPiece> pieces_of(const Stroke& stroke) {
  std::vector<InkPiece> pieces;
  DrawnProfile profile(stroke);
  while (const DrawnPiece* piece = profile.next()) {
    const Cubic c = stroke.segment(piece->segment);
    pieces.push_back({sub_segment(c, piece->t0, piece->t1),
                      0.5 * stroke.width_mm(piece->segment + piece->t0),
                      0.5 * stroke.width_mm(piece->segment + piece->t1), tangent(c, piece->t0),
                      piece->radius_mm});
  }
  return pieces;
}

/// If the width of a closed stroke steps at the seam, appends a stretch of length 0 between the two
/// dabs. Its direction does not matter, but both sides must use the same one: the direction in
/// which the stroke ends.
void append_seam(std::vector<SideStretch>& side, int direction) {
  const Dab from = side.back().to, to = side.front().from;
  if (from.radius_mm == to.radius_mm) return;
  const Vec heading = direction > 0 ? side.back().end.tangent : side.front().begin.tangent;
  const auto frame = EnvelopeFrame::of(heading, to.radius_mm - from.radius_mm, 0.0);
  side.push_back({.from = from,
                  .to = to,
                  .begin = frame,
                  .end = frame,
                  .start = from.center + from.radius_mm * frame.normal(),
                  .finish = to.center + to.radius_mm * frame.normal()});
}

class PathBuilder {
 public:
  PathBuilder(double tolerance_mm, OutlinePath& path) : tolerance_mm_(tolerance_mm), path_(path) {}

  /// Appends one side. The side of an open stroke ends with a round cap.
  void side(const std::vector<SideStretch>& side, bool closed, int direction) {
    for (std::size_t i = 0; i < side.size(); ++i) {
      const SideStretch& now = side[i];
      if (i > 0 || closed) turn(i > 0 ? side[i - 1] : side.back(), now, direction);
      begin(now.start);
      if (now.curved) {
        cubic(now.handle0, now.handle1, now.finish);
      } else {
        line(now.finish);
      }
    }
    if (closed) return;
    const SideStretch& last = side.back();
    if (last.finishes_inside) line(last.to.center + last.to.radius_mm * last.end.normal());
    arc(last.to, last.end.normal(), -2.0 * last.end.normal_angle());
  }

  void close() {
    path_.verbs.push_back(OutlinePath::Verb::kClose);
    open_ = false;
  }

 private:
  /// Starts a contour at p. Does nothing if one is open, because its last point is then p.
  void begin(Point p) {
    if (open_) return;
    path_.verbs.push_back(OutlinePath::Verb::kMove);
    path_.points.push_back(p);
    open_ = true;
  }

  void line(Point p) {
    path_.verbs.push_back(OutlinePath::Verb::kLine);
    path_.points.push_back(p);
  }

  void cubic(Point h0, Point h1, Point end) {
    path_.verbs.push_back(OutlinePath::Verb::kCubic);
    path_.points.insert(path_.points.end(), {h0, h1, end});
  }

  /// Appends the connection from the end of a stretch to the start of the next one, around the dab
  /// between them. Lines along a normal, from the edge to the inside of a bend, enclose no area.
  void turn(const SideStretch& from, const SideStretch& to, int direction) {
    const Dab& dab = to.from;
    const Turn turn = turn_between({from.end, from.end_length_mm}, {to.begin, to.begin_length_mm},
                                   dab.radius_mm, direction);
    const Vec n = from.end.normal(), m = to.begin.normal();
    const bool is_inside = from.finishes_inside || to.starts_inside;
    if (turn.sweep > -std::numbers::pi && dab.radius_mm * norm(m - n) < kNoticeableMm) {
      if (!is_inside || distance(from.finish, to.start) < kNoticeableMm) return;
      begin(from.finish);
      return line(to.start);
    }
    begin(from.finish);
    if (turn.kind == Turn::Kind::kArc) {
      if (from.finishes_inside) line(dab.center + dab.radius_mm * n);
      arc(dab, n, turn.sweep);
      if (to.starts_inside) line(to.start);
      return;
    }
    // A shortcut is valid only if both strips are as wide as the radius.
    if (turn.kind == Turn::Kind::kPivot || is_inside) line(dab.center);
    line(to.start);
  }

  /// Appends an arc as cubics. The distance of a cubic from the circle is r 4/27 sin(a/4)^6 /
  /// cos(a/4)^2 for an angle a. Source: Goldapp, "Approximation of circular arcs by cubic
  /// polynomials", 1991.
  void arc(const Dab& dab, Vec normal, double sweep) {
    int count = std::max(
        1, static_cast<int>(std::ceil(std::fabs(sweep) / (0.5 * std::numbers::pi) - 1e-9)));
    const auto error = [&] {
      const double s = std::sin(0.25 * sweep / count), c = std::cos(0.25 * sweep / count);
      return dab.radius_mm * (4.0 / 27.0) * s * s * s * s * s * s / (c * c);
    };
    while (error() > tolerance_mm_ && count < 1000) ++count;
    const double step = sweep / count;
    const double handle = 4.0 / 3.0 * std::tan(0.25 * step) * dab.radius_mm;
    const double c = std::cos(step), s = std::sin(step);
    begin(dab.center + dab.radius_mm * normal);
    if (dab.radius_mm * std::fabs(sweep) < kNoticeableMm) return;
    for (int i = 0; i < count; ++i) {
      const Vec next = c * normal + s * perp(normal);
      cubic(dab.center + dab.radius_mm * normal + handle * perp(normal),
            dab.center + dab.radius_mm * next - handle * perp(next),
            dab.center + dab.radius_mm * next);
      normal = next;
    }
  }

  double tolerance_mm_;
  OutlinePath& path_;
  bool open_ = false;
};

}  // namespace

OutlinePath outline_path(const Stroke& stroke, double tolerance_mm) {
  OutlinePath path;
  PathBuilder builder(tolerance_mm, path);
  std::vector<InkPiece> pieces = pieces_of(stroke);
  std::vector<SideStretch> side;
  for (int direction : {+1, -1}) {
    side.clear();
    append_left_edge(pieces, tolerance_mm, side);
    if (stroke.closed()) append_seam(side, direction);
    builder.side(side, stroke.closed(), direction);
    if (stroke.closed() || direction < 0) builder.close();
    std::reverse(pieces.begin(), pieces.end());
    for (InkPiece& piece : pieces) piece = reversed(piece);
  }
  return path;
}

}  // namespace felt
