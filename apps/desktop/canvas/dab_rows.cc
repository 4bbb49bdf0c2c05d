#include "desktop/canvas/dab_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "felt/render/raster.h"
#include "felt/render/tip_travel.h"
#include "felt/stroke/outline/outline.h"

namespace felt::desktop {
namespace {

/// Rows are cut at least kSeamPx outside of a part, so that the cut ends are not visible in the
/// part.
constexpr double kSeamPx = 2.0;
/// Points farther away than kFarPx are not visible, and their numbers lose precision.
constexpr double kFarPx = 1e7;
/// Rows are at least this many widths apart along the path, so that they count as separate visits
/// (VisitMap).
constexpr double kBetweenRows = 10.0;
void append(Outline& to, const Outline& from) {
  for (const std::size_t end : from.ends) to.ends.push_back(to.points.size() + end);
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
}

bool is_near(const Cubic& c) {
  return std::all_of(c.p.begin(), c.p.end(),
                     [](Point p) { return std::abs(p.x) < kFarPx && std::abs(p.y) < kFarPx; });
}

}  // namespace

PixelRect DeviceView::pixels_of(const QRectF& part) const {
  const auto down = [](double px) { return static_cast<int>(std::floor(px + 1e-6)); };
  const auto up = [](double px) { return static_cast<int>(std::ceil(px - 1e-6)); };
  return {down(part.left() * dpr), down(part.top() * dpr), up(part.right() * dpr),
          up(part.bottom() * dpr)};
}

QRect DeviceView::part_of(const Rect& px) const {
  if (px.empty()) return {};
  const QRectF all(0, 0, view.size().width(), view.size().height());
  return QRectF(QPointF(px.x0 / dpr, px.y0 / dpr), QPointF(px.x1 / dpr, px.y1 / dpr))
      .adjusted(-1, -1, 1, 1)
      .intersected(all)
      .toAlignedRect();
}

View DeviceView::as_view() const {
  const double angle =
      (view.is_mirrored() ? -1.0 : 1.0) * view.angle_deg() * std::numbers::pi / 180.0;
  return {to_mm({0.0, 0.0}), px_per_mm(), {std::cos(angle), std::sin(angle)}, view.is_mirrored()};
}

void DabRows::clear() {
  dabs_.clear();
  travels_.clear();
  pieces_.clear();
}

void DabRows::add(const Overlay::InkSegment& segment, double min_px) {
  Cubic c;
  for (std::size_t k = 0; k < 4; ++k) c.p[k] = view_.to_px(segment.curve.p[k]);
  const double half = 0.5 * view_.px_per_mm();
  const double r0 = std::max(half * std::max(segment.start_width_mm, kMinWidthMm), 0.5 * min_px);
  const double r1 = std::max(half * std::max(segment.end_width_mm, kMinWidthMm), 0.5 * min_px);
  Piece piece;
  piece.begins_row =
      pieces_.empty() || pieces_.back().box.empty() || distance(dabs_.back().center, c.p[0]) > 1e-3;
  if (!is_near(c)) {  // the segment keeps its index although it is not visible
    piece.first = dabs_.size();
    piece.begins_row = true;
    dabs_.push_back({c.p[0], 0.0});
    pieces_.push_back(piece);
    add_travels(piece, 0.0);
    return;
  }
  if (piece.begins_row) dabs_.push_back({c.p[0], r0, segment.start_tone});
  piece.first = dabs_.size() - 1;
  const int steps = flatten_steps(c, 1.0, 0.5 * kRasterTolerancePx);
  for (int i = 1; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    dabs_.push_back(
        {evaluate(c, t), r0 + t * (r1 - r0), std::lerp(segment.start_tone, segment.end_tone, t)});
  }
  for (std::size_t k = piece.first; k < dabs_.size(); ++k) {
    const Point p = dabs_[k].center;
    piece.box.extend(Rect{p.x, p.y, p.x, p.y}.inflated(dabs_[k].radius_mm));
  }
  pieces_.push_back(piece);
  add_travels(piece, segment_travel(c, r0, r1));
}

/// Sets the travels of the dabs of the last piece, which is `travel` widths long.
void DabRows::add_travels(const Piece& piece, double travel) {
  tips_.clear();
  for (std::size_t k = piece.first; k < dabs_.size(); ++k) {
    tips_.push_back({{dabs_[k].center.x, dabs_[k].center.y}, dabs_[k].radius_mm, dabs_[k].tone});
  }
  const double last = travels_.empty() ? 0.0 : travels_.back();
  set_travel(tips_, piece.begins_row ? last + kBetweenRows : last, travel);
  travels_.resize(piece.first);
  for (const TipAt& tip : tips_) travels_.push_back(tip.travel);
}

void DabRows::keep(std::size_t n) {
  if (n >= pieces_.size()) return;
  dabs_.resize(pieces_[n].first + (pieces_[n].begins_row ? 0 : 1));
  travels_.resize(dabs_.size());
  pieces_.resize(n);
}

Rect DabRows::bounds(std::size_t from, std::size_t to) const {
  Rect all;
  std::span<const Piece> pieces(pieces_);
  pieces = pieces.first(std::min(to, pieces.size()));
  for (const Piece& piece : pieces.subspan(std::min(from, pieces.size()))) all.extend(piece.box);
  return all;
}

bool DabRows::touches(const Piece& piece, const PixelRect& part) const noexcept {
  return piece.box.intersects(
      {part.x0 - kSeamPx, part.y0 - kSeamPx, part.x1 + kSeamPx, part.y1 + kSeamPx});
}

std::size_t DabRows::end_of(std::size_t piece) const noexcept {
  if (piece + 1 == pieces_.size()) return dabs_.size();
  return pieces_[piece + 1].first + (pieces_[piece + 1].begins_row ? 0 : 1);
}

/// Joins neighbouring segments that touch the part into one sequence, and outlines each sequence
/// separately. The box of the part is enlarged by kSeamPx, so that the cut ends lie outside.
void DabRows::trace(const PixelRect& part, StrokeOutliner& outliner, Outline& out, std::size_t from,
                    std::size_t to) const {
  to = std::min(to, pieces_.size());
  for (std::size_t i = from; i < to;) {
    if (!touches(pieces_[i], part)) {
      ++i;
      continue;
    }
    std::size_t next = i + 1;
    while (next < to && !pieces_[next].begins_row && touches(pieces_[next], part)) ++next;
    const std::size_t first = pieces_[i].first;
    const Outline& outline = outliner.trace(
        std::span(dabs_).subspan(first, end_of(next - 1) - first), false, kRasterTolerancePx);
    append(out, outline);
    i = next;
  }
}

void DabRows::trace_styled(StrokeStyler& styler, const StrokeStyle& style, Outline& out) const {
  for (std::size_t i = 0; i < pieces_.size();) {
    std::size_t next = i + 1;
    while (next < pieces_.size() && !pieces_[next].begins_row) ++next;
    const std::size_t first = pieces_[i].first;
    const auto dabs = std::span(dabs_).subspan(first, end_of(next - 1) - first);
    std::vector<std::size_t> corners;
    for (std::size_t k = i + 1; k < next; ++k) corners.push_back(pieces_[k].first - first);
    if (dabs.size() > 1) {
      const StyledRow row{dabs, corners, false, view_.view.is_mirrored(), 0.0};
      append(out, styler.ink(row, style, kRasterTolerancePx).outline);
    }
    i = next;
  }
}

}  // namespace felt::desktop
