#pragma once

#include <QFont>
#include <QPainter>
#include <QRect>
#include <QString>

namespace felt::desktop {

/// What an empty sheet says to somebody who is here for the first time: what to do, how to correct
/// it, how to take it back, and whether the pen's pressure is seen. Three quiet lines and one.
class FirstMinute {
 public:
  /// `pull_key` as in ToolInfo. `status`: of pressure, translated.
  void set_text(char pull_key, const QString& status);
  /// Where it stands, in a widget of this size.
  [[nodiscard]] QRect area(QSize widget, const QFont& font) const;
  void paint(QPainter& painter, QSize widget, const QFont& font, const QColor& ink,
             const QColor& paper) const;
  /// All of it, for those who hear it.
  [[nodiscard]] QString spoken() const;

 private:
  QString title_, text_, status_;
};

}  // namespace felt::desktop
