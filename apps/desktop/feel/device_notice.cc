#include "desktop/feel/device_notice.h"

#include <QAccessible>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPushButton>
#include <QVBoxLayout>
#include <utility>

#include "desktop/feel/feel_icons.h"

namespace felt::desktop {
namespace {

constexpr int kMargin = 6;
constexpr int kIconPx = 18;

}  // namespace

DeviceNotice::DeviceNotice(QWidget* parent)
    : QFrame(parent),
      icon_(new QLabel(this)),
      text_(new QLabel(this)),
      buttons_(new QHBoxLayout),
      details_(new QToolButton(this)),
      vendor_(new QLabel(this)) {
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::AlternateBase);
  text_->setWordWrap(true);
  text_->setTextFormat(Qt::PlainText);
  vendor_->setWordWrap(true);
  vendor_->setTextFormat(Qt::PlainText);
  vendor_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  vendor_->setContentsMargins(kIconPx + kMargin, 0, 0, 0);
  vendor_->hide();
  details_->setText(tr("&Details"));
  details_->setCheckable(true);
  details_->setToolTip(tr("What the device itself says"));
  connect(details_, &QToolButton::toggled, vendor_, &QWidget::setVisible);
  auto* close = new QToolButton(this);
  close->setText(QStringLiteral("✕"));  // in the colour of the theme, which the style's icon is not
  close->setAutoRaise(true);
  close->setToolTip(tr("Close this message"));
  close->setAccessibleName(tr("Close this message"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* row = new QHBoxLayout;
  row->addWidget(icon_);
  row->addWidget(text_, 1);
  row->addLayout(buttons_);
  row->addWidget(details_);
  row->addWidget(close);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  all->addLayout(row);
  all->addWidget(vendor_);
  hide();
}

void DeviceNotice::say(DeviceMessage message) {
  message_ = std::move(message);
  text_->setText(message_.text);
  while (QLayoutItem* item = buttons_->takeAt(0)) {
    item->widget()->deleteLater();  // it may be the one that was pressed
    item->widget()->hide();
    delete item;
  }
  for (std::size_t i = 0; i < message_.buttons.size(); ++i) {
    auto* button = new QPushButton(message_.buttons[i].text, this);
    connect(button, &QPushButton::clicked, this, [this, i] { press(i); });
    buttons_->addWidget(button);
  }
  details_->setChecked(false);
  details_->setVisible(!message_.details.isEmpty());
  vendor_->setText(tr("The device says: %1").arg(message_.details));
  draw_icon();
  setAccessibleName(message_.text);
  show();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void DeviceNotice::press(std::size_t button) {
  if (button >= message_.buttons.size()) return;
  const auto act = message_.buttons[button].press;
  hide();
  if (act) act();
}

void DeviceNotice::draw_icon() {
  icon_->setPixmap(level_icon(message_.is_fault ? FeelLevel::kLimited : FeelLevel::kOn, palette(),
                              kIconPx, devicePixelRatioF()));
}

void DeviceNotice::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QFrame::keyPressEvent(event);
  hide();
}

void DeviceNotice::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) draw_icon();
  QFrame::changeEvent(event);
}

}  // namespace felt::desktop
