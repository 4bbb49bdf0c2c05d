#pragma once

#include <QFrame>
#include <QString>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace felt::desktop {

/// A message over the upper edge of the canvas that does not block work. It has an icon, one or two
/// lines of text, the widgets of a subclass beside the text, a close button, and details that a
/// button "Details" shows below. Escape also closes the bar. The bar does not get the focus; screen
/// readers announce the message. Without a message, the bar is hidden.
class MessageBar : public QFrame {
  Q_OBJECT

 protected:
  /// The "Details" button, whose tool tip is `tip`, shows and hides `details`. Takes ownership of
  /// `details`.
  MessageBar(QWidget* details, const QString& tip, QWidget* parent);

  void keyPressEvent(QKeyEvent* event) override;

  void set_icon(const QPixmap& icon);
  /// Returns the layout between the text and "Details".
  [[nodiscard]] QHBoxLayout& extras() noexcept { return *extras_; }
  /// Shows the bar with this text and hides the details. The "Details" button is visible if
  /// `has_details`.
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
