#include "felt/stroke/edit/hold_profile.h"

#include <algorithm>
#include <cmath>

#include "felt/stroke/drawn_profile.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

constexpr double kHeldTone = 0.02;
/// Largest value of x (1 - x)^2, the shape of a bend.
constexpr double kLargestBend = 4.0 / 27.0;

void append_knot(std::vector<WidthKnot>& knots, const WidthKnot& knot) {
  if (knots.empty() || knot.u > knots.back().u) knots.push_back(knot);
}

/// Calls visit(piece, u of x) for each piece of the drawn profile, and copies the breakpoints.
template <class Visit>
std::vector<WidthKnot> with_more_knots(const Stroke& stroke, Visit visit) {
  std::vector<WidthKnot> knots;
  DrawnProfile profile(stroke);
  while (const DrawnPiece* piece = profile.next()) {
    const double u0 = piece->segment + piece->t0, u1 = piece->segment + piece->t1;
    const WidthKnot &a = stroke.widths()[piece->knot], &b = stroke.widths()[piece->knot + 1];
    if (a.u == u0) append_knot(knots, a);
    visit(
        *piece, [&](double x) { return x < 1.0 ? u0 + x * (u1 - u0) : u1; }, knots);
    if (b.u == u1) append_knot(knots, b);
  }
  return knots;
}

}  // namespace

std::vector<WidthKnot> drawn_knots(const Stroke& stroke, double tolerance_mm) {
  return with_more_knots(stroke, [&](const DrawnPiece& piece, auto u_of, auto& knots) {
    const int steps = piece.tone.steps(kHeldTone, piece.radius_mm.steps(tolerance_mm, 1));
    if (piece.radius_mm.is_straight() && piece.tone.is_straight()) return;
    // A joint at which the drawn profile turns gets a breakpoint, too.
    for (int s = 0; s <= steps; ++s) {
      const double x = static_cast<double>(s) / steps;
      WidthKnot knot = knot_at(stroke.widths(), u_of(x));
      knot.width_mm = std::max(knot.width_mm + 2.0 * piece.radius_mm.at(x), kMinWidthMm);
      knot.tone = std::clamp(knot.tone + piece.tone.at(x), 0.0, 1.0);
      append_knot(knots, knot);
    }
  });
}

std::vector<WidthKnot> held_knots(const Stroke& stroke, double tolerance_mm) {
  return with_more_knots(stroke, [&](const DrawnPiece& piece, auto u_of, auto& knots) {
    // In a piece that is shorter by the factor x, a bend is smaller by the same factor.
    const auto near = [&](double bend) {
      const double largest = kLargestBend * std::fabs(bend);
      return largest > tolerance_mm ? std::min(tolerance_mm / largest, 0.5) : 0.0;
    };
    const double start = near(piece.radius_mm.start), end = near(piece.radius_mm.end);
    if (start > 0.0) append_knot(knots, knot_at(stroke.widths(), u_of(start)));
    if (end > 0.0) append_knot(knots, knot_at(stroke.widths(), u_of(1.0 - end)));
  });
}

}  // namespace felt
