#pragma once

#include <QFrame>
#include <QString>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace felt::desktop {

/// A message above the canvas that does not block work: an icon, a line or two, widgets of a
/// subclass beside them, "Details" below on demand, and a close button. Escape closes it, too. It
/// takes no focus, and screen readers announce it. Hidden until there is a message.
class MessageBar : public QFrame {
  Q_OBJECT

 protected:
  /// `details` is shown and hidden by the "Details" button, whose tool tip is `tip`. Takes
  /// ownership.
  MessageBar(QWidget* details, const QString& tip, QWidget* parent);

  void keyPressEvent(QKeyEvent* event) override;

  void set_icon(const QPixmap& icon);
  /// Returns the layout between the text and "Details".
  [[nodiscard]] QHBoxLayout& extras() noexcept { return *extras_; }
  /// Shows the bar with this text and the details hidden. `has_details`: whether there are any.
  void say(const QString& words, bool has_details);

 Q_SIGNALS:
  void details_toggled(bool on);

 private:
  QLabel* icon_;
  QLabel* text_;
  QHBoxLayout* extras_;
  QToolButton* details_;
};

}  // namespace felt::desktop
