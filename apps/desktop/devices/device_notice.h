#pragma once

#include <QLabel>
#include <functional>
#include <vector>

#include "desktop/engine/message_bar.h"

namespace felt::desktop {

/// Something to know about a device, and what can be done about it.
struct DeviceMessage {
  struct Button {
    QString text;
    std::function<void()> press;
  };
  bool is_fault = false;
  QString text;
  QString details = {};  ///< the maker's own words; may be empty
  std::vector<Button> buttons = {};
};

/// Says it above the sheet, with buttons for what can be done, and the maker's own words on demand.
/// A new message takes the place of the last.
class DeviceNotice : public MessageBar {
  Q_OBJECT

 public:
  explicit DeviceNotice(QWidget* parent = nullptr);

  void say(DeviceMessage message);
  [[nodiscard]] const DeviceMessage& message() const noexcept { return message_; }
  /// Presses the button of that number, as a click does.
  void press(std::size_t button);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  DeviceNotice(QLabel* vendor, QWidget* parent);
  void draw_icon();

  DeviceMessage message_;
  QLabel* vendor_;
};

}  // namespace felt::desktop
