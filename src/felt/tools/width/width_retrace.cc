#include "felt/tools/width/width_retrace.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "felt/stroke/width_profile.h"
#include "felt/tools/brush_bump.h"

namespace felt {
namespace {

constexpr double kSameParameter = 1e-9;

}  // namespace

WidthRetrace::WidthRetrace(const Stroke& stroke, const ArcMap& map)
    : stroke_(stroke),
      map_(map),
      places_(stroke, map, kSpacingMm),
      drawn_(places_.slot_count(), std::numeric_limits<double>::quiet_NaN()) {
  for (const WidthKnot& knot : stroke.widths()) base_lengths_.push_back(map.length_at(knot.u));
}

void WidthRetrace::jump(double length_mm, double width_mm) {
  // The ink that the pen jumps over keeps its width until the pen draws there.
  at_mm_ = mark_mm_ = has_drawn_ ? at_mm_ + map_.way(at_mm_, length_mm) : length_mm;
  mark_width_ = width_mm;
}

void WidthRetrace::go(double way_mm, double width_mm) {
  at_mm_ += way_mm;
  if (std::fabs(at_mm_ - mark_mm_) < kStepMm) return;
  const double whole = map_.length_mm();
  double from = mark_mm_, to = at_mm_;
  if (!stroke_.closed()) {
    const auto up_to_end = [&](double s) {
      return s < kEndMm ? 0.0 : s > whole - kEndMm ? whole : s;
    };
    if (!has_drawn_) mark(up_to_end(from), mark_width_, from, mark_width_);
    mark(to, width_mm, up_to_end(to), width_mm);
  }
  mark(from, mark_width_, to, width_mm);
  mark_mm_ = to;
  mark_width_ = width_mm;
}

void WidthRetrace::mark(double from_mm, double from_width_mm, double to_mm, double to_width_mm) {
  if (from_mm == to_mm) return;
  const double low = std::min(from_mm, to_mm), high = std::max(from_mm, to_mm);
  first_mm_ = has_drawn_ ? std::min(first_mm_, low) : low;
  last_mm_ = has_drawn_ ? std::max(last_mm_, high) : high;
  has_drawn_ = true;
  const double h = places_.spacing_mm();
  // One step covers a closed stroke at most once.
  const long first = static_cast<long>(std::ceil(std::max(low, high - map_.length_mm()) / h));
  const long last = static_cast<long>(std::floor(high / h));
  for (long k = first; k <= last; ++k) {
    const double t = (places_.length_at(k) - from_mm) / (to_mm - from_mm);
    drawn_[places_.slot(k)] = from_width_mm + t * (to_width_mm - from_width_mm);
  }
}

double WidthRetrace::share_at(double length_mm) const noexcept {
  const double whole = map_.length_mm(), drawn = last_mm_ - first_mm_;
  if (stroke_.closed()) {
    if (drawn >= whole) return 1.0;
    length_mm -= whole * std::floor((length_mm - first_mm_) / whole);
  }
  if (length_mm < first_mm_ || length_mm > last_mm_) return 0.0;
  const double blend = std::min(kBlendMm, 0.5 * drawn);
  const bool from_end = !stroke_.closed() && first_mm_ <= 0.0;
  const bool to_end = !stroke_.closed() && last_mm_ >= whole;
  const double in = from_end ? 1.0 : 1.0 - bump((length_mm - first_mm_) / blend);
  const double out = to_end ? 1.0 : 1.0 - bump((last_mm_ - length_mm) / blend);
  return std::min(in, out);
}

double WidthRetrace::drawn_at(long k) const noexcept {
  const double own = drawn_[places_.slot(k)];
  const double half = 0.5 * kBlendMm;
  double from_pen = std::fabs(places_.length_at(k) - at_mm_);
  if (stroke_.closed()) from_pen = std::fabs(map_.way(at_mm_, places_.length_at(k)));
  if (!(from_pen < half)) return own;
  const long reach = std::lround(half / places_.spacing_mm());
  double sum = 0.0, count = 0.0;
  for (long i = k - reach; i <= k + reach; ++i) {
    if (!stroke_.closed() && (i < 0 || i > places_.count())) continue;
    const double width = drawn_[places_.slot(i)];
    if (std::isnan(width)) continue;
    sum += width;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : own;
}

double WidthRetrace::drawn_between(double length_mm) const noexcept {
  const long cell = places_.cell(length_mm);
  const double a = drawn_at(cell), b = drawn_at(cell + 1);
  if (std::isnan(a)) return b;
  if (std::isnan(b)) return a;
  const double t = length_mm / places_.spacing_mm() - static_cast<double>(cell);
  return a + std::clamp(t, 0.0, 1.0) * (b - a);
}

std::vector<ProfileKnot> WidthRetrace::new_knots() const {
  const std::span<const WidthKnot> base = stroke_.widths();
  std::vector<ProfileKnot> knots;
  const auto add = [&](double u, double length_mm, bool stays) {
    const WidthKnot ink = knot_at(base, u);
    const double old = ink.width_mm, share = share_at(length_mm);
    const double drawn = share > 0.0 ? drawn_between(length_mm) : old;
    const double width = std::isnan(drawn) ? old : old + share * (drawn - old);
    knots.push_back({{u, std::max(width, kMinWidthMm), ink.tone}, stays});
  };
  for (long k = 0; k <= places_.count(); ++k) {
    const double length = places_.length_at(k);
    if (share_at(length) > 0.0) add(places_.u(k), length, false);
  }
  const double whole = map_.length_mm();
  for (double end : {first_mm_, last_mm_}) {
    if (last_mm_ - first_mm_ >= whole) break;
    if (stroke_.closed()) end -= whole * std::floor(end / whole);
    if (end > 0.0 && end < whole) add(map_.u_at(end), end, true);
  }
  std::sort(knots.begin(), knots.end(),
            [](const ProfileKnot& a, const ProfileKnot& b) { return a.knot.u < b.knot.u; });
  return knots;
}

/// Merges the drawn breakpoints and those of the stroke that the trace does not replace, by u. Then
/// drops the knots that are not needed.
std::vector<WidthKnot> WidthRetrace::profile() const {
  const std::span<const WidthKnot> base = stroke_.widths();
  if (!has_drawn_) return {base.begin(), base.end()};
  const std::vector<ProfileKnot> drawn = new_knots();
  std::vector<ProfileKnot> knots;
  knots.reserve(base.size() + drawn.size());
  std::size_t j = 0;
  const auto push_drawn_up_to = [&](double u) {
    for (; j < drawn.size() && drawn[j].knot.u < u; ++j) {
      if (knots.empty() || drawn[j].knot.u - knots.back().knot.u > kSameParameter) {
        knots.push_back(drawn[j]);
      }
    }
  };
  for (std::size_t i = 0; i < base.size(); ++i) {
    const double u = base[i].u, length = base_lengths_[i];
    const double share = share_at(length);
    const bool is_end = i == 0 || i + 1 == base.size();
    push_drawn_up_to(u - kSameParameter);
    if (share >= 1.0 && !is_end) continue;
    const double drawn_mm = share > 0.0 ? drawn_between(length) : base[i].width_mm;
    const double width = base[i].width_mm + share * (drawn_mm - base[i].width_mm);
    const double shown = share > 0.0 ? std::max(width, kMinWidthMm) : base[i].width_mm;
    knots.push_back({{u, shown, base[i].tone}, !(share > 0.0)});
    while (j < drawn.size() && drawn[j].knot.u < u + kSameParameter) ++j;
  }
  return thinned(knots, kToleranceMm);
}

}  // namespace felt
