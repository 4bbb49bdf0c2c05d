#include "felt/stroke/drawn_profile.h"

#include <algorithm>
#include <cmath>

namespace felt {
namespace {

/// Bounds the memory if a tolerance is extremely fine.
constexpr int kMaxBendSteps = 1 << 10;
/// A piece whose end passes more slowly than this stands still there.
constexpr double kStandstillMm = 1e-100;

/// Returns the slope that is drawn at a node between lines with the slopes `before` and `after`.
double drawn_slope(double before, double after) noexcept {
  return before * after > 0.0 ? 2.0 * before * (after / (before + after)) : 0.0;
}

/// What counts as a kink of a width or tone, in units per mm.
struct Kink {
  double unseen;
  double jump;  ///< lines as steep as this are jumps, which stay as they are
};
constexpr Kink kRadiusKink{kUnseenKink, kJump}, kToneKink{kUnseenToneKink, 1e6};

/// Sets the bends at the node between two lines, which are given by their changes along the piece,
/// their slopes per mm at the node, and their speeds in mm per piece.
void bend_node(double change0, double before, double speed0, double change1, double after,
               double speed1, const Kink& kink, double& end, double& start) noexcept {
  if (std::fabs(before - after) <= kink.unseen ||
      std::max(std::fabs(before), std::fabs(after)) >= kink.jump) {
    return;
  }
  const double slope = drawn_slope(before, after);
  end = slope * speed0 - change0;
  start = slope * speed1 - change1;
}

}  // namespace

int ProfileBend::steps(double tolerance, int least) const noexcept {
  if (is_straight()) return least;
  // The second derivative is linear in x, so it is largest at an end.
  const double most =
      std::max(std::fabs(second_derivative(0.0)), std::fabs(second_derivative(1.0)));
  const double enough = most / (8.0 * tolerance);  // the square of the number of steps
  if (enough <= static_cast<double>(least) * least) return least;
  if (!(enough < kMaxBendSteps * kMaxBendSteps)) return std::max(least, kMaxBendSteps);
  return static_cast<int>(std::ceil(std::sqrt(enough)));
}

void smooth_node(ProfileLine& a, ProfileLine& b) noexcept {
  if (a.radius_mm == 0.0 && b.radius_mm == 0.0 && a.tone == 0.0 && b.tone == 0.0) return;
  const double speed0 = a.speed1_mm, speed1 = b.speed0_mm;
  if (!(speed0 > kStandstillMm && speed1 > kStandstillMm)) return;
  const double per0 = 1.0 / speed0, per1 = 1.0 / speed1;
  bend_node(a.radius_mm, a.radius_mm * per0, speed0, b.radius_mm, b.radius_mm * per1, speed1,
            kRadiusKink, a.piece.radius_mm.end, b.piece.radius_mm.start);
  bend_node(a.tone, a.tone * per0, speed0, b.tone, b.tone * per1, speed1, kToneKink,
            a.piece.tone.end, b.piece.tone.start);
}

DrawnProfile::DrawnProfile(const Stroke& stroke, int first) noexcept : stroke_(stroke) {
  const auto knots = stroke.widths();
  const auto after = std::upper_bound(knots.begin(), knots.end() - 1, static_cast<double>(first),
                                      [](double u, const WidthKnot& knot) { return u < knot.u; });
  ahead_ = line_from(first, 0.0, static_cast<std::size_t>(after - knots.begin()) - 1);
  if (auto before = line_before(ahead_)) smooth_node(*before, ahead_);
}

const DrawnPiece* DrawnProfile::next() noexcept {
  if (!has_ahead_) return nullptr;
  now_ = ahead_;
  has_ahead_ = find_after(now_);
  if (has_ahead_) {
    smooth_node(now_, ahead_);
  } else if (is_seam_smooth()) {  // the next piece is the first one
    ProfileLine first = line_from(0, 0.0, 0);
    smooth_node(now_, first);
  }
  return &now_.piece;
}

bool DrawnProfile::is_seam_smooth() const noexcept {
  const WidthKnot &a = stroke_.widths().front(), &b = stroke_.widths().back();
  return stroke_.closed() && a.width_mm == b.width_mm && a.tone == b.tone;
}

/// Returns the piece of equation (3) between two nodes; `knot` is as in DrawnPiece.
ProfileLine DrawnProfile::line(int segment, double t0, double t1, std::size_t knot) const noexcept {
  const WidthKnot &a = stroke_.widths()[knot], &b = stroke_.widths()[knot + 1];
  const double part = (t1 - t0) / (b.u - a.u);
  ProfileLine line{.piece = {segment, t0, t1, knot, {}, {}},
                   .radius_mm = 0.5 * (b.width_mm - a.width_mm) * part,
                   .tone = (b.tone - a.tone) * part};
  const Cubic c = stroke_.segment(segment);
  line.speed0_mm = (t0 == 0.0 ? 3.0 * norm(c.p[1] - c.p[0]) : norm(derivative(c, t0))) * (t1 - t0);
  line.speed1_mm = (t1 == 1.0 ? 3.0 * norm(c.p[3] - c.p[2]) : norm(derivative(c, t1))) * (t1 - t0);
  return line;
}

ProfileLine DrawnProfile::line_from(int segment, double t0, std::size_t knot) const noexcept {
  const double end = stroke_.widths()[knot + 1].u;
  return line(segment, t0, end < segment + 1 ? end - segment : 1.0, knot);
}

/// Replaces ahead_ by the line after `before`. Returns false if `before` is the last one.
bool DrawnProfile::find_after(const ProfileLine& before) noexcept {
  const DrawnPiece& piece = before.piece;
  const int i = piece.segment + 1;
  if (piece.t1 < 1.0) {
    ahead_ = line_from(piece.segment, piece.t1, piece.knot + 1);
  } else if (i < stroke_.segment_count()) {
    ahead_ = line_from(i, 0.0, piece.knot + (stroke_.widths()[piece.knot + 1].u <= i ? 1 : 0));
  } else {
    return false;
  }
  return true;
}

std::optional<ProfileLine> DrawnProfile::line_before(const ProfileLine& after) const noexcept {
  const auto knots = stroke_.widths();
  if (after.piece.segment == 0) {
    if (!is_seam_smooth()) return std::nullopt;
    const int last = stroke_.segment_count() - 1;
    const std::size_t knot = knots.size() - 2;
    return line(last, std::max(0.0, knots[knot].u - last), 1.0, knot);
  }
  const int i = after.piece.segment;  // `after` starts at a joint
  const std::size_t knot = knots[after.piece.knot].u < i ? after.piece.knot : after.piece.knot - 1;
  return line(i - 1, std::max(0.0, knots[knot].u - (i - 1)), 1.0, knot);
}

double drawn_width_mm(const Stroke& stroke, double u) noexcept {
  const double end = stroke.segment_count();
  u = u > 0.0 ? std::min(u, end) : 0.0;
  const int i = std::min(static_cast<int>(u), stroke.segment_count() - 1);
  DrawnProfile profile(stroke, i);
  const DrawnPiece* piece = profile.next();
  while (piece->segment == i && i + piece->t1 < u) piece = profile.next();
  const double x = std::clamp((u - i - piece->t0) / (piece->t1 - piece->t0), 0.0, 1.0);
  return stroke.width_mm(u) + 2.0 * piece->radius_mm.at(x);
}

}  // namespace felt
