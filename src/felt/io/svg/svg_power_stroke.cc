#include "felt/io/svg/svg_power_stroke.h"

#include <algorithm>
#include <cmath>

#include "felt/geometry/cubic.h"
#include "felt/io/limits.h"
#include "felt/io/svg/svg_scan.h"

namespace felt {
namespace {

constexpr std::size_t kMostKnots = 1'000'000;
constexpr int kSamplesBetweenKnots = 16;

/// "t,w | t,w": w is half of a width.
std::vector<WidthKnot> read_knots(std::string_view text, double scale) {
  std::vector<WidthKnot> knots;
  SvgScan scan(text, limits::kMaxSketchNumber);
  while (!scan.at_end() && knots.size() < kMostKnots) {
    WidthKnot k;
    if (!scan.number(k.u)) break;
    scan.skip_comma();
    if (!scan.number(k.width_mm)) break;
    // Twice a half is exact; a scale of 1 changes nothing.
    k.width_mm = 2.0 * std::fabs(k.width_mm) * scale;
    knots.push_back(k);
    while (!scan.empty() && scan.peek() != '|') scan.take(scan.peek());
    scan.take('|');
  }
  std::stable_sort(knots.begin(), knots.end(),
                   [](const WidthKnot& a, const WidthKnot& b) { return a.u < b.u; });
  return knots;
}

/// Knots that cover all of [0, end].
std::vector<WidthKnot> covering(std::vector<WidthKnot> knots, double end, bool closed,
                                bool zero_begin, bool zero_end) {
  for (WidthKnot& k : knots) k.u = std::clamp(k.u, 0.0, end);
  if (closed) {
    // Round the path from the last knot to the first.
    const WidthKnot a = knots.back(), b = knots.front();
    const double gap = end - a.u + b.u;
    const double seam =
        gap > 0.0 ? a.width_mm + (b.width_mm - a.width_mm) * ((end - a.u) / gap) : b.width_mm;
    if (b.u > 0.0) knots.insert(knots.begin(), {0.0, seam});
    if (a.u < end) knots.push_back({end, b.u > 0.0 ? seam : b.width_mm});
  } else {
    if (knots.front().u > 0.0) {
      knots.insert(knots.begin(), {0.0, zero_begin ? 0.0 : knots.front().width_mm});
    }
    if (knots.back().u < end) knots.push_back({end, zero_end ? 0.0 : knots.back().width_mm});
  }
  std::vector<WidthKnot> rising;
  for (const WidthKnot& k : knots) {
    if (rising.empty() || k.u > rising.back().u) rising.push_back(k);
  }
  if (rising.size() == 1) rising.push_back({end, rising.front().width_mm});
  return rising;
}

/// Handles of the width curve between knots i and i + 1, in the plane of place and width.
Cubic width_curve(const std::vector<WidthKnot>& knots, std::size_t i, bool flat, double beta) {
  const auto point = [&](std::size_t k) { return Point{knots[k].u, knots[k].width_mm}; };
  const Point a = point(i), b = point(i + 1);
  if (flat) {
    const Vec handle{beta * (b.x - a.x), 0.0};
    return {{a, a + handle, b - handle, b}};
  }
  const Point before = point(i > 0 ? i - 1 : i);
  const Point after = point(i + 2 < knots.size() ? i + 2 : i + 1);
  return {{a, a + (b - before) / 6.0, b - (after - a) / 6.0, b}};
}

/// The widths of a curve through the knots, by samples.
std::vector<WidthKnot> sampled(const std::vector<WidthKnot>& knots, bool flat, double beta) {
  std::vector<WidthKnot> widths{knots.front()};
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const Cubic c = width_curve(knots, i, flat, beta);
    for (int k = 1; k <= kSamplesBetweenKnots; ++k) {
      const Point p = evaluate(c, static_cast<double>(k) / kSamplesBetweenKnots);
      const double end = knots[i + 1].u;
      const double u = k == kSamplesBetweenKnots ? end : std::min(p.x, end);
      if (u > widths.back().u) widths.push_back({u, std::max(0.0, p.y)});
    }
    if (widths.back().u == knots[i + 1].u) widths.back() = knots[i + 1];
  }
  return widths;
}

}  // namespace

Result<SvgPowerKnots> svg_power_knots(const SvgVariableWidth& a, std::size_t segments,
                                      bool closed) {
  double scale = 1.0, beta = 0.2;
  // What cannot be read leaves them as they are.
  static_cast<void>(SvgScan(a.scale_width).number(scale));
  static_cast<void>(SvgScan(a.interpolator_beta).number(beta));
  SvgPowerKnots result;
  result.written = read_knots(a.offset_points, scale);
  if (result.written.empty()) return fail(ErrorCode::kInvalidData, "its PowerStroke has no knots");
  const double end = static_cast<double>(segments);
  result.widths =
      covering(result.written, end, closed, a.start_cap == "zerowidth", a.end_cap == "zerowidth");
  if (a.interpolator.empty() || a.interpolator == "Linear") return result;
  if (result.widths.size() * kSamplesBetweenKnots > kMostKnots) return result;
  result.is_sampled = true;
  result.widths =
      sampled(result.widths, a.interpolator == "CubicBezierJohan", std::clamp(beta, 0.0, 1.0));
  return result;
}

}  // namespace felt
