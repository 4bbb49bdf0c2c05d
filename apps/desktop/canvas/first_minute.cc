#include "desktop/canvas/first_minute.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QKeySequence>
#include <cctype>

#include "desktop/canvas/marks.h"

namespace felt::desktop {
namespace {

constexpr double kTitleSize = 1.7, kTextSize = 1.15;  // factors of the program's font size
constexpr double kQuiet = 0.62;                       // share of the ink's colour in the colour of
                                                      // the text; the rest is the paper's colour

QString first_minute_text(const char* text) {
  return QCoreApplication::translate("FirstMinute", text);
}

QFont sized(QFont font, double factor) {
  if (font.pointSizeF() > 0) {
    font.setPointSizeF(font.pointSizeF() * factor);
  } else {
    font.setPixelSize(qRound(font.pixelSize() * factor));
  }
  return font;
}

}  // namespace

void FirstMinute::set_text(char pull_key, const QString& status) {
  const QString key(
      QLatin1Char(static_cast<char>(std::toupper(static_cast<unsigned char>(pull_key)))));
  const QString undo = QKeySequence(QKeySequence::Undo).toString(QKeySequence::NativeText);
  title_ = first_minute_text(QT_TRANSLATE_NOOP("FirstMinute", "Draw with the pen or the mouse."));
  text_ =
      first_minute_text(
          QT_TRANSLATE_NOOP("FirstMinute", "To correct a line, press %1 and pull it into shape."))
          .arg(key) +
      QLatin1Char('\n') +
      first_minute_text(QT_TRANSLATE_NOOP("FirstMinute",
                                          "%1 undoes a step. The Help menu has a two-minute tour."))
          .arg(undo);
  status_ = status;
}

QRect FirstMinute::area(QSize widget, const QFont& font) const {
  const double title = QFontMetricsF(sized(font, kTitleSize)).height();
  const double line = QFontMetricsF(sized(font, kTextSize)).lineSpacing();
  const double height = 2.2 * title + 5.4 * line;
  return QRectF(0, (widget.height() - height) / 2, widget.width(), height).toAlignedRect();
}

void FirstMinute::paint(QPainter& painter, QSize widget, const QFont& font, const QColor& ink,
                        const QColor& paper) const {
  QRectF rest = area(widget, font);
  const auto write = [&](const QString& text, const QFont& face, double share) {
    painter.setFont(face);
    painter.setPen(mixed(paper, ink, share));
    QRectF used;
    painter.drawText(rest, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, text, &used);
    rest.setTop(used.bottom());
  };
  write(title_, sized(font, kTitleSize), 0.8);
  rest.translate(0, QFontMetricsF(font).height() * 0.5);
  for (const QString& line : text_.split(QLatin1Char('\n'))) {
    write(line, sized(font, kTextSize), kQuiet);
    rest.translate(0, QFontMetricsF(font).height() * 0.3);
  }
  rest.translate(0, QFontMetricsF(font).height() * 0.7);
  write(status_, font, kQuiet);
}

QString FirstMinute::spoken() const {
  return title_ + QLatin1Char('\n') + text_ + QLatin1Char('\n') + status_;
}

}  // namespace felt::desktop
