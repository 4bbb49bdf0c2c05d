#include "desktop/engine/sentences.h"

#include <QCoreApplication>

namespace felt::desktop {

Sentences::Sentences(const char* context, std::span<const char* const> sentences)
    : context_(context) {
  static const QRegularExpression kVaries(QStringLiteral("%\\d"));
  for (const char* const sentence : sentences) {
    QString text = QRegularExpression::escape(QString::fromUtf8(sentence));
    text.replace(QStringLiteral("\\%"), QStringLiteral("%"));  // as escape() wrote it
    text.replace(kVaries, QStringLiteral("(.+?)"));
    patterns_.push_back(
        {sentence, QRegularExpression(QRegularExpression::anchoredPattern(text),
                                      QRegularExpression::DotMatchesEverythingOption)});
  }
}

/// Replaces %1, %2 ... in `text` by what the match captured, translated. What is inserted stays as
/// it is, even if it contains a %1.
QString Sentences::filled_in(const QString& text, const QRegularExpressionMatch& match) const {
  QString filled;
  for (qsizetype i = 0; i < text.size(); ++i) {
    const int number = text[i] == QLatin1Char('%') ? text.mid(i + 1, 1).toInt() : 0;
    if (number < 1 || number > match.lastCapturedIndex()) {
      filled += text[i];
    } else {
      filled += translated(match.captured(number));
      ++i;
    }
  }
  return filled;
}

QString Sentences::translated(const QString& sentence) const {
  for (const Pattern& pattern : patterns_) {
    const QRegularExpressionMatch match = pattern.expression.match(sentence);
    if (!match.hasMatch()) continue;
    return filled_in(QCoreApplication::translate(context_, pattern.sentence), match);
  }
  return sentence;
}

}  // namespace felt::desktop
