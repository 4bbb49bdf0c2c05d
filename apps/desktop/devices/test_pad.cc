#include "desktop/devices/test_pad.h"

#include <QMouseEvent>
#include <QPainter>
#include <QTabletEvent>
#include <cmath>

#include "desktop/engine/tablet_event_tilt.h"
#include "desktop/feel/feel_icons.h"

namespace felt::desktop {
namespace {

constexpr double kPxPerN = 24.0;     // length of the arrow
constexpr double kMinShownN = 0.03;  // shorter arrows would only flicker
constexpr std::size_t kTrail = 600;

}  // namespace

TestPad::TestPad(QWidget* parent) : QWidget(parent) {
  setAccessibleName(tr("Test pad"));
  setAccessibleDescription(tr("Press here with pen or mouse to try the device"));
  setMouseTracking(true);
  setAttribute(Qt::WA_TabletTracking);
  setCursor(Qt::CrossCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setMinimumHeight(6 * fontMetrics().height());
}

QSize TestPad::sizeHint() const {
  return {40 * fontMetrics().averageCharWidth(), 8 * fontMetrics().height()};
}

void TestPad::use(const QString& device_id, double strength, double limit_n) {
  device_id_ = device_id;
  strength_ = strength;
  limit_n_ = limit_n;
  if (isVisible()) open();
  update();
}

void TestPad::open() {
  studio_.reset();
  trail_.clear();
  if (device_id_.isEmpty()) return;
  StudioOptions options;
  options.device = device_id_;
  studio_ = std::make_unique<Studio>(std::move(options));
  studio_->loop().set_strength(strength_);
  studio_->loop().set_force_limit(limit_n_);
  connect(studio_.get(), &Studio::shown, this, &TestPad::follow);
}

void TestPad::showEvent(QShowEvent* event) {
  open();
  QWidget::showEvent(event);
}

void TestPad::hideEvent(QHideEvent* event) {
  studio_.reset();
  QWidget::hideEvent(event);
}

void TestPad::take(QMouseEvent* event) {
  point(event->position(), event->buttons().testFlag(Qt::LeftButton), std::nullopt);
  event->accept();
}

void TestPad::tabletEvent(QTabletEvent* event) {
  const bool touches = event->type() != QEvent::TabletRelease && event->pressure() > 0.0;
  point(event->position(), touches, event->pressure(), tilt_of(*event));
  event->accept();
}

void TestPad::point(QPointF px, bool touches, std::optional<double> pressure,
                    std::optional<double> tilt_deg) {
  if (!studio_) return;
  PointerEvent event;
  event.time_ns = studio_->now_ns();
  event.position = {px.x() / kScreenPxPerMm, px.y() / kScreenPxPerMm};
  event.touching = touches;
  event.pressure = pressure;
  event.tilt_deg = tilt_deg;
  studio_->point(event);
}

void TestPad::follow() {
  const PenSample& sample = studio_->pen().sample;
  const Point at = on_page(sample.position);
  const bool touches = in_contact(sample);
  const double pressure = sample.pressure.value_or(std::min(1.0, depth_mm(sample) / 3.0));
  trail_.push_back({QPointF(at.x, at.y) * kScreenPxPerMm, 1.0 + 6.0 * pressure, touches});
  if (trail_.size() > kTrail) trail_.pop_front();
  update();
}

void TestPad::paintEvent(QPaintEvent* event) {
  static_cast<void>(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(QPalette::Mid), 1));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  const QColor ink = palette().color(QPalette::Text);
  for (std::size_t i = 1; i < trail_.size(); ++i) {
    if (!trail_[i - 1].touches || !trail_[i].touches) continue;
    painter.setPen(QPen(ink, trail_[i].width_px, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(trail_[i - 1].px, trail_[i].px);
  }
  painter.setPen(palette().color(QPalette::Text));
  const QRect inner = rect().adjusted(8, 6, -8, -6);
  if (!studio_) {
    painter.drawText(inner, Qt::AlignCenter | Qt::TextWordWrap,
                     tr("Try this device on the drawing area."));
    return;
  }
  if (trail_.empty()) {
    painter.drawText(inner, Qt::AlignCenter, tr("Press here and feel"));
    return;
  }
  const Force& force = studio_->pen().asked;
  const double strength = norm(force);
  painter.drawText(inner, Qt::AlignLeft | Qt::AlignBottom,
                   tr("Force %L1 N").arg(strength, 0, 'f', 2));
  if (!(std::hypot(force.x, force.y) > kMinShownN)) return;
  const QPointF from = trail_.back().px, to = from + kPxPerN * QPointF(force.x, force.y);
  painter.setPen(QPen(palette().color(QPalette::Highlight), 2.5, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(from, to);
  painter.setBrush(palette().color(QPalette::Highlight));
  painter.drawEllipse(to, 2.5, 2.5);
}

}  // namespace felt::desktop
