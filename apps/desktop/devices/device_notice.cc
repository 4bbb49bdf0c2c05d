#include "desktop/devices/device_notice.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPushButton>
#include <utility>

#include "desktop/feel/feel_icons.h"

namespace felt::desktop {
namespace {

constexpr int kNoticeIconPx = 18;
constexpr int kIndentPx = 24;  // the text stands beside the icon

}  // namespace

DeviceNotice::DeviceNotice(QWidget* parent) : DeviceNotice(new QLabel, parent) {}

DeviceNotice::DeviceNotice(QLabel* vendor, QWidget* parent)
    : MessageBar(vendor, tr("Message from the device itself"), parent), vendor_(vendor) {
  vendor_->setWordWrap(true);
  vendor_->setTextFormat(Qt::PlainText);
  vendor_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  vendor_->setContentsMargins(kIndentPx, 0, 0, 0);
}

void DeviceNotice::say(DeviceMessage message) {
  message_ = std::move(message);
  while (QLayoutItem* item = extras().takeAt(0)) {
    item->widget()->deleteLater();  // deferred, because the signal may come from this button
    item->widget()->hide();
    delete item;
  }
  for (std::size_t i = 0; i < message_.buttons.size(); ++i) {
    auto* button = new QPushButton(message_.buttons[i].text, this);
    connect(button, &QPushButton::clicked, this, [this, i] { press(i); });
    extras().addWidget(button);
  }
  vendor_->setText(tr("Message from the device: %1").arg(message_.details));
  draw_icon();
  MessageBar::say(message_.text, !message_.details.isEmpty());
}

void DeviceNotice::press(std::size_t button) {
  if (button >= message_.buttons.size()) return;
  const auto act = message_.buttons[button].press;
  hide();
  if (act) act();
}

void DeviceNotice::draw_icon() {
  set_icon(level_icon(message_.is_fault ? FeelLevel::kLimited : FeelLevel::kOn, palette(),
                      kNoticeIconPx, devicePixelRatioF()));
}

void DeviceNotice::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) draw_icon();
  MessageBar::changeEvent(event);
}

}  // namespace felt::desktop
