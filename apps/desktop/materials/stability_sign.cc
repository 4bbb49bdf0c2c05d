#include "desktop/materials/stability_sign.h"

#include <QEvent>
#include <QGridLayout>

#include "desktop/feel/feel_icons.h"

namespace felt::desktop {
namespace {

constexpr int kSignPx = 26;

FeelLevel sign_of(StabilityLevel level) {
  switch (level) {
    case StabilityLevel::kGiven:
      return FeelLevel::kOn;
    case StabilityLevel::kLess:
      return FeelLevel::kLimited;
    case StabilityLevel::kNotGiven:
      break;
  }
  return FeelLevel::kStopped;
}

/// Returns green, amber or red, with a contrast of at least 3:1 on light and on dark backgrounds.
QColor color_of(StabilityLevel level, bool is_dark) {
  switch (level) {
    case StabilityLevel::kGiven:
      return is_dark ? QColor(0x6f, 0xcf, 0x7c) : QColor(0x1d, 0x7f, 0x37);
    case StabilityLevel::kLess:
      return is_dark ? QColor(0xf0, 0xb4, 0x3c) : QColor(0xa3, 0x62, 0x00);
    case StabilityLevel::kNotGiven:
      break;
  }
  return is_dark ? QColor(0xff, 0x7d, 0x6e) : QColor(0xc0, 0x32, 0x26);
}

}  // namespace

StabilitySign::StabilitySign(QWidget* parent)
    : QWidget(parent),
      sign_(new QLabel(this)),
      state_(new QLabel(this)),
      number_(new QLabel(this)),
      detail_(new QLabel(this)) {
  setAccessibleName(tr("Stability"));
  QFont strong = font();
  strong.setBold(true);
  state_->setFont(strong);
  for (QLabel* label : {state_, number_, detail_}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    label->setFocusPolicy(Qt::NoFocus);
  }
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins({});
  grid->setVerticalSpacing(1);
  grid->addWidget(sign_, 0, 0, 2, 1, Qt::AlignTop);
  grid->addWidget(state_, 0, 1);
  grid->addWidget(number_, 1, 1);
  grid->addWidget(detail_, 2, 0, 1, 2);
  grid->setColumnStretch(1, 1);
}

void StabilitySign::show_words(const StabilityWords& words) {
  words_ = words;
  state_->setText(words.state);
  number_->setText(words.number);
  detail_->setText(words.detail.join(QLatin1Char('\n')));
  detail_->setVisible(!words.detail.isEmpty());
  setAccessibleDescription(
      QStringList({words.state, words.number, words.detail.join(QLatin1Char(' '))})
          .join(QStringLiteral(". ")));
  draw_sign();
}

void StabilitySign::draw_sign() {
  QPalette colors = palette();
  const bool is_dark = colors.color(QPalette::Window).lightness() < 128;
  colors.setColor(QPalette::WindowText, color_of(words_.level, is_dark));
  sign_->setPixmap(level_icon(sign_of(words_.level), colors, kSignPx, devicePixelRatioF()));
  sign_->setAccessibleName(words_.state);
}

void StabilitySign::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) draw_sign();
}

}  // namespace felt::desktop
