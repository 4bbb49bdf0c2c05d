#pragma once

#include <QObject>

class QSinglePointEvent;
class QWidget;

namespace felt::desktop {

/// Lets a press outside of an open pop-up (a menu, the list of a combo box) act on what is pressed.
/// The X11 platform of Qt only closes the pop-up, so that a line that begins there would be lost.
///
/// A press on the control that opened the pop-up only closes it, and a menu bar handles presses on
/// its titles itself. Handles the pop-ups of a window and of its dialogs. Use it in Qt's main
/// thread.
class PressThrough : public QObject {
  Q_OBJECT

 public:
  /// The window must outlive this object.
  explicit PressThrough(QWidget& window);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] bool is_ours(const QWidget& popup) const;
  bool pass_on(QSinglePointEvent& press);

  QWidget& window_;
};

}  // namespace felt::desktop
