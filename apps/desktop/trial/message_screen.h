#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QWidget>

namespace felt::desktop {

/// A text in the middle of the screen with one button: the welcome, a rest, a trial that is
/// repeated, and the end.
class MessageScreen : public QWidget {
  Q_OBJECT

 public:
  explicit MessageScreen(QWidget* parent = nullptr);

  /// Shows a text. The button can be pressed at once.
  void show_message(const QString& title, const QString& text, const QString& button);
  /// Shows a text and counts down. The button can be pressed when `seconds` are over.
  void show_rest(const QString& title, const QString& text, const QString& button, double seconds);
  /// Presses the button, if it can be pressed.
  void proceed();

 Q_SIGNALS:
  /// Emitted when the button was pressed.
  void proceeded();

 private:
  void tick();

  QLabel* title_;
  QLabel* text_;
  QLabel* clock_;
  QPushButton* button_;
  QLabel* hint_;
  QTimer timer_;
  QElapsedTimer since_;
  qint64 rest_ms_ = 0;
};

/// Returns the font of the widget, enlarged for a text that is read from a distance.
QFont larger_font(const QWidget& widget, double factor);

}  // namespace felt::desktop
