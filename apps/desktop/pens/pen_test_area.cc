#include "desktop/pens/pen_test_area.h"

#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>
#include <algorithm>
#include <cmath>

#include "desktop/engine/tablet_event_tilt.h"
#include "felt/devices/simulated/pointer_hand.h"

namespace felt::desktop {
namespace {

constexpr double kMinPx = 0.8;
constexpr double kMaxPx = 14.0;
constexpr double kMiddlePressure = 0.5;
constexpr double kMmPerSOfPxPerMs = 250.0;  // on a screen of about 4 pixels per mm
constexpr double kSmoothing = 0.3;

bool senses(const QTabletEvent& event) {
  const QPointingDevice* device = event.pointingDevice();
  return !device || device->hasCapability(QInputDevice::Capability::Pressure);
}

}  // namespace

PenTestArea::PenTestArea(QWidget* parent) : QWidget(parent) {
  setTabletTracking(true);  // shows the tilt even before the pen touches
  setAccessibleName(tr("Test area"));
  setAccessibleDescription(tr("Scribble here to try the pen. The scribbles are not kept."));
  setCursor(Qt::CrossCursor);
  setAttribute(Qt::WA_OpaquePaintEvent);
  setMinimumHeight(fontMetrics().height() * 5);
}

QSize PenTestArea::sizeHint() const {
  return {fontMetrics().height() * 24, fontMetrics().height() * 7};
}

void PenTestArea::clear() {
  ink_.fill(Qt::transparent);
  is_empty_ = true;
  update();
}

void PenTestArea::resizeEvent(QResizeEvent*) {
  const double dpr = devicePixelRatioF();
  QImage larger((QSizeF(size()) * dpr).toSize(), QImage::Format_ARGB32_Premultiplied);
  larger.setDevicePixelRatio(dpr);
  larger.fill(Qt::transparent);
  if (!ink_.isNull()) QPainter(&larger).drawImage(QPointF(0, 0), ink_);
  ink_ = larger;
}

void PenTestArea::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), palette().color(QPalette::Base));
  painter.drawImage(QPointF(0, 0), ink_);
  QColor faint = palette().color(QPalette::Text);
  faint.setAlphaF(0.15F);
  painter.setPen(faint);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
  if (!is_empty_) return;
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(rect(), Qt::AlignCenter, tr("Scribble here to try your pen"));
}

double PenTestArea::pressure_of(QPointF at, std::optional<double> raw, std::uint64_t stamp_ms) {
  if (raw) return settings_.pressure_on ? settings_.curve(*raw) : kMiddlePressure;
  if (settings_.mouse == MousePressure::kConstant) return kMiddlePressure;
  if (last_ && stamp_ms > last_ms_) {
    const QPointF way = at - *last_;
    const double speed = std::hypot(way.x(), way.y()) / static_cast<double>(stamp_ms - last_ms_);
    speed_px_per_ms_ += kSmoothing * (speed - speed_px_per_ms_);
  }
  return PointerHand::pressure_at(kMmPerSOfPxPerMs * speed_px_per_ms_);
}

void PenTestArea::point(QPointF at, bool touching, std::optional<double> raw,
                        std::uint64_t stamp_ms) {
  if (raw && !settings_.curve.touches(*raw)) touching = false;
  const double pressure = touching ? pressure_of(at, raw, stamp_ms) : 0.0;
  Q_EMIT pressed(touching ? raw : std::optional<double>(0.0), pressure);
  if (!touching) {
    last_.reset();
    speed_px_per_ms_ = 0.0;
    return;
  }
  const double width_px = std::lerp(kMinPx, kMaxPx, pressure);
  QPainter painter(&ink_);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPointF from = last_.value_or(at);
  const double from_px = last_ ? last_width_px_ : width_px;
  painter.setPen(QPen(palette().color(QPalette::Text), 0.5 * (from_px + width_px), Qt::SolidLine,
                      Qt::RoundCap));
  painter.drawLine(from, at);
  const auto reach = static_cast<int>(kMaxPx) + 1;
  update(QRectF(from, at).normalized().toAlignedRect().adjusted(-reach, -reach, reach, reach));
  if (std::exchange(is_empty_, false)) update();
  last_ = at;
  last_width_px_ = width_px;
  last_ms_ = stamp_ms;
}

void PenTestArea::tabletEvent(QTabletEvent* event) {
  const bool tip = event->buttons().testFlag(Qt::LeftButton) &&
                   !(event->type() == QEvent::TabletRelease && event->button() == Qt::LeftButton);
  point(event->position(), tip, senses(*event) ? std::optional(event->pressure()) : std::nullopt,
        event->timestamp());
  Q_EMIT tilted(tilt_of(*event));
  event->accept();
}

void PenTestArea::mousePressEvent(QMouseEvent* event) {
  mouseMoveEvent(event);
}

void PenTestArea::mouseMoveEvent(QMouseEvent* event) {
  if (event->source() != Qt::MouseEventNotSynthesized) return;
  Q_EMIT tilted(std::nullopt);
  point(event->position(), event->buttons().testFlag(Qt::LeftButton), std::nullopt,
        event->timestamp());
}

void PenTestArea::mouseReleaseEvent(QMouseEvent* event) {
  mouseMoveEvent(event);
}

}  // namespace felt::desktop
