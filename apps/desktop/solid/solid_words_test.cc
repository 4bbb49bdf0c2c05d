#include "desktop/solid/solid_words.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTranslator>
#include <string>
#include <utility>
#include <vector>

#include "felt/document/edit_builder.h"
#include "felt/fill/testing/map_drawing.h"
#include "felt/solid/body_edits.h"
#include "felt/solid/inflate.h"

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

// The words of a part of a sentence, without what stands around them and between numbers.
QString words_of(const QString& part) {
  static const QRegularExpression kAround(
      QStringLiteral("^(?:[^a-z]|mm\\b|at )+|(?:[^a-z]| mm| x| at)+$"));
  QString words = part;
  for (QString before; before != words;) {
    before = words;
    words.remove(kAround);
  }
  return words;
}

// The parts of all sentences of the table, without what varies. A part before or after a colon may
// be a sentence of its own.
QStringList parts_of_table() {
  static const QRegularExpression kVaries(QStringLiteral("%\\d"));
  QStringList parts;
  for (const QString& sentence : solid_sentences()) {
    for (const QString& part : sentence.split(kVaries)) {
      parts += words_of(part);
      for (const QString& piece : part.split(QStringLiteral(": "))) parts += words_of(piece);
    }
  }
  return parts;
}

// desktop.words checks that every sentence of the table is translated.
TEST(SolidWords, TheTableHasEverySentenceOfTheLibrary) {
  const QDir folder(QStringLiteral("src/felt/solid"));
  ASSERT_TRUE(folder.exists()) << "run this in the root of the repository";
  // The solid view uses neither the writers' sentences nor those of pictures.
  static const QRegularExpression kOther(
      QStringLiteral("_test\\.cc|_bench\\.cc|_writer\\.cc|solid_picture\\.cc"));
  // The parts of sentences that are put together by a kind or a number: the tests of sentences of
  // outlines and of edits make these.
  const QStringList spliced = {QStringLiteral("painted line"), QStringLiteral("of the body, the"),
                               QStringLiteral("that begins"), QStringLiteral("small closed"),
                               QStringLiteral("lines, the largest")};
  const QStringList table = parts_of_table() + spliced;
  int count = 0;
  for (const QString& name : folder.entryList({QStringLiteral("*.cc")})) {
    if (name.contains(kOther)) continue;
    for (const QString& text : texts_of(folder.filePath(name))) {
      const QString words = words_of(text);
      if (!words.contains(QRegularExpression(QStringLiteral("[a-z] [a-z]")))) continue;
      EXPECT_TRUE(table.contains(words)) << name.toStdString() << ": " << words.toStdString();
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
  EXPECT_EQ(solid_words("left out: stroke %2: %1 is %3"),
            QStringLiteral("<left out: <stroke %2: %1 is %3>>."))
      << "what is inserted stays";
  EXPECT_EQ(solid_words("left out: two\nlines"), QStringLiteral("<left out: two\nlines>."));
  QCoreApplication::removeTranslator(&marker);
}

TEST(SolidWords, ASentenceAboutTheDrawingHasASubject) {
  EXPECT_EQ(solid_words("contains no closed outline"),
            QStringLiteral("The drawing contains no closed outline."));
  EXPECT_EQ(solid_words("has more than 100,000 visible strokes"),
            QStringLiteral("The drawing has more than 100,000 visible strokes."));
}

// The Marker must be installed. A reason within a sentence must be translated, too.
void expect_translated(const std::string& sentence) {
  const QString words = solid_words(sentence);
  EXPECT_TRUE(words.startsWith(QLatin1Char('<')) && words.endsWith(QLatin1String(">.")))
      << words.toStdString();
  // After "left out: edit ... mm: " and similar beginnings comes a marked sentence.
  const qsizetype colon = words.lastIndexOf(QLatin1String(" mm: "));
  if (words.contains(QLatin1String("of the body, the"))) {
    EXPECT_EQ(words.mid(colon + 5, 1), QStringLiteral("<")) << words.toStdString();
  }
}

StrokePtr line(const std::vector<Point>& corners) {
  return felt::testing::stroke_of(felt::testing::lines_through(corners));
}

std::vector<std::string> sentences_of(const std::vector<StrokePtr>& strokes, FaultChoice faults) {
  Document document;
  EditBuilder edit(document);
  for (const StrokePtr& stroke : strokes) edit.add(document.layers().back().id, stroke);
  EXPECT_TRUE(document.apply(std::move(edit).build("Draw")).has_value());
  const Result<InflatedDrawing> inflated = inflate(document, {.faults = faults});
  return inflated ? inflated->notes : std::vector<std::string>{inflated.error().message};
}

// Sentences as the library makes them, not as the table expects them.
TEST(SolidWords, TheSentencesOfOutlinesAreTranslated) {
  Marker marker;
  QCoreApplication::installTranslator(&marker);
  const StrokePtr triangle = line({{0, 0}, {20, 20}, {0, 40}, {0, 0}});
  const StrokePtr touching = line({{20, 20}, {40, 5}, {40, 35}, {20, 20}});
  const auto speck = [](double x) { return line({{x, 50}, {x + 0.5, 50}, {x, 50.5}, {x, 50}}); };
  const std::vector<std::vector<StrokePtr>> drawings = {
      {},
      {line({{0, 0}, {40, 0}})},
      {line({{0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 5}})},
      {line({{0, 0}, {40, 40}, {40, 0}, {0, 40}, {0, 0}})},
      {triangle, touching},
      {line({{20, 20}, {0, 0}, {0, 20}}), line({{0, 20}, {0, 40}, {20, 20}}), touching},
      {speck(0)},
      {triangle, speck(50)},
      {triangle, speck(50), speck(60)}};
  int count = 0;
  for (const FaultChoice faults : {FaultChoice::kRefuse, FaultChoice::kLeaveOut}) {
    for (std::size_t i = 0; i < drawings.size(); ++i) {
      SCOPED_TRACE(i);
      const std::vector<std::string> sentences = sentences_of(drawings[i], faults);
      EXPECT_FALSE(sentences.empty());
      for (const std::string& sentence : sentences) expect_translated(sentence), ++count;
    }
  }
  EXPECT_GE(count, 18);
  QCoreApplication::removeTranslator(&marker);
}

TEST(SolidWords, TheSentencesOfEditsAreTranslated) {
  Marker marker;
  QCoreApplication::installTranslator(&marker);
  Document document;
  EditBuilder drawn(document);
  drawn.add(document.layers().back().id, line({{30, 30}, {70, 30}, {70, 70}, {30, 70}, {30, 30}}));
  ASSERT_TRUE(document.apply(std::move(drawn).build("Draw")).has_value());
  const Result<InflatedDrawing> square = inflate(document, {.triangles = 1000});
  ASSERT_TRUE(square);
  const std::vector<Vec3> through{{50, -20, 0}, {50, -80, 0}}, beside{{0, 0, 0}, {5, 0, 0}};
  const std::vector<Vec3> closed{{45, -45, 0}, {55, -45, 0}, {55, -55, 0}, {45, -55, 0}};
  const std::vector<BodyEdit> edits = {
      {.kind = BodyEditKind::kCut, .path_mm = beside},
      {.kind = BodyEditKind::kCut, .path_mm = {{50, -20, 0}, {50, -50, 0}}},
      {.kind = BodyEditKind::kCut, .path_mm = {{50, -50, 0}, {50, -80, 0}}},
      {.kind = BodyEditKind::kCut, .path_mm = {{0, 0, 0}, {0, 0, 0}}},
      {.kind = BodyEditKind::kCut,
       .path_mm = {{20, -40, 0}, {80, -40, 0}, {80, -20, 0}, {60, -20, 0}, {60, -80, 0}}},
      {.kind = BodyEditKind::kExtrude, .path_mm = beside},
      {.kind = BodyEditKind::kExtrude, .path_mm = closed},
      {.kind = BodyEditKind::kExtrude,
       .path_mm = closed,
       .profile_mm = {{45, -50, 5}, {50, -50, 6}, {45, -50, 5}}},
      {.kind = BodyEditKind::kExtrude,
       .path_mm = closed,
       .profile_mm = {{45, -50, 5}, {50, -50, -5}, {55, -50, 5}}},
      {.kind = BodyEditKind::kExtrude,
       .path_mm = {{45, -45, 0}, {55, -55, 0}, {55, -45, 0}, {45, -55, 0}},
       .profile_mm = {{45, -50, 5}, {50, -50, 9}, {55, -50, 5}}},
      {.kind = BodyEditKind::kPaint, .path_mm = beside, .width_mm = 1.0},
      {.kind = BodyEditKind::kPaint, .path_mm = through, .width_mm = 0.0},
      {.kind = BodyEditKind::kSmooth, .path_mm = beside, .width_mm = 5.0},
  };
  const EditedSolid after = apply_body_edits(square->solid, edits);
  ASSERT_EQ(after.refusals.size(), edits.size());
  for (std::size_t i = 0; i < edits.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_NE(after.refusals[i], "") << "it is refused";
    expect_translated(after.refusals[i]);
    expect_translated(after.reasons[i]);
  }
  QCoreApplication::removeTranslator(&marker);
}

TEST(SolidWords, ASentenceThatIsNotInTheTableStays) {
  EXPECT_EQ(solid_words("too little memory"), QStringLiteral("Too little memory."));
  EXPECT_EQ(solid_words(""), QString());
}

}  // namespace
}  // namespace felt::desktop::solid_words_test
