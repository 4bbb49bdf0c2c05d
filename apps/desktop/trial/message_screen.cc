#include "desktop/trial/message_screen.h"

#include <QVBoxLayout>
#include <algorithm>

namespace felt::desktop {
namespace {

constexpr int kMaxTextPx = 720;
constexpr int kTickMs = 100;

}  // namespace

QFont larger_font(const QWidget& widget, double factor) {
  QFont font = widget.font();
  font.setPointSizeF(factor * font.pointSizeF());
  return font;
}

MessageScreen::MessageScreen(QWidget* parent)
    : QWidget(parent),
      title_(new QLabel),
      text_(new QLabel),
      clock_(new QLabel),
      button_(new QPushButton),
      hint_(new QLabel) {
  title_->setFont(larger_font(*this, 2.2));
  text_->setFont(larger_font(*this, 1.4));
  clock_->setFont(larger_font(*this, 3.5));
  button_->setFont(larger_font(*this, 1.4));
  button_->setFocusPolicy(Qt::NoFocus);  // the window handles Space and Enter
  button_->setMinimumSize(260, 64);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(24);
  layout->addStretch(2);
  for (QLabel* label : {title_, text_, clock_}) {
    label->setWordWrap(true);
    label->setAlignment(Qt::AlignHCenter);
    label->setTextFormat(Qt::PlainText);
    label->setFixedWidth(kMaxTextPx);
    layout->addWidget(label, 0, Qt::AlignHCenter);
  }
  layout->addSpacing(12);
  layout->addWidget(button_, 0, Qt::AlignHCenter);
  layout->addWidget(hint_, 0, Qt::AlignHCenter);
  layout->addStretch(3);
  timer_.setInterval(kTickMs);
  connect(&timer_, &QTimer::timeout, this, &MessageScreen::tick);
  connect(button_, &QPushButton::clicked, this, &MessageScreen::proceeded);
}

void MessageScreen::show_message(const QString& title, const QString& text, const QString& button) {
  show_rest(title, text, button, 0.0);
}

void MessageScreen::show_rest(const QString& title, const QString& text, const QString& button,
                              double seconds) {
  title_->setText(title);
  text_->setText(text);
  for (QLabel* label : {title_, text_}) {
    label->setFixedHeight(label->heightForWidth(kMaxTextPx));  // the layout ignores wrapped lines
  }
  text_->setVisible(!text.isEmpty());
  button_->setText(button);
  hint_->setText(tr("or press Space"));
  rest_ms_ = static_cast<qint64>(1000.0 * seconds);
  clock_->setVisible(rest_ms_ > 0);
  since_.start();
  timer_.start();
  tick();
}

void MessageScreen::tick() {
  const qint64 left_ms = std::max<qint64>(0, rest_ms_ - since_.elapsed());
  const qint64 left_s = (left_ms + 999) / 1000;
  clock_->setText(
      QStringLiteral("%1:%2").arg(left_s / 60).arg(left_s % 60, 2, 10, QLatin1Char('0')));
  button_->setEnabled(left_ms == 0);
  hint_->setVisible(left_ms == 0);
  if (left_ms == 0) timer_.stop();
}

void MessageScreen::proceed() {
  if (button_->isEnabled()) Q_EMIT proceeded();
}

}  // namespace felt::desktop
