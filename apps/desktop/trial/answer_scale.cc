#include "desktop/trial/answer_scale.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

namespace felt::desktop {
namespace {

constexpr double kMarginPx = 16.0;
constexpr int kStepPx = 21;      // between two lines
constexpr int kWideStepPx = 52;  // between two circles
constexpr int kHeightPx = 44;

}  // namespace

AnswerScale::AnswerScale(int marks, Look look, QWidget* parent)
    : QWidget(parent), marks_(marks), look_(look) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize AnswerScale::sizeHint() const {
  const int step = look_ == Look::kLines ? kStepPx : kWideStepPx;
  return {step * (marks_ - 1) + static_cast<int>(2 * kMarginPx), kHeightPx};
}

double AnswerScale::x_of(int mark) const {
  return kMarginPx + mark * (width() - 2 * kMarginPx) / (marks_ - 1);
}

void AnswerScale::choose(int mark) {
  mark = std::clamp(mark, 0, marks_ - 1);
  if (choice_ == mark) return;
  choice_ = mark;
  setAccessibleDescription(tr("%1 of %2").arg(mark + 1).arg(marks_));
  update();
  Q_EMIT chosen();
}

void AnswerScale::choose_at(double x) {
  choose(static_cast<int>(std::lround((x - kMarginPx) / (width() - 2 * kMarginPx) * (marks_ - 1))));
}

void AnswerScale::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) choose_at(event->position().x());
}

void AnswerScale::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) choose_at(event->position().x());
}

void AnswerScale::keyPressEvent(QKeyEvent* event) {
  const int middle = marks_ / 2;
  switch (event->key()) {
    case Qt::Key_Left:
      return choose(choice_ ? *choice_ - 1 : middle);
    case Qt::Key_Right:
      return choose(choice_ ? *choice_ + 1 : middle);
    case Qt::Key_Home:
      return choose(0);
    case Qt::Key_End:
      return choose(marks_ - 1);
    case Qt::Key_Down:
      focusNextChild();
      return;
    case Qt::Key_Up:
      focusPreviousChild();
      return;
    default:
      QWidget::keyPressEvent(event);
  }
}

void AnswerScale::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double y = 0.5 * height();
  const QColor line = palette().color(QPalette::WindowText);
  const QColor accent = palette().color(QPalette::Highlight);
  if (hasFocus()) {
    painter.setPen(QPen(accent, 1.5));
    painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 5, 5);
  }
  QColor soft = line;
  soft.setAlpha(150);
  painter.setPen(QPen(soft, 1.5));
  if (look_ == Look::kLines) painter.drawLine(QPointF(x_of(0), y), QPointF(x_of(marks_ - 1), y));
  for (int i = 0; i < marks_; ++i) {
    const bool is_long = i == 0 || i == marks_ - 1 || 2 * i == marks_ - 1;
    const double half = is_long ? 11.0 : 7.0;
    if (look_ == Look::kLines) {
      painter.drawLine(QPointF(x_of(i), y - half), QPointF(x_of(i), y + half));
    } else {
      painter.drawEllipse(QPointF(x_of(i), y), 11.0, 11.0);
    }
  }
  if (!choice_) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(accent);
  painter.drawEllipse(QPointF(x_of(*choice_), y), 8.5, 8.5);
}

}  // namespace felt::desktop
