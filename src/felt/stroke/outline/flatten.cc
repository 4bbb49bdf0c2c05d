#include "felt/stroke/outline/flatten.h"

#include <algorithm>
#include <cmath>

namespace felt {

int flatten_steps(const Cubic& c, double span, double tolerance_mm) noexcept {
  // |f''| is largest at one of the ends, where it is 6 times a second difference of the points.
  const double bend = std::max(norm_squared((c.p[2] - c.p[1]) - (c.p[1] - c.p[0])),
                               norm_squared((c.p[3] - c.p[2]) - (c.p[2] - c.p[1])));
  const double steps = span * std::sqrt(0.75 * std::sqrt(bend) / tolerance_mm);
  if (!(steps < kMaxFlattenSteps)) return kMaxFlattenSteps;
  return std::max(1, static_cast<int>(std::ceil(steps)));
}

void flatten(const Stroke& stroke, double tolerance_mm, std::vector<Dab>& out) {
  flatten(stroke, 0, stroke.segment_count(), tolerance_mm, out);
}

void flatten(const Stroke& stroke, int first, int last, double tolerance_mm,
             std::vector<Dab>& out) {
  const auto knots = stroke.widths();
  const int most = std::max(1, kMaxStrokeSteps / stroke.segment_count());
  out.clear();
  out.push_back({stroke.segment(first).p[0], 0.5 * stroke.width_mm(first), stroke.tone(first)});
  // The width piece in hand runs from knot k to k + 1.
  const auto after = std::upper_bound(knots.begin(), knots.end() - 1, static_cast<double>(first),
                                      [](double u, const WidthKnot& knot) { return u < knot.u; });
  auto k = static_cast<std::size_t>(after - knots.begin()) - 1;
  for (int i = first; i < last; ++i) {
    const Cubic c = stroke.segment(i);
    for (double t0 = 0.0; t0 < 1.0;) {
      const WidthKnot a = knots[k], b = knots[k + 1];
      const bool knot_first = b.u < i + 1;
      const double t1 = knot_first ? b.u - i : 1.0;
      const int steps = std::min(most, flatten_steps(c, t1 - t0, tolerance_mm));
      const double slope = 0.5 * (b.width_mm - a.width_mm) / (b.u - a.u);
      const double tone_slope = (b.tone - a.tone) / (b.u - a.u);
      const auto dab_at = [&](Point center, double u) {
        return Dab{center, 0.5 * a.width_mm + slope * (u - a.u),
                   std::clamp(a.tone + tone_slope * (u - a.u), 0.0, 1.0)};
      };
      for (int s = 1; s < steps; ++s) {
        const double t = t0 + (t1 - t0) * s / steps;
        out.push_back(dab_at(evaluate(c, t), i + t));
      }
      out.push_back(dab_at(knot_first ? evaluate(c, t1) : c.p[3], i + 1));
      if (b.u <= i + 1) {
        out.back().radius_mm = 0.5 * b.width_mm;
        out.back().tone = b.tone;
      }
      if (b.u <= i + 1 && k + 2 < knots.size()) ++k;
      t0 = t1;
    }
  }
}

}  // namespace felt
