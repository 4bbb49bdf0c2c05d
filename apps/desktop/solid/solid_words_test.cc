#include "desktop/solid/solid_words.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTranslator>

namespace felt::desktop::solid_words_test {
namespace {

// Marks every sentence that it translates.
class Marker : public QTranslator {
 public:
  [[nodiscard]] QString translate(const char* context, const char* source, const char*,
                                  int) const override {
    if (QLatin1String(context) != QLatin1String("SolidWords")) return {};
    return QLatin1Char('<') + QLatin1String(source) + QLatin1Char('>');
  }
  [[nodiscard]] bool isEmpty() const override { return false; }
};

// The texts of a source, without the parts that printf fills in.
QStringList texts_of(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QString source = QString::fromUtf8(file.readAll());
  source.remove(QRegularExpression(QStringLiteral("//[^\n]*|#include[^\n]*")));
  static const QRegularExpression kJoined(QStringLiteral("\"\\s*\"")),
      kText(QStringLiteral("\"([^\"\n]*)\"")),
      kFilledIn(QStringLiteral("%\\.?[0-9]*(?:[dfs]|zu)|%%"));
  source.remove(kJoined);
  QStringList texts;
  for (auto found = kText.globalMatch(source); found.hasNext();) {
    texts += found.next().captured(1).split(kFilledIn);
  }
  return texts;
}

// desktop.words checks that every sentence of the table is translated.
TEST(SolidWords, TheTableHasEverySentenceOfTheLibrary) {
  const QDir folder(QStringLiteral("src/felt/solid"));
  ASSERT_TRUE(folder.exists()) << "run this in the root of the repository";
  // The solid view uses neither the writers' sentences nor those of pictures.
  static const QRegularExpression kOther(
      QStringLiteral("_test\\.cc|_bench\\.cc|_writer\\.cc|solid_picture\\.cc"));
  const QString table = solid_sentences().join(QLatin1Char('\n'));
  int count = 0;
  for (const QString& name : folder.entryList({QStringLiteral("*.cc")})) {
    if (name.contains(kOther)) continue;
    for (QString text : texts_of(folder.filePath(name))) {
      text = text.trimmed();
      if (!text.contains(QRegularExpression(QStringLiteral("[a-z] [a-z]")))) continue;
      EXPECT_TRUE(table.contains(text)) << name.toStdString() << ": " << text.toStdString();
      ++count;
    }
  }
  EXPECT_GT(count, 50);
}

TEST(SolidWords, EverySentenceIsFoundWithWhatVaries) {
  Marker marker;
  QCoreApplication::installTranslator(&marker);
  for (const QString& row : solid_sentences()) {
    QString sentence = row, expected = QLatin1Char('<') + row + QLatin1Char('>');
    for (int i = 1; i <= 5; ++i) {
      for (QString* text : {&sentence, &expected}) {
        text->replace(QLatin1Char('%') + QString::number(i), QStringLiteral("-%1.25").arg(i));
      }
    }
    EXPECT_EQ(solid_words(sentence.toStdString()), expected + QLatin1Char('.'))
        << row.toStdString();
  }
  QCoreApplication::removeTranslator(&marker);
}

TEST(SolidWords, ASentenceMayContainAnotherOne) {
  EXPECT_EQ(solid_words("left out: edit 2 of the body, the cut that begins at (1.00, 2.00) mm: "
                        "the stroke begins on the body"),
            QStringLiteral("Left out: edit 2 of the body, the cut that begins at (1.00, 2.00) mm: "
                           "the stroke begins on the body."));
  Marker marker;
  QCoreApplication::installTranslator(&marker);
  EXPECT_EQ(
      solid_words("left out: stroke s3: the outline is too narrow at (1.00, -2.50) mm"),
      QStringLiteral("<left out: <stroke s3: <the outline is too narrow at (1.00, -2.50) mm>>>."));
  EXPECT_EQ(solid_words("the surfaces cannot be joined: a %1 of CGAL"),
            QStringLiteral("<the surfaces cannot be joined: a %1 of CGAL>."));
  QCoreApplication::removeTranslator(&marker);
}

TEST(SolidWords, ASentenceThatIsNotInTheTableStays) {
  EXPECT_EQ(solid_words("too little memory"), QStringLiteral("Too little memory."));
  EXPECT_EQ(solid_words(""), QString());
}

}  // namespace
}  // namespace felt::desktop::solid_words_test
