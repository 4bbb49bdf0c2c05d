#include "felt/render/pressure_map.h"

#include <algorithm>
#include <cmath>

#include "felt/render/wide_vectors.h"

namespace felt {
namespace {

/// Number of pixels that are processed together. Each row has space for kLanes more pixels.
constexpr int kLanes = 8;

/// Fraction of the tone that is lost at the edge of the tip.
constexpr float kLessAtEdge = 0.45F;

/// A line reaches this far beyond its radius, because its outermost pixels are covered only in
/// part.
constexpr double kRimPx = 1.0;
/// The tip counts as this much wider than its ink, so that on a hairline the pixels next to the
/// middle are not the rim.
constexpr double kSoftPx = 0.5;
/// If the radius changes by more than this per length, a dab reaches beyond the straight end of its
/// strip.
constexpr double kTaper = 0.1;
constexpr auto kBesidePx = static_cast<float>(kRimPx - kSoftPx);

constexpr float kMaxKey = 4095.0F, kMaxRim = 1023.0F, kMaxAcross = 511.0F;

/// Clamps in two separate steps, because compilers do not vectorize nested conditions.
inline float clamped(float x, float low, float high) noexcept {
  const float smallest = x < low ? low : x;
  return smallest > high ? high : smallest;
}

/// Returns the direction as a vector of length 1, or 0 if the points are equal.
Vec direction(Vec from, Vec to) noexcept {
  const double length = norm(to - from);
  return length > 0.0 ? (to - from) / length : Vec{};
}

/// Rounds to a fine grid, so that a point is the same in a picture that begins some pixels further
/// on, despite earlier rounding.
Vec on_grid(Vec px) noexcept {
  constexpr double kGrid = 1024.0;
  return {std::floor(kGrid * px.x + 0.5) / kGrid, std::floor(kGrid * px.y + 0.5) / kGrid};
}

/// The part of a strip that lies in the map, in single precision, and how to walk its rows.
struct Walk {
  float dx, dy, len, per_length, low, high;
  float r0, dr, tone0, dtone, taper;  // taper: change of radius per length
  float rest_x, rest_y, widest2;
  float edge_from;
  int home_x, home_y;
  // Positions in x: the ends of the strip; its middle line at row 0, and the change of that per
  // row; half of the strip's extent in a row.
  double from, to, cut_x, per_row, reach;
  bool is_steep = false;
  int y0, y1, x_end;
  // The first pixel of the map.
  int map_x0, map_y0;
  std::size_t stride;
  std::int32_t* values;
};

// Writes the push of one strip into the map. For each pixel: project it onto the strip's middle
// line, find the dab there, compute rho^2 and from it the push, and keep the larger of the new and
// the old value. Eight pixels are processed at a time in plain loops over numbers, so that a
// compiler vectorizes them. Positions are relative to the strip's start, so that the numbers do not
// depend on where the picture begins.
template <bool kTapers>
[[gnu::always_inline]] inline void walk(const Walk& walk) noexcept {
  const Walk w = walk;
  const float edge_from = w.edge_from;
  const float per_edge = edge_from < 1.0F ? 1.0F / (1.0F - edge_from) : 0.0F;
  constexpr auto kMin = static_cast<float>(PressureMap::kMinPush);
  constexpr float kPerPush = kMaxKey / (1.0F - kMin);
  for (int y = w.y0; y < w.y1; ++y) {
    double from = w.from, to = w.to;
    if (w.is_steep) {  // only the part of the row within the strip's width
      const double middle = w.cut_x + w.per_row * y;
      from = std::max(from, middle - w.reach);
      to = std::min(to, middle + w.reach);
    }
    const int x0 = std::max(w.map_x0, static_cast<int>(std::floor(std::max(from, -1e6))));
    const int x1 = std::min(w.x_end, static_cast<int>(std::ceil(std::min(to, 1e6))) + 1);
    const float py = static_cast<float>(y - w.home_y) + w.rest_y;
    std::int32_t* values = w.values + static_cast<std::size_t>(y - w.map_y0) * w.stride;
    for (int x = x0; x < x1; x += kLanes) {
      std::int32_t* lanes = values + (x - w.map_x0);
      for (int k = 0; k < kLanes; ++k) {
        const float px = static_cast<float>(x + k - w.home_x) + w.rest_x;
        const float along = px * w.dx + py * w.dy;
        const float across = px * w.dy - py * w.dx;
        float at = clamped(along, 0.0F, w.len);
        if constexpr (kTapers) {  // the dab of a point lies towards the wider end
          at = along + w.taper * across * across / (w.r0 + w.taper * at);
          at = clamped(at, 0.0F, w.len);
        }
        const float t = at * w.per_length;
        const float past = along - at;
        const float per_r = 1.0F / (w.r0 + t * w.dr);
        const float rho2 = (across * across + past * past) * per_r * per_r;
        const float rim = rho2 < 1.0F ? rho2 : 1.0F;
        const float in_edge = (rim - edge_from) * per_edge;
        const float at_edge = in_edge > 0.0F ? in_edge : 0.0F;
        const float firm = (w.tone0 + t * w.dtone) * (1.0F - kLessAtEdge * rim);
        const float push = firm + (kMin - firm) * (at_edge * at_edge);
        const float side = across * per_r;
        const float place = clamped(side, -1.0F, 1.0F);
        const auto key = static_cast<std::int32_t>((push - kMin) * kPerPush);
        const auto rim_key = static_cast<std::int32_t>(rim * kMaxRim);
        const auto across_key = static_cast<std::int32_t>((place + 1.0F) * (0.5F * kMaxAcross));
        const std::int32_t value =
            (key << PressureMap::kPushShift) | (rim_key << PressureMap::kRimShift) | across_key;
        const float reach = w.r0 + t * w.dr + kBesidePx;
        const float reach2 = kTapers ? w.widest2 : reach * reach;
        const float beside2 = across * across + past * past;
        const std::int32_t is_in = static_cast<std::int32_t>(along >= w.low) &
                                   static_cast<std::int32_t>(along <= w.high) &
                                   static_cast<std::int32_t>(beside2 <= reach2);
        const std::int32_t laid = -is_in & value;
        lanes[k] = lanes[k] < laid ? laid : lanes[k];
      }
    }
  }
}

FELT_WIDE_VECTORS void walk_even(const Walk& w) noexcept {
  walk<false>(w);
}
FELT_WIDE_VECTORS void walk_tapering(const Walk& w) noexcept {
  walk<true>(w);
}

}  // namespace

/// The path from dab a to dab b, and how far the strip reaches beyond each dab: far enough for a
/// cap at an end of the line, or to close the wedge between two strips at a joint.
struct PressureMap::Strip {
  TipAt a, b;
  double before = 0.0, after = 0.0;
};

void PressureMap::begin(PixelRect area, double edge) {
  area_ = area;
  const double from = 1.0 - std::clamp(edge, 0.0, 1.0);
  edge_from_ = edge > 0.0 ? static_cast<float>(from * from) : 2.0F;
  stride_ = static_cast<std::size_t>(area.width()) + kLanes;
  values_.assign(stride_ * static_cast<std::size_t>(area.height()), 0);
}

double PressureMap::push_at(int x, int y) const noexcept {
  const std::int32_t value = row(y)[x - area_.x0];
  return value == 0
             ? kMinPush
             : kMinPush + (1.0 - kMinPush) * (value >> kPushShift) / static_cast<double>(kMaxKey);
}

void PressureMap::lay(std::span<const TipAt> tips, Vec into, Vec out) {
  if (tips.empty()) return;
  way_.assign(tips.begin(), tips.end());
  for (TipAt& tip : way_) tip.center_px = on_grid(tip.center_px);
  const std::vector<TipAt>& way = way_;
  const auto radius = [&](std::size_t i) { return way[i].radius_px + kRimPx; };
  if (way.size() == 1) return lay(Strip{way[0], way[0], radius(0), radius(0)});
  /// Returns how far two strips that meet in a dab must reach beyond it.
  const auto joint = [&](Vec from, Vec to, std::size_t dab) {
    const double turn = dot(from, to) > 0.0 ? std::abs(cross(from, to)) : 1.0;
    return turn * radius(dab) + kSoftPx;
  };
  Vec along = direction(way[0].center_px, way[1].center_px);
  double before = joint(into, along, 0);
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const Vec next =
        i + 2 < way.size() ? direction(way[i + 1].center_px, way[i + 2].center_px) : out;
    const double after = joint(along, next, i + 1);
    // A tip that grows as it moves also covers points behind it.
    const double length = norm(way[i + 1].center_px - way[i].center_px);
    const double grows = way[i + 1].radius_px - way[i].radius_px;
    const double behind = grows > kTaper * length ? radius(i + 1) - length : 0.0;
    const double ahead = -grows > kTaper * length ? radius(i) - length : 0.0;
    lay_in_pieces({way[i], way[i + 1], std::max(before, behind), std::max(after, ahead)});
    before = after;
    along = next;
  }
}

