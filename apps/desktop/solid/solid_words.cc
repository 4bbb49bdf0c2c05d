#include "desktop/solid/solid_words.h"

#include <QCoreApplication>

#include "desktop/engine/sentences.h"
#include "desktop/engine/text_of.h"

namespace felt::desktop {
namespace {

// A sentence that begins like another one comes before it if it is longer.
constexpr const char* kSentences[] = {
    // What was left out.
    QT_TRANSLATE_NOOP("SolidWords",
                      "left out: edit %1 of the body, the cut that begins at (%2, %3) mm: %4"),
    QT_TRANSLATE_NOOP(
        "SolidWords",
        "left out: edit %1 of the body, the extrusion that begins at (%2, %3) mm: %4"),
    QT_TRANSLATE_NOOP(
        "SolidWords",
        "left out: edit %1 of the body, the painted line that begins at (%2, %3) mm: %4"),
    QT_TRANSLATE_NOOP(
        "SolidWords",
        "left out: edit %1 of the body, the smoothing that begins at (%2, %3) mm: %4"),
    QT_TRANSLATE_NOOP("SolidWords", "left out the smaller part: %1"),
    QT_TRANSLATE_NOOP("SolidWords", "left out: %1"),
    QT_TRANSLATE_NOOP(
        "SolidWords",
        "stroke %1 retraces the outline of stroke %2 at a distance of %3 mm; it was not "
        "treated as a hole"),
    QT_TRANSLATE_NOOP("SolidWords", "left out %1 small closed line, %2"),
    QT_TRANSLATE_NOOP("SolidWords", "left out %1 small closed lines, the largest %2"),
    QT_TRANSLATE_NOOP("SolidWords",
                      "every closed outline is too small or too narrow; the largest is that %1"),
    QT_TRANSLATE_NOOP("SolidWords", "of stroke %1 at (%2, %3) mm, %4 x %5 mm"),
    QT_TRANSLATE_NOOP("SolidWords", "at (%1, %2) mm, %3 x %4 mm"),
    // Why the drawing has no body.
    QT_TRANSLATE_NOOP("SolidWords",
                      "contains no closed outline: there is a gap of %1 mm at (%2, %3) mm, at the "
                      "end of stroke %4"),
    QT_TRANSLATE_NOOP("SolidWords", "contains no closed outline"),
    QT_TRANSLATE_NOOP(
        "SolidWords",
        "the lines are too dense at (%1, %2) mm to find an outline: %3 mm of line within "
        "%4 mm, but at most %5 mm can be; smooth the line"),
    QT_TRANSLATE_NOOP("SolidWords", "contains no visible strokes"),
    QT_TRANSLATE_NOOP("SolidWords", "has more than 100,000 visible strokes"),
    QT_TRANSLATE_NOOP("SolidWords", "an option for solids is out of range"),
    QT_TRANSLATE_NOOP("SolidWords",
                      "stroke %1 crosses itself at (%2, %3) mm, so its parts meet in only one "
                      "point"),
    QT_TRANSLATE_NOOP("SolidWords",
                      "strokes %1 and %2 enclose areas that meet in only one point, (%3, %4) mm: "
                      "let them overlap, or move them apart"),
    QT_TRANSLATE_NOOP("SolidWords",
                      "lines enclose areas that meet in only one point, (%1, %2) mm: let them "
                      "overlap, or move them apart"),
    QT_TRANSLATE_NOOP("SolidWords",
                      "the outline of stroke %1 only touches its mirror axis at (%2, %3) mm"),
    QT_TRANSLATE_NOOP("SolidWords",
                      "the outline of stroke %1 touches or crosses itself at (%2, %3) mm"),
    QT_TRANSLATE_NOOP("SolidWords", "the outline of stroke %1 is too narrow at (%2, %3) mm"),
    QT_TRANSLATE_NOOP("SolidWords", "stroke %1: %2"),
    QT_TRANSLATE_NOOP("SolidWords", "the outline nearly touches itself at (%1, %2) mm"),
    QT_TRANSLATE_NOOP("SolidWords", "the outline is too narrow at (%1, %2) mm"),
    QT_TRANSLATE_NOOP("SolidWords", "the surface is not closed at (%1, %2) mm"),
    QT_TRANSLATE_NOOP("SolidWords", "the outline has equal points"),
    QT_TRANSLATE_NOOP("SolidWords", "the outline has no area"),
    QT_TRANSLATE_NOOP("SolidWords", "the outline has too many narrow parts"),
    QT_TRANSLATE_NOOP("SolidWords", "the outline cannot be filled"),
    QT_TRANSLATE_NOOP("SolidWords", "no point is on the border"),
    QT_TRANSLATE_NOOP("SolidWords", "the heights of the body cannot be computed"),
    QT_TRANSLATE_NOOP("SolidWords", "a coordinate of the body is not a number"),
    QT_TRANSLATE_NOOP("SolidWords", "the body has no surface"),
    // Why an edit of the body is refused.
    QT_TRANSLATE_NOOP("SolidWords", "the stroke does not touch a body"),
    QT_TRANSLATE_NOOP("SolidWords", "the stroke does not touch the body"),
    QT_TRANSLATE_NOOP("SolidWords", "the stroke has no length"),
    QT_TRANSLATE_NOOP("SolidWords", "the stroke is too long"),
    QT_TRANSLATE_NOOP("SolidWords", "the stroke begins on the body"),
    QT_TRANSLATE_NOOP("SolidWords", "the stroke ends on the body"),
    QT_TRANSLATE_NOOP("SolidWords", "the stroke crosses itself"),
    QT_TRANSLATE_NOOP("SolidWords", "the stroke does not cut off a part of the body"),
    QT_TRANSLATE_NOOP("SolidWords", "the stroke turns too sharply beside the body"),
    QT_TRANSLATE_NOOP("SolidWords", "nothing of the body would remain"),
    QT_TRANSLATE_NOOP("SolidWords", "the cut runs along the surface of the body"),
    QT_TRANSLATE_NOOP("SolidWords", "the profile has too few points"),
    QT_TRANSLATE_NOOP("SolidWords", "the profile begins and ends at the same point"),
    QT_TRANSLATE_NOOP("SolidWords", "the profile leads into the body"),
    QT_TRANSLATE_NOOP("SolidWords", "the profile is too flat"),
    QT_TRANSLATE_NOOP("SolidWords", "the closed line bends around the body too far"),
    QT_TRANSLATE_NOOP("SolidWords", "the body is too thin below the closed line"),
    QT_TRANSLATE_NOOP("SolidWords", "the extruded part would cross itself"),
    QT_TRANSLATE_NOOP("SolidWords", "the closed line has too few points"),
    QT_TRANSLATE_NOOP("SolidWords", "the closed line has no length"),
    QT_TRANSLATE_NOOP("SolidWords", "the closed line crosses itself"),
    QT_TRANSLATE_NOOP("SolidWords", "the closed line is not wholly on the body"),
    QT_TRANSLATE_NOOP("SolidWords", "the closed line encloses nothing"),
    QT_TRANSLATE_NOOP("SolidWords", "the extruded part would touch the body elsewhere"),
    QT_TRANSLATE_NOOP("SolidWords", "the extruded part runs along the surface of the body"),
    QT_TRANSLATE_NOOP("SolidWords", "the painted line has no width"),
    QT_TRANSLATE_NOOP("SolidWords", "the surface cannot be smoothed there"),
    QT_TRANSLATE_NOOP("SolidWords", "the smoothed surface would fold; smooth less at once"),
    QT_TRANSLATE_NOOP("SolidWords", "parts of the body would meet in only a point or a line"),
    QT_TRANSLATE_NOOP("SolidWords", "the surface of the body crosses itself there"),
    QT_TRANSLATE_NOOP("SolidWords", "the surfaces cannot be joined"),
};

}  // namespace

QString solid_words(std::string_view sentence) {
  static const Sentences kTable("SolidWords", kSentences);
  QString text = kTable.translated(text_of(sentence));
  if (text.isEmpty()) return text;
  // The library says these of a file, whose name stands before them; so do the English texts.
  if (text.startsWith(QLatin1String("contains ")) || text.startsWith(QLatin1String("has "))) {
    text.prepend(QLatin1String("the drawing "));
  }
  text[0] = text[0].toUpper();
  return text.endsWith(QLatin1Char('.')) ? text : text + QLatin1Char('.');
}

QStringList solid_sentences() {
  QStringList all;
  for (const char* const sentence : kSentences) all.push_back(QLatin1String(sentence));
  return all;
}

}  // namespace felt::desktop
