#include "desktop/panels/color_field.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>
#include <cmath>

namespace felt::desktop {
namespace {

constexpr double kFramePx = 2.0;  // margin around the colours, for the focus ring
constexpr double kRoundPx = 4.0;
constexpr double kKnobPx = 6.0;
constexpr double kStep = 0.01;
constexpr double kLargeStep = 0.1;
constexpr double kMaxHue = 359.0 / 360.0;  // a hue of 1 would be red again

QRectF inside(const QWidget& widget) {
  return QRectF(widget.rect()).adjusted(kFramePx, kFramePx, -kFramePx, -kFramePx);
}

double step_of(const QKeyEvent& event) {
  return event.modifiers().testFlag(Qt::ShiftModifier) ? kLargeStep : kStep;
}

QColor color_of(double hue, double saturation, double brightness) {
  return QColor::fromHsvF(static_cast<float>(std::clamp(hue, 0.0, kMaxHue)),
                          static_cast<float>(saturation), static_cast<float>(brightness));
}

void paint_frame(QPainter& painter, const QWidget& widget) {
  const bool focus = widget.hasFocus();
  painter.setBrush(Qt::NoBrush);
  const QPalette& palette = widget.palette();
  painter.setPen(QPen(palette.color(focus ? QPalette::Highlight : QPalette::Mid), focus ? 2 : 1));
  painter.drawRoundedRect(inside(widget).adjusted(-0.5, -0.5, 0.5, 0.5), kRoundPx, kRoundPx);
}

/// Paints a white and black knob, which is visible on every colour.
void paint_knob(QPainter& painter, const QRectF& knob) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Qt::black, 3.5));
  painter.drawRoundedRect(knob, kKnobPx, kKnobPx);
  painter.setPen(QPen(Qt::white, 1.8));
  painter.drawRoundedRect(knob, kKnobPx, kKnobPx);
}

}  // namespace

ShadeField::ShadeField(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::CrossCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setAccessibleName(tr("Saturation and brightness"));
  setToolTip(tr("Horizontal: saturation. Vertical: brightness. Change them with the arrow keys."));
}

void ShadeField::show_shade(double hue, double saturation, double brightness) {
  hue_ = hue;
  saturation_ = saturation;
  brightness_ = brightness;
  setAccessibleDescription(tr("Saturation %1 %, brightness %2 %")
                               .arg(std::lround(100 * saturation))
                               .arg(std::lround(100 * brightness)));
  update();
}

void ShadeField::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = inside(*this);
  QPainterPath shape;
  shape.addRoundedRect(area, kRoundPx, kRoundPx);
  QLinearGradient pale(area.topLeft(), area.topRight());
  pale.setColorAt(0.0, Qt::white);
  pale.setColorAt(1.0, color_of(hue_, 1.0, 1.0));
  painter.fillPath(shape, pale);
  QLinearGradient dark(area.topLeft(), area.bottomLeft());
  dark.setColorAt(0.0, QColor(0, 0, 0, 0));
  dark.setColorAt(1.0, Qt::black);
  painter.fillPath(shape, dark);
  paint_frame(painter, *this);
  const QPointF at(area.left() + saturation_ * area.width(),
                   area.top() + (1.0 - brightness_) * area.height());
  const QPointF knob(std::clamp(at.x(), area.left() + kKnobPx, area.right() - kKnobPx),
                     std::clamp(at.y(), area.top() + kKnobPx, area.bottom() - kKnobPx));
  paint_knob(painter, QRectF(knob - QPointF(kKnobPx, kKnobPx), QSizeF(2 * kKnobPx, 2 * kKnobPx)));
}

void ShadeField::take(QPointF at) {
  const QRectF area = inside(*this);
  choose((at.x() - area.left()) / area.width(), 1.0 - (at.y() - area.top()) / area.height());
}

void ShadeField::choose(double saturation, double brightness) {
  show_shade(hue_, std::clamp(saturation, 0.0, 1.0), std::clamp(brightness, 0.0, 1.0));
  Q_EMIT chosen(saturation_, brightness_);
}

void ShadeField::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) take(event->position());
}

void ShadeField::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) take(event->position());
}

void ShadeField::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) Q_EMIT settled();
}

