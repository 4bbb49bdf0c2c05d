#include "felt/render/tip_strips.h"

#include <algorithm>

namespace felt {
namespace {

/// If the radius changes by more than this per length, a dab reaches beyond the straight end of its
/// strip.
constexpr double kTaper = 0.1;

/// Returns the direction as a vector of length 1, or 0 if the points are equal.
Vec strip_direction(Vec from, Vec to) noexcept {
  const double length = norm(to - from);
  return length > 0.0 ? (to - from) / length : Vec{};
}

/// Rounds to a fine grid, so that a point is the same in a picture that begins some pixels further
/// on, despite earlier rounding.
TipAt on_grid(TipAt tip) noexcept {
  constexpr double kStepsPerPx = 1024.0;
  tip.center_px = {std::floor(kStepsPerPx * tip.center_px.x + 0.5) / kStepsPerPx,
                   std::floor(kStepsPerPx * tip.center_px.y + 0.5) / kStepsPerPx};
  return tip;
}

/// The path from dab a to dab b, and how far the strip reaches beyond each dab: far enough for a
/// cap at an end of the line, or to close the wedge between two strips at a joint.
struct StripPath {
  TipAt a, b;
  double before = 0.0, after = 0.0;
};

void append_piece(const StripPath& line, PixelRect area, std::vector<TipStrip>& strips) {
  const TipAt &a = line.a, &b = line.b;
  const double widest = std::max(a.radius_px, b.radius_px) + kRimPx;
  const Vec step = b.center_px - a.center_px;
  const double length = norm(step);
  const Vec d = length > 0.0 ? step / length : Vec{1.0, 0.0};
  const double ends = std::max(line.before, line.after);
  const Vec reach{std::abs(d.x) * ends + std::abs(d.y) * widest,
                  std::abs(d.y) * ends + std::abs(d.x) * widest};
  const Vec low =
      Vec{std::min(a.center_px.x, b.center_px.x), std::min(a.center_px.y, b.center_px.y)} - reach;
  const Vec high =
      Vec{std::max(a.center_px.x, b.center_px.x), std::max(a.center_px.y, b.center_px.y)} + reach;
  if (!(widest < 1e6 && length < 1e7) || !(high.x > area.x0 && low.x < area.x1) ||
      !(high.y > area.y0 && low.y < area.y1)) {
    return;
  }
  const double home_x = std::floor(a.center_px.x + 0.3717);
  const double home_y = std::floor(a.center_px.y + 0.3717);
  TipStrip w{};
  w.dx = static_cast<float>(d.x);
  w.dy = static_cast<float>(d.y);
  w.len = static_cast<float>(length);
  w.per_length = static_cast<float>(length > 0.0 ? 1.0 / length : 0.0);
  w.low = static_cast<float>(-line.before);
  w.high = static_cast<float>(length + line.after);
  w.r0 = static_cast<float>(a.radius_px + kSoftPx);
  w.dr = static_cast<float>(b.radius_px - a.radius_px);
  w.taper = w.dr * w.per_length;
  w.tone0 = static_cast<float>(std::clamp(a.tone, 0.0, 1.0));
  w.dtone = static_cast<float>(std::clamp(b.tone, 0.0, 1.0)) - w.tone0;
  w.travel0 = static_cast<float>(a.travel);
  w.dtravel = static_cast<float>(b.travel - a.travel);
  w.rest_x = static_cast<float>(home_x + 0.5 - a.center_px.x);
  w.rest_y = static_cast<float>(home_y + 0.5 - a.center_px.y);
  w.widest2 = static_cast<float>(widest * widest);
  w.home_x = static_cast<int>(home_x);
  w.home_y = static_cast<int>(home_y);
  w.from = low.x;
  w.to = high.x;
  w.is_steep = std::abs(d.y) > 0.05;
  if (w.is_steep) {
    w.per_row = d.x / d.y;
    w.cut_x = a.center_px.x + w.per_row * (0.5 - a.center_px.y);
    w.reach = widest / std::abs(d.y);
  }
  w.tapers = std::abs(b.radius_px - a.radius_px) > kTaper * length;
  w.y0 = std::max(area.y0, static_cast<int>(std::floor(std::max(low.y, -1e6))));
  w.y1 = std::min(area.y1, static_cast<int>(std::ceil(std::min(high.y, 1e6))) + 1);
  strips.push_back(w);
}

/// Appends a strip. If it is longer than kLongPx, cuts it at fixed positions and appends only the
/// pieces near the picture.
void append_in_pieces(const StripPath& line, PixelRect area, std::vector<TipStrip>& strips) {
  constexpr double kLongPx = 1024.0;
  const Vec step = line.b.center_px - line.a.center_px;
  const double length = norm(step);
  if (!(length > kLongPx)) return append_piece(line, area, strips);
  const Vec middle{0.5 * (area.x0 + area.x1), 0.5 * (area.y0 + area.y1)};
  const double reach = area.width() + area.height() + std::max(line.a.radius_px, line.b.radius_px) +
                       line.before + line.after;
  const double at = dot(middle - line.a.center_px, step) / length;
  const double pieces = std::ceil(length / kLongPx);
  const double first = std::max(0.0, std::floor((at - reach) / kLongPx));
  const double last = std::min(pieces - 1.0, std::floor((at + reach) / kLongPx));
  const auto tip_at = [&](double n) {
    if (n >= pieces) return line.b;
    const double t = n * kLongPx / length;
    return TipAt{line.a.center_px + t * step,
                 line.a.radius_px + t * (line.b.radius_px - line.a.radius_px),
                 line.a.tone + t * (line.b.tone - line.a.tone),
                 line.a.travel + t * (line.b.travel - line.a.travel)};
  };
  for (double n = first; n <= last; ++n) {
    append_piece(StripPath{tip_at(n), tip_at(n + 1.0), n == 0.0 ? line.before : kRimPx,
                           n + 1.0 == pieces ? line.after : kRimPx},
                 area, strips);
  }
}

}  // namespace

void append_strips(std::span<const TipAt> path, Vec into, Vec out, PixelRect area,
                   std::vector<TipStrip>& strips) {
  if (path.empty()) return;
  const auto tip = [&](std::size_t i) { return on_grid(path[i]); };
  const auto radius = [&](std::size_t i) { return path[i].radius_px + kRimPx; };
  if (path.size() == 1) {
    return append_in_pieces({tip(0), tip(0), radius(0), radius(0)}, area, strips);
  }
  /// Returns how far two strips that meet in a dab must reach beyond it.
  const auto joint = [&](Vec from, Vec to, std::size_t dab) {
    const double turn = dot(from, to) > 0.0 ? std::abs(cross(from, to)) : 1.0;
    return turn * radius(dab) + kSoftPx;
  };
  TipAt a = tip(0), b = tip(1);
  Vec along = strip_direction(a.center_px, b.center_px);
  double before = joint(into, along, 0);
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const bool has_next = i + 2 < path.size();
    const TipAt c = has_next ? tip(i + 2) : b;
    const Vec next = has_next ? strip_direction(b.center_px, c.center_px) : out;
    const double after = joint(along, next, i + 1);
    // A tip that grows as it moves also covers points behind it.
    const double length = norm(b.center_px - a.center_px);
    const double grows = b.radius_px - a.radius_px;
    const double behind = grows > kTaper * length ? radius(i + 1) - length : 0.0;
    const double ahead = -grows > kTaper * length ? radius(i) - length : 0.0;
    append_in_pieces({a, b, std::max(before, behind), std::max(after, ahead)}, area, strips);
    before = after;
    along = next;
    a = b;
    b = c;
  }
}

}  // namespace felt