/// Adds a strip. If it is longer than kLongPx, cuts it at fixed positions and adds only the pieces
/// near the picture.
void PressureMap::lay_in_pieces(const Strip& strip) {
  constexpr double kLongPx = 1024.0;
  const Vec way = strip.b.center_px - strip.a.center_px;
  const double length = norm(way);
  if (!(length > kLongPx)) return lay(strip);
  const Vec middle{0.5 * (area_.x0 + area_.x1), 0.5 * (area_.y0 + area_.y1)};
  const double reach = area_.width() + area_.height() +
                       std::max(strip.a.radius_px, strip.b.radius_px) + strip.before + strip.after;
  const double at = dot(middle - strip.a.center_px, way) / length;
  const double pieces = std::ceil(length / kLongPx);
  const double first = std::max(0.0, std::floor((at - reach) / kLongPx));
  const double last = std::min(pieces - 1.0, std::floor((at + reach) / kLongPx));
  const auto tip_at = [&](double n) {
    if (n >= pieces) return strip.b;
    const double t = n * kLongPx / length;
    return TipAt{strip.a.center_px + t * way,
                 strip.a.radius_px + t * (strip.b.radius_px - strip.a.radius_px),
                 strip.a.tone + t * (strip.b.tone - strip.a.tone)};
  };
  for (double n = first; n <= last; ++n) {
    lay(Strip{tip_at(n), tip_at(n + 1.0), n == 0.0 ? strip.before : kRimPx,
              n + 1.0 == pieces ? strip.after : kRimPx});
  }
}

