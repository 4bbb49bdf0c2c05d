#pragma once

#include <QFont>
#include <QPainter>
#include <QRect>
#include <QString>

namespace felt::desktop {

/// The hints on an empty page for a new user: three unobtrusive lines on how to draw, how to
/// correct and how to undo, and a line that says whether the pen senses pressure.
class FirstMinute {
 public:
  /// Sets the texts. `pull_key` is the shortcut of the pull tool, as in ToolInfo; `status` is the
  /// translated text about pressure.
  void set_text(char pull_key, const QString& status);
  /// Returns the rectangle of the hints in a widget of this size.
  [[nodiscard]] QRect area(QSize widget, const QFont& font) const;
  void paint(QPainter& painter, QSize widget, const QFont& font, const QColor& ink,
             const QColor& paper) const;
  /// Returns the whole text, for screen readers.
  [[nodiscard]] QString spoken() const;

 private:
  QString title_, text_, status_;
};

}  // namespace felt::desktop
