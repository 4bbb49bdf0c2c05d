#pragma once

#include <QLabel>
#include <functional>
#include <vector>

#include "desktop/engine/message_bar.h"

namespace felt::desktop {

/// A message about a device, with buttons for possible actions.
struct DeviceMessage {
  struct Button {
    QString text;
    std::function<void()> press;
  };
  bool is_fault = false;
  QString text;
  QString details = {};  ///< the vendor's own message; may be empty
  std::vector<Button> buttons = {};
};

/// Shows a message with its buttons over the canvas. The button "Details" shows the vendor's own
/// message. A new message replaces the previous one.
class DeviceNotice : public MessageBar {
  Q_OBJECT

 public:
  explicit DeviceNotice(QWidget* parent = nullptr);

  void say(DeviceMessage message);
  [[nodiscard]] const DeviceMessage& message() const noexcept { return message_; }
  /// Presses the button with the index `button`, as a click does.
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
