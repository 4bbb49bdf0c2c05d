#pragma once

#include <QFrame>
#include <QLabel>
#include <QToolButton>
#include <functional>
#include <vector>

class QHBoxLayout;

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

/// Says it above the sheet without being in the way: a line or two, buttons, "Details" with the
/// maker's own words, and a cross. It takes no focus; a screen reader is told. A new message takes
/// the place of the last.
class DeviceNotice : public QFrame {
  Q_OBJECT

 public:
  explicit DeviceNotice(QWidget* parent = nullptr);

  void say(DeviceMessage message);
  [[nodiscard]] const DeviceMessage& message() const noexcept { return message_; }
  /// Presses the button of that number, as a click does.
  void press(std::size_t button);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void draw_icon();

  DeviceMessage message_;
  QLabel* icon_;
  QLabel* text_;
  QHBoxLayout* buttons_;
  QToolButton* details_;
  QLabel* vendor_;
};

}  // namespace felt::desktop
