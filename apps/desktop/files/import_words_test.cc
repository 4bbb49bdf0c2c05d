#include "desktop/files/import_words.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QTranslator>

#include "felt/io/inkml/inkml_import.h"
#include "felt/io/svg/svg_import.h"
#include "felt/io/xopp/xopp_import.h"

namespace felt::desktop::import_words_test {
namespace {

// Marks every sentence that it translates.
class Marker : public QTranslator {
 public:
  [[nodiscard]] QString translate(const char* context, const char* source, const char*,
                                  int) const override {
    if (QLatin1String(context) != QLatin1String("ImportWords")) return {};
    return QLatin1Char('<') + QString::fromUtf8(source) + QLatin1Char('>');
  }
  [[nodiscard]] bool isEmpty() const override { return false; }
};

// The parts of the sentences that the source of a reader reports, without what varies.
QStringList reported_in(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return {};
  QString source = QString::fromUtf8(file.readAll());
  static const QRegularExpression kJoined(QStringLiteral("\"\\s*\"")),
      kCall(QStringLiteral("\\b(?:notice|say|say_of_image|check|notices\\.emplace_back)\\("
                           "[^;]*;")),
      kText(QStringLiteral("\"([^\"\n]*)\""));
  source.remove(kJoined);
  QStringList parts;
  for (auto call = kCall.globalMatch(source); call.hasNext();) {
    const QString arguments = call.next().captured();
    for (auto text = kText.globalMatch(arguments); text.hasNext();) {
      parts += text.next().captured(1);
    }
  }
  return parts;
}

TEST(ImportWords, TheTableHasEverySentenceOfTheReaders) {
  const QString table = import_sentences().join(QLatin1Char('\n'));
  int count = 0;
  for (const char* const format : {"svg", "xopp", "inkml"}) {
    const QDir folder(QStringLiteral("src/felt/io/") + QLatin1String(format));
    ASSERT_TRUE(folder.exists()) << "run this in the root of the repository";
    for (const QString& name : folder.entryList({QStringLiteral("*.cc")})) {
      if (name.contains(QStringLiteral("_test.cc"))) continue;
      for (const QString& part : reported_in(folder.filePath(name))) {
        const QString words = part.trimmed();
        if (!words.contains(QRegularExpression(QStringLiteral("[a-z] [a-z]")))) continue;
        EXPECT_TRUE(table.contains(words)) << name.toStdString() << ": " << words.toStdString();
        ++count;
      }
    }
  }
  EXPECT_GT(count, 100);
}

TEST(ImportWords, EverySentenceIsFoundWithWhatVaries) {
  Marker marker;
  QCoreApplication::installTranslator(&marker);
  for (const QString& row : import_sentences()) {
    QString sentence = row, expected = QLatin1Char('<') + row + QLatin1Char('>');
    for (int i = 1; i <= 2; ++i) {
      for (QString* text : {&sentence, &expected}) {
        text->replace(QLatin1Char('%') + QString::number(i), QStringLiteral("x%1").arg(i));
      }
    }
    EXPECT_EQ(import_words(sentence.toStdString()), expected) << row.toStdString();
  }
  QCoreApplication::removeTranslator(&marker);
}

// Sentences as the readers make them, not as the table expects them.
TEST(ImportWords, WhatTheReadersSayIsTranslated) {
  Marker marker;
  QCoreApplication::installTranslator(&marker);
  const Result<Imported> files[] = {
      import_svg("<svg xmlns='http://www.w3.org/2000/svg' width='50mm' height='50mm'><text>a</text>"
                 "<script/><use href='#none'/><animate/><path d='M1 1L20 20x' stroke='#000'/>"
                 "<path d='M1 1L9 9' stroke='nothing' filter='url(#f)' transform='turn'/>"
                 "<image href='a.png' width='5' height='5'/></svg>"),
      import_xopp("<xournal><page width='100' height='100'><background type='pdf'/><layer><text>a"
                  "</text><stroke tool='laser' color='?' width='1 2'>1 1 5 x 5</stroke></layer>"
                  "</page></xournal>"),
      import_inkml("<ink xmlns='http://www.w3.org/2003/InkML'><other/><trace>1 1, 20 20</trace>"
                   "<trace></trace></ink>")};
  int count = 0;
  for (const Result<Imported>& file : files) {
    ASSERT_TRUE(file) << file.error().message;
    for (const ImportNotice& notice : file->report.notices()) {
      EXPECT_TRUE(import_words(notice.what).startsWith(QLatin1Char('<'))) << notice.what;
      ++count;
    }
  }
  EXPECT_GE(count, 12);
  QCoreApplication::removeTranslator(&marker);
}

TEST(ImportWords, ASentenceThatIsNotInTheTableStays) {
  EXPECT_EQ(import_words("is new here"), QStringLiteral("is new here"));
}

}  // namespace
}  // namespace felt::desktop::import_words_test