void ShadeField::keyPressEvent(QKeyEvent* event) {
  const double step = step_of(*event);
  switch (event->key()) {
    case Qt::Key_Left:
      choose(saturation_ - step, brightness_);
      break;
    case Qt::Key_Right:
      choose(saturation_ + step, brightness_);
      break;
    case Qt::Key_Up:
      choose(saturation_, brightness_ + step);
      break;
    case Qt::Key_Down:
      choose(saturation_, brightness_ - step);
      break;
    default:
      return QWidget::keyPressEvent(event);
  }
  Q_EMIT settled();
}

HueStrip::HueStrip(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Expanding);
  setAccessibleName(tr("Hue"));
  setToolTip(tr("Hue. Change it with the arrow keys."));
}

void HueStrip::show_hue(double hue) {
  hue_ = hue;
  setAccessibleDescription(tr("%1 degrees").arg(std::lround(360 * hue)));
  update();
}

void HueStrip::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF area = inside(*this);
  QPainterPath shape;
  shape.addRoundedRect(area, kRoundPx, kRoundPx);
  QLinearGradient hues(area.topLeft(), area.bottomLeft());
  constexpr int kStops = 6;
  for (int i = 0; i <= kStops; ++i) {
    hues.setColorAt(double(i) / kStops, color_of(double(i % kStops) / kStops, 1.0, 1.0));
  }
  painter.fillPath(shape, hues);
  paint_frame(painter, *this);
  const double y = std::clamp(area.top() + hue_ * area.height(), area.top() + 4, area.bottom() - 4);
  paint_knob(painter, QRectF(area.left() + 1, y - 3.5, area.width() - 2, 7));
}

void HueStrip::choose(double hue) {
  show_hue(std::clamp(hue, 0.0, kMaxHue));
  Q_EMIT chosen(hue_);
}

void HueStrip::mousePressEvent(QMouseEvent* event) {
  const QRectF area = inside(*this);
  if (event->button() == Qt::LeftButton) {
    choose((event->position().y() - area.top()) / area.height());
  }
}

void HueStrip::mouseMoveEvent(QMouseEvent* event) {
  const QRectF area = inside(*this);
  if (event->buttons().testFlag(Qt::LeftButton)) {
    choose((event->position().y() - area.top()) / area.height());
  }
}

void HueStrip::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) Q_EMIT settled();
}

void HueStrip::keyPressEvent(QKeyEvent* event) {
  const double step = step_of(*event);
  if (event->key() == Qt::Key_Up || event->key() == Qt::Key_Left) {
    choose(hue_ - step);
  } else if (event->key() == Qt::Key_Down || event->key() == Qt::Key_Right) {
    choose(hue_ + step);
  } else {
    return QWidget::keyPressEvent(event);
  }
  Q_EMIT settled();
}

ColorField::ColorField(QWidget* parent)
    : QWidget(parent), shade_(new ShadeField(this)), strip_(new HueStrip(this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  row->addWidget(shade_, 1);
  row->addWidget(strip_);
  connect(shade_, &ShadeField::chosen, this, [this](double saturation, double brightness) {
    saturation_ = saturation;
    brightness_ = brightness;
    Q_EMIT chosen(color());
  });
  connect(strip_, &HueStrip::chosen, this, [this](double hue) {
    hue_ = hue;
    show_all();
    Q_EMIT chosen(color());
  });
  connect(shade_, &ShadeField::settled, this, &ColorField::settled);
  connect(strip_, &HueStrip::settled, this, &ColorField::settled);
  show_all();
}

QColor ColorField::color() const {
  return color_of(hue_, saturation_, brightness_).toRgb();
}

void ColorField::show_color(const QColor& color) {
  // If the field already shows this colour, rounded to bytes, it keeps its own hue and saturation,
  // which are more exact.
  if (this->color().rgb() == color.rgb()) return;
  const QColor hsv = color.toHsv();
  if (hsv.hsvHueF() >= 0.0F) hue_ = static_cast<double>(hsv.hsvHueF());
  if (hsv.valueF() > 0.0F) saturation_ = static_cast<double>(hsv.hsvSaturationF());
  brightness_ = static_cast<double>(hsv.valueF());
  show_all();
}

void ColorField::show_all() {
  shade_->show_shade(hue_, saturation_, brightness_);
  strip_->show_hue(hue_);
}

}  // namespace felt::desktop
