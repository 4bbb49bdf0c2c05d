#pragma once

#include <QFrame>
#include <QString>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace felt::desktop {

/// Something to know, said above the sheet without being in the way: an icon, a line or two, what a
/// subclass puts beside them, "Details" below on demand, and a cross. Escape in it closes it, too.
/// It takes no focus; a screen reader is told. Hidden until something is said.
class MessageBar : public QFrame {
  Q_OBJECT

 protected:
  /// `details` is shown and hidden by the button of that name, whose tool tip is `tip`; taken over.
  MessageBar(QWidget* details, const QString& tip, QWidget* parent);

  void keyPressEvent(QKeyEvent* event) override;

  void set_icon(const QPixmap& icon);
  /// Between the words and "Details".
  [[nodiscard]] QHBoxLayout& extras() noexcept { return *extras_; }
  /// Shows the bar with these words, the details hidden; whether there are any.
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
