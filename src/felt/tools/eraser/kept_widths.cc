#include "felt/tools/eraser/kept_widths.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "felt/stroke/drawn_profile.h"
#include "felt/stroke/edit/hold_profile.h"
#include "felt/stroke/width_profile.h"

namespace felt {
namespace {

/// Largest difference of the drawn radius from that of the narrowed profile.
constexpr double kHeldMm = 0.002;
constexpr double kUnseenTone = 0.02;

/// A piece of the original's profile.
struct OldPiece {
  double from, to;
  double start, end;  ///< the parts of the piece at its ends in which no bend is visible
  bool touched;
  bool kept;  ///< has the breakpoints of the original
};

/// Returns the part of a piece, at most a quarter, in which the bend of one of its ends is not
/// visible; 0 if all of the bend is invisible.
double unseen_part(double radius_bend_mm, double tone_bend) {
  const double bend =
      std::max(std::fabs(radius_bend_mm) / kHeldMm, std::fabs(tone_bend) / kUnseenTone);
  return bend > 1.0 ? std::min(0.25, 1.0 / bend) : 0.0;
}

/// Lists the pieces of the original. A piece is kept if neither it nor a neighbour is touched: its
/// drawn width depends on both. The seam of a closed stroke counts as touched.
std::vector<OldPiece> old_pieces(const Stroke& original, const ParameterSet& touched) {
  std::vector<OldPiece> pieces;
  DrawnProfile profile(original);
  while (const DrawnPiece* p = profile.next()) {
    const double from = p->segment + p->t0, to = p->segment + p->t1;
    const bool meets = std::ranges::any_of(
        touched.intervals(), [&](const auto& part) { return part.from <= to && part.to >= from; });
    pieces.push_back({from, to, unseen_part(p->radius_mm.start, p->tone.start),
                      unseen_part(p->radius_mm.end, p->tone.end), meets, false});
  }
  const std::size_t last = pieces.size() - 1;
  for (std::size_t i = 0; i <= last; ++i) {
    const bool at_seam = original.closed() && (i == 0 || i == last);
    pieces[i].kept = !at_seam && !pieces[i].touched && !(i > 0 && pieces[i - 1].touched) &&
                     !(i < last && pieces[i + 1].touched);
  }
  return pieces;
}

void append_knot(std::vector<WidthKnot>& knots, const WidthKnot& knot) {
  if (knots.empty() || knot.u > knots.back().u) knots.push_back(knot);
}

/// Appends the breakpoints of a profile from one place to another.
void append_part(std::span<const WidthKnot> profile, double from, double to,
                 std::vector<WidthKnot>& knots) {
  for (const WidthKnot& knot : profile) {
    if (from <= knot.u && knot.u <= to) append_knot(knots, knot);
  }
}

}  // namespace

std::vector<WidthKnot> kept_widths(const Stroke& original, const Stroke& drawn,
                                   const InkNarrowing::Result& narrowed) {
  if (narrowed.widths.empty() && narrowed.holes.empty()) return {};
  std::vector<WidthKnot> changed(drawn.widths().begin(), drawn.widths().end());
  if (!narrowed.widths.empty()) {
    StrokeData data = original.data();
    data.widths = narrowed.widths;
    const auto stroke = Stroke::create(std::move(data));
    if (!stroke) return narrowed.widths;
    // The width is exact between the breakpoints, too, so that nothing that was erased returns.
    changed = held_knots(*stroke, kHeldMm);
  }
  const std::vector<OldPiece> pieces = old_pieces(original, narrowed.touched);
  std::vector<WidthKnot> knots;
  const auto append_old = [&](double u) { append_knot(knots, knot_at(original.widths(), u)); };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto [from, to, start, end, touched, kept] = pieces[i];
    if (kept) {
      append_part(original.widths(), from, to, knots);
      continue;
    }
    // Beside a kept piece, the line of the original goes on a little, because the drawn width of
    // the kept piece depends on its slope.
    double first = from, last = to;
    if (i > 0 && pieces[i - 1].kept) {
      append_old(from);
      append_old(from + start * (to - from));
      first += 2.0 * start * (to - from);
      append_knot(knots, knot_at(changed, first));
    }
    const bool before_kept = i + 1 < pieces.size() && pieces[i + 1].kept;
    if (before_kept) last -= 2.0 * end * (to - from);
    append_part(changed, first, last, knots);
    if (before_kept) {
      append_knot(knots, knot_at(changed, last));
      append_old(to - end * (to - from));
      append_old(to);
    }
  }
  return knots;
}

}  // namespace felt