void PressureMap::lay(const Strip& strip) {
  const TipAt &a = strip.a, &b = strip.b;
  const double widest = std::max(a.radius_px, b.radius_px) + kRimPx;
  const Vec way = b.center_px - a.center_px;
  const double length = norm(way);
  const Vec d = length > 0.0 ? way / length : Vec{1.0, 0.0};
  const double ends = std::max(strip.before, strip.after);
  const Vec reach{std::abs(d.x) * ends + std::abs(d.y) * widest,
                  std::abs(d.y) * ends + std::abs(d.x) * widest};
  const Vec low =
      Vec{std::min(a.center_px.x, b.center_px.x), std::min(a.center_px.y, b.center_px.y)} - reach;
  const Vec high =
      Vec{std::max(a.center_px.x, b.center_px.x), std::max(a.center_px.y, b.center_px.y)} + reach;
  if (!(widest < 1e6 && length < 1e7) || !(high.x > area_.x0 && low.x < area_.x1) ||
      !(high.y > area_.y0 && low.y < area_.y1)) {
    return;
  }
  const double home_x = std::floor(a.center_px.x + 0.3717);
  const double home_y = std::floor(a.center_px.y + 0.3717);
  Walk w{};
  w.dx = static_cast<float>(d.x);
  w.dy = static_cast<float>(d.y);
  w.len = static_cast<float>(length);
  w.per_length = static_cast<float>(length > 0.0 ? 1.0 / length : 0.0);
  w.low = static_cast<float>(-strip.before);
  w.high = static_cast<float>(length + strip.after);
  w.r0 = static_cast<float>(a.radius_px + kSoftPx);
  w.dr = static_cast<float>(b.radius_px - a.radius_px);
  w.taper = w.dr * w.per_length;
  w.tone0 = static_cast<float>(std::clamp(a.tone, 0.0, 1.0));
  w.dtone = static_cast<float>(std::clamp(b.tone, 0.0, 1.0)) - w.tone0;
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
  w.y0 = std::max(area_.y0, static_cast<int>(std::floor(std::max(low.y, -1e6))));
  w.y1 = std::min(area_.y1, static_cast<int>(std::ceil(std::min(high.y, 1e6))) + 1);
  w.edge_from = edge_from_;
  w.x_end = area_.x1;
  w.map_x0 = area_.x0;
  w.map_y0 = area_.y0;
  w.stride = stride_;
  w.values = values_.data();
  std::abs(b.radius_px - a.radius_px) > kTaper* length ? walk_tapering(w) : walk_even(w);
}

}  // namespace felt
