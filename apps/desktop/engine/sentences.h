#pragma once

#include <QRegularExpression>
#include <QString>
#include <span>
#include <vector>

namespace felt::desktop {

/// Translates sentences that the library has only in English. A sentence of the table has %1, %2
/// ... for what varies; that may be a sentence of the table, too.
class Sentences {
 public:
  /// `context` is that of the translations. The sentences must outlive this object. A sentence that
  /// begins like another one comes before it if it is longer.
  Sentences(const char* context, std::span<const char* const> sentences);

  /// Translates a sentence, and those that it contains. A sentence that is not in the table stays.
  [[nodiscard]] QString translated(const QString& sentence) const;

 private:
  struct Pattern {
    const char* sentence;
    QRegularExpression expression;
  };

  [[nodiscard]] QString filled_in(const QString& text, const QRegularExpressionMatch& match) const;

  const char* context_;
  std::vector<Pattern> patterns_;
};

}  // namespace felt::desktop
