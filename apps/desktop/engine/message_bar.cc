#include "desktop/engine/message_bar.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace felt::desktop {
namespace {

constexpr int kMargin = 6;

}  // namespace

MessageBar::MessageBar(QWidget* details, const QString& tip, QWidget* parent)
    : QFrame(parent),
      icon_(new QLabel(this)),
      text_(new QLabel(this)),
      extras_(new QHBoxLayout),
      details_(new QToolButton(this)) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  details_->setText(tr("&Details"));
  details_->setCheckable(true);
  details_->setToolTip(tip);
  connect(details_, &QToolButton::toggled, details, &QWidget::setVisible);
  connect(details_, &QToolButton::toggled, this, &MessageBar::details_toggled);
  auto* close = new QToolButton(this);
  close->setText(QStringLiteral("✕"));  // unlike an icon, text has the colour of the theme
  close->setAutoRaise(true);
  close->setToolTip(tr("Close this message"));
  close->setAccessibleName(tr("Close this message"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* row = new QHBoxLayout;
  row->addWidget(icon_);
  row->addWidget(text_, 1);
  row->addLayout(extras_);
  row->addWidget(details_);
  row->addWidget(close);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  all->addLayout(row);
  all->addWidget(details);
  details->hide();
  hide();
}

void MessageBar::set_icon(const QPixmap& icon) {
  icon_->setPixmap(icon);
}

void MessageBar::say(const QString& words, bool has_details) {
  text_->setText(words);
  details_->setChecked(false);
  details_->setVisible(has_details);
  setAccessibleName(words);
  show();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void MessageBar::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QFrame::keyPressEvent(event);
  hide();
}

}  // namespace felt::desktop
