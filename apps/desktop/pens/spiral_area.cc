#include "desktop/pens/spiral_area.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTabletEvent>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace felt::desktop {
namespace {

constexpr double kTurns = 5.0;
constexpr int kSpiralPieces = 400;
constexpr double kSpiralMarginPx = 12.0, kGuidePx = 6.0, kInkPx = 1.6;
constexpr double kMmPerInch = 25.4;
/// Samples beyond this are not kept: a minute at 1 kHz.
constexpr std::size_t kMaxSamples = 60'000;

QPainterPath guide_spiral(const QRectF& area) {
  const double radius = 0.5 * std::min(area.width(), area.height()) - kSpiralMarginPx;
  QPainterPath path(area.center());
  for (int i = 1; i <= kSpiralPieces; ++i) {
    const double u = double(i) / kSpiralPieces, a = 2.0 * std::numbers::pi * kTurns * u;
    path.lineTo(area.center() + radius * u * QPointF(std::cos(a), std::sin(a)));
  }
  return path;
}

}  // namespace

SpiralArea::SpiralArea(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Spiral"));
  setAccessibleDescription(tr("Draw along the spiral, from its middle outwards."));
  setCursor(Qt::CrossCursor);
  setFocusPolicy(Qt::NoFocus);
}

QSize SpiralArea::sizeHint() const {
  const int side = fontMetrics().height() * 21;
  return {side, side};
}

void SpiralArea::clear() {
  samples_.clear();
  ink_.clear();
  middle_mm_.reset();
  drawn_s_ = 0.0;
  touches_ = false;
  update();
}

double SpiralArea::mm_per_px() const {
  return kMmPerInch / std::max(physicalDpiX(), 1);
}

void SpiralArea::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  QColor faint = palette().color(QPalette::Text);
  faint.setAlphaF(0.15F);
  painter.setPen(faint);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
  painter.setPen(QPen(faint, kGuidePx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(guide_spiral(rect()));
  painter.setPen(QPen(palette().color(QPalette::Text), kInkPx, Qt::SolidLine, Qt::RoundCap));
  for (std::size_t i = 1; i < ink_.size(); ++i) {
    if (!std::isnan(ink_[i].x()) && !std::isnan(ink_[i - 1].x())) {
      painter.drawLine(ink_[i - 1], ink_[i]);
    }
  }
}

void SpiralArea::add(const PenSample& sample) {
  const Point mm{sample.position.x, sample.position.y};
  const bool touches = in_contact(sample);
  if (touches && !middle_mm_) middle_mm_ = mm;
  const Vec from_middle = mm - middle_mm_.value_or(mm);
  point(QRectF(rect()).center() + QPointF(from_middle.x, from_middle.y) / mm_per_px(), mm, touches,
        sample.time_ns);
}

void SpiralArea::point(QPointF at, bool touching, std::uint64_t stamp_ms) {
  const double scale = mm_per_px();
  point(at, {scale * at.x(), scale * at.y()}, touching,
        static_cast<std::int64_t>(stamp_ms) * 1'000'000);
}

void SpiralArea::point(QPointF at, Point mm, bool touching, std::int64_t time_ns) {
  if (!touching) {
    if (!std::exchange(touches_, false)) return;
    ink_.emplace_back(std::nan(""), std::nan(""));
    Q_EMIT lifted();
    return;
  }
  if (samples_.size() >= kMaxSamples) return;
  if (std::exchange(touches_, true)) {
    drawn_s_ += 1e-9 * static_cast<double>(std::max<std::int64_t>(
                           time_ns - samples_.back().time_ns.value_or(time_ns), 0));
  }
  samples_.push_back({mm, std::nullopt, time_ns});
  ink_.push_back(at);
  update();
  Q_EMIT drawn();
}

void SpiralArea::tabletEvent(QTabletEvent* event) {
  const bool tip = event->buttons().testFlag(Qt::LeftButton) &&
                   !(event->type() == QEvent::TabletRelease && event->button() == Qt::LeftButton);
  point(event->position(), tip, event->timestamp());
  event->accept();
}

void SpiralArea::mousePressEvent(QMouseEvent* event) {
  mouseMoveEvent(event);
}

void SpiralArea::mouseMoveEvent(QMouseEvent* event) {
  if (event->source() != Qt::MouseEventNotSynthesized) return;
  point(event->position(), event->buttons().testFlag(Qt::LeftButton), event->timestamp());
}

void SpiralArea::mouseReleaseEvent(QMouseEvent* event) {
  mouseMoveEvent(event);
}

}  // namespace felt::desktop
