#include "desktop/pens/pressure_curve_editor.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace felt::desktop {
namespace {

constexpr double kHandlePx = 6.0;
constexpr double kMarginPx = 9.0;  // space for a handle in the corner
constexpr double kKeyStep = 0.02;
constexpr int kPieces = 64;

}  // namespace

PressureCurveEditor::PressureCurveEditor(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Pressure curve"));
  setAccessibleDescription(
      tr("From the pressure of the pen (left to right) to the width of the line (bottom to top). "
         "The arrow keys move a handle; Space selects the other one."));
  setToolTip(tr("Drag the two handles. Higher is wider."));
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

QSize PressureCurveEditor::sizeHint() const {
  const int side = fontMetrics().height() * 11;
  return {side, side};
}

QSize PressureCurveEditor::minimumSizeHint() const {
  const int side = fontMetrics().height() * 8;
  return {side, side};
}

QRectF PressureCurveEditor::square() const {
  const double side = std::max(1.0, std::min(width(), height()) - 2.0 * kMarginPx);
  return {(width() - side) / 2, (height() - side) / 2, side, side};
}

QPointF PressureCurveEditor::to_px(QPointF unit) const {
  const QRectF box = square();
  return {box.left() + unit.x() * box.width(), box.bottom() - unit.y() * box.height()};
}

QPointF PressureCurveEditor::to_unit(QPointF px) const {
  const QRectF box = square();
  return {(px.x() - box.left()) / box.width(), (box.bottom() - px.y()) / box.height()};
}

/// Returns the position of a handle. It lies to the right of the threshold, as the curve does.
QPointF PressureCurveEditor::handle(int which) const {
  const QPointF at = which == 0 ? curve_.first() : curve_.second();
  const double start = curve_.threshold();
  return {start + (1.0 - start) * at.x(), at.y()};
}

void PressureCurveEditor::move_handle(int which, QPointF to) {
  const double start = curve_.threshold();
  const QPointF at((to.x() - start) / (1.0 - start), to.y());
  curve_ = which == 0 ? PressureCurve(at, curve_.second(), start)
                      : PressureCurve(curve_.first(), at, start);
  update();
  Q_EMIT edited(curve_);
}

void PressureCurveEditor::set_curve(const PressureCurve& curve) {
  curve_ = curve;
  update();
}

void PressureCurveEditor::show_raw(double raw) {
  raw_ = raw;
  update();
}

void PressureCurveEditor::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF box = square();
  const QPalette& colors = palette();
  painter.fillRect(box, colors.color(QPalette::Base));
  QColor faint = colors.color(QPalette::Text);
  faint.setAlphaF(0.15F);
  painter.setPen(QPen(faint, 1.0));
  for (int i = 1; i < 4; ++i) {
    painter.drawLine(to_px({i / 4.0, 0}), to_px({i / 4.0, 1}));
    painter.drawLine(to_px({0, i / 4.0}), to_px({1, i / 4.0}));
  }
  painter.drawRect(box);
  const QColor ink =
      colors.color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Text);
  QPainterPath path(to_px({0, 0}));
  for (int i = 0; i <= kPieces; ++i) {
    const double raw = curve_.threshold() + (1.0 - curve_.threshold()) * i / kPieces;
    path.lineTo(to_px({raw, curve_(raw)}));
  }
  painter.setPen(QPen(ink, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  const QColor accent = colors.color(QPalette::Highlight);
  for (int which = 0; which < 2; ++which) {
    const QPointF at = to_px(handle(which));
    painter.setPen(QPen(faint, 1.5));
    painter.drawLine(to_px(which == 0 ? QPointF(curve_.threshold(), 0) : QPointF(1, 1)), at);
    const bool chosen = hasFocus() && which == chosen_;
    painter.setPen(QPen(chosen ? ink : accent, 2.0));
    painter.setBrush(chosen ? accent : colors.color(QPalette::Base));
    painter.drawEllipse(at, kHandlePx, kHandlePx);
  }
  if (raw_ <= 0.0) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(ink);
  painter.drawEllipse(to_px({raw_, curve_(raw_)}), kHandlePx - 1, kHandlePx - 1);
}

void PressureCurveEditor::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  const auto away = [&](int which) {
    return (to_px(handle(which)) - event->position()).manhattanLength();
  };
  chosen_ = away(0) <= away(1) ? 0 : 1;
  drags_ = true;
  move_handle(chosen_, to_unit(event->position()));
}

void PressureCurveEditor::mouseMoveEvent(QMouseEvent* event) {
  if (drags_) move_handle(chosen_, to_unit(event->position()));
}

void PressureCurveEditor::mouseReleaseEvent(QMouseEvent*) {
  drags_ = false;
}

void PressureCurveEditor::keyPressEvent(QKeyEvent* event) {
  QPointF step;
  switch (event->key()) {
    case Qt::Key_Left:
      step = {-kKeyStep, 0};
      break;
    case Qt::Key_Right:
      step = {kKeyStep, 0};
      break;
    case Qt::Key_Up:
      step = {0, kKeyStep};
      break;
    case Qt::Key_Down:
      step = {0, -kKeyStep};
      break;
    case Qt::Key_Space:
      chosen_ = 1 - chosen_;
      update();
      return;
    default:
      return QWidget::keyPressEvent(event);
  }
  move_handle(chosen_, handle(chosen_) + step);
}

}  // namespace felt::desktop
