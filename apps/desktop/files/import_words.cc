#include "desktop/files/import_words.h"

#include <QCoreApplication>

#include "desktop/engine/sentences.h"
#include "desktop/engine/text_of.h"

namespace felt::desktop {
namespace {

// The longest sentences come first, so that none hides a more exact one. The page for browsers
// reads the translations, too (web/page/make_words.mjs).
constexpr const char* kSentences[] = {
    QT_TRANSLATE_NOOP("ImportWords",
                      "has times that are not milliseconds: they stand still, run backwards or "
                      "hardly advance; they were ignored"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "has pressures outside 0 to 1, which count as 0 or 1; divide them by the "
                      "largest pressure of the pen"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "has invalid tones (one number from 0 to 1 per width is needed); the tones "
                      "of its widths were used"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "has rounded coordinates; smooth joints were moved by less than 0.001 mm or "
                      "became corners"),
    QT_TRANSLATE_NOOP(
        "ImportWords",
        "is transparent inside a transparent group; the transparency was applied to each stroke"),
    QT_TRANSLATE_NOOP(
        "ImportWords",
        "has widths that are not positive numbers (%1); those of the pieces beside them were used"),
    QT_TRANSLATE_NOOP(
        "ImportWords",
        "has invalid tones (one number from 0 to 1 per width is needed); its points were read"),
    QT_TRANSLATE_NOOP(
        "ImportWords",
        "has a line that another program changed; its widths were stretched over the line"),
    QT_TRANSLATE_NOOP(
        "ImportWords",
        "has more points than a stroke can have (%1); it was split into several strokes"),
    QT_TRANSLATE_NOOP(
        "ImportWords",
        "has a different colour from the first page; the first page's colour was used"),
    QT_TRANSLATE_NOOP(
        "ImportWords",
        "contains something that is not a number; only the points before it were read"),
    QT_TRANSLATE_NOOP(
        "ImportWords",
        "has a blend mode, which was ignored: the file has more than 200 such groups"),
    QT_TRANSLATE_NOOP(
        "ImportWords",
        "was read without some of its styles, because the style sheet is too complex"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "was changed by another program: its points were read, not the stored curve"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "is transparent and has several parts; it became darker at their crossings"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "is in a transparent group; the transparency was applied to each stroke"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "is larger than a page can be (5000 mm); the rest lies outside the page"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "has parts shorter than 0.05 mm, which were joined to their neighbours"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "has a newer version than Feltline supports; the known parts were read"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "has a line that is stretched in one direction; its width was sampled"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "was stretched in one direction; its widths were scaled by the mean"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "ends before the file does; the documents after it (%1) were skipped"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "is painted with a gradient; the mean colour of its stops was used"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "extends beyond the frame that shows it; its lines end about there"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "has more than 250000 segments and was split into several strokes"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "has more than 10000 layers; the others were merged into the last"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "has a smooth joint that another program bent; it became a corner"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "was skipped: a drawing has at most 200 pictures and 10000 layers"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "extends beyond the frame that shows it, and is shown as a whole"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "crosses itself; parts that it covers twice may lack their fill"),
    QT_TRANSLATE_NOOP("ImportWords",
                      "was skipped: it is in another file, '%1', which is not opened"),
    QT_TRANSLATE_NOOP("ImportWords", "refers to a style sheet in another file, which was not read"),
    QT_TRANSLATE_NOOP("ImportWords", "is clipped to too many rotated frames; this one was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "has a centre line of several parts; only the first was read"),
    QT_TRANSLATE_NOOP("ImportWords", "has ends or corners too close together, which became round"),
    QT_TRANSLATE_NOOP("ImportWords", "has no known widths of its pieces; a single width was used"),
    QT_TRANSLATE_NOOP("ImportWords", "has no supported mapping; its coordinates were not changed"),
    QT_TRANSLATE_NOOP("ImportWords", "has a blend mode that is not supported, which was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "%1 rules of style sheets are not supported and were ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "covers lines of its transparent group, which show through"),
    QT_TRANSLATE_NOOP("ImportWords", "has flat dashes shorter than its width, which became dots"),
    QT_TRANSLATE_NOOP("ImportWords", "was skipped: the element it refers to is not in the file"),
    QT_TRANSLATE_NOOP("ImportWords", "has neither a line nor a fill that shows and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "lost its variable width (%1); its outline was used instead"),
    QT_TRANSLATE_NOOP("ImportWords", "has widths interpolated by the rule %1, which were sampled"),
    QT_TRANSLATE_NOOP("ImportWords", "has a name of more than 4096 bytes; its points were read"),
    QT_TRANSLATE_NOOP("ImportWords", "has a width or height of 0, so nothing of it is visible"),
    QT_TRANSLATE_NOOP("ImportWords", "does not define its largest pressure; 32767 was assumed"),
    QT_TRANSLATE_NOOP("ImportWords", "has an invalid or too long material, which was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has a fill that was put below the lines that it covers"),
    QT_TRANSLATE_NOOP("ImportWords", "has dashes that merge, because their ends became round"),
    QT_TRANSLATE_NOOP("ImportWords", "was skipped: it is in another file, which is not read"),
    QT_TRANSLATE_NOOP("ImportWords", "has a name of more than 4096 bytes, which was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "of the white-out eraser was read as ink of its colour"),
    QT_TRANSLATE_NOOP("ImportWords", "is a broad nib; its longer side was used as the width"),
    QT_TRANSLATE_NOOP("ImportWords", "was skipped: too many elements are repeated by 'use'"),
    QT_TRANSLATE_NOOP("ImportWords", "was made with the pen off the paper and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "is painted with a pattern; a single colour was used"),
    QT_TRANSLATE_NOOP("ImportWords", "refers to '%1' in another document, which is not read"),
    QT_TRANSLATE_NOOP("ImportWords", "does not have a matrix of two rows of three numbers"),
    QT_TRANSLATE_NOOP("ImportWords", "lost the references to the strokes around its fill"),
    QT_TRANSLATE_NOOP("ImportWords", "is outside the frame that shows it and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has a width or height of 0 or less and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has no extent after its transform and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "paints its line below its fill, which was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "says %1, but the content is a %2 and was read as such"),
    QT_TRANSLATE_NOOP("ImportWords", "has a %1 that could not be read, which was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "%1; it was skipped, and its ink looks like pencil"),
    QT_TRANSLATE_NOOP("ImportWords", "has a %1 that could not be read, and became black"),
    QT_TRANSLATE_NOOP("ImportWords", "fills the page and was used as the paper colour"),
    QT_TRANSLATE_NOOP("ImportWords", "does not define its unit; 1/96 inch was assumed"),
    QT_TRANSLATE_NOOP("ImportWords", "shows part of a trace; the whole trace was read"),
    QT_TRANSLATE_NOOP("ImportWords", "was skipped: it follows the end of the drawing"),
    QT_TRANSLATE_NOOP("ImportWords", "has pointed or cut corners, which became round"),
    QT_TRANSLATE_NOOP("ImportWords", "has a last point without y, which was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "was skipped: it is nested more than 256 deep"),
    QT_TRANSLATE_NOOP("ImportWords", "was made with the eraser end and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has times beyond 9e12 ms, which were ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "is thinner than 0.05 mm and became that wide"),
    QT_TRANSLATE_NOOP("ImportWords", "has an invalid page size, which was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "has an invalid transform, which was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "has flat or square ends, which became round"),
    QT_TRANSLATE_NOOP("ImportWords", "has too many dashes and became a solid line"),
    QT_TRANSLATE_NOOP("ImportWords", "is not a known colour; it was read as black"),
    QT_TRANSLATE_NOOP("ImportWords", "has too few widths; a single width was used"),
    QT_TRANSLATE_NOOP("ImportWords", "is not two-dimensional and is not supported"),
    QT_TRANSLATE_NOOP("ImportWords", "has a damaged curve; its points were read: %1"),
    QT_TRANSLATE_NOOP("ImportWords", "belongs to another program and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has an impossible width, which was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has widths without a unit; mm was assumed"),
    QT_TRANSLATE_NOOP("ImportWords", "has a damaged curve; its points were read"),
    QT_TRANSLATE_NOOP("ImportWords", "does not form a stroke and was skipped: %1"),
    QT_TRANSLATE_NOOP("ImportWords", "has no width; the default width was used"),
    QT_TRANSLATE_NOOP("ImportWords", "of type '%1' is a picture and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "is unknown in a context and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "was skipped: animation is not supported"),
    QT_TRANSLATE_NOOP("ImportWords", "has a %1 to something that does not exist"),
    QT_TRANSLATE_NOOP("ImportWords", "is text, not a stroke, and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "does not form a fill and was skipped: %1"),
    QT_TRANSLATE_NOOP("ImportWords", "has times that run backwards in places"),
    QT_TRANSLATE_NOOP("ImportWords", "of an unknown tool was read as a pen's"),
    QT_TRANSLATE_NOOP("ImportWords", "of form '%1' was replaced by a round one"),
    QT_TRANSLATE_NOOP("ImportWords", "is hidden in the file and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has an unknown colour; white was used"),
    QT_TRANSLATE_NOOP("ImportWords", "has an unknown colour; black was used"),
    QT_TRANSLATE_NOOP("ImportWords", "%1; only the points before it were read"),
    QT_TRANSLATE_NOOP("ImportWords", "has no unit of length; mm was assumed"),
    QT_TRANSLATE_NOOP("ImportWords", "extends beyond 1e9 mm and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has too many choices and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "is not a valid width and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "The picture of the layer '%1' is lost."),
    QT_TRANSLATE_NOOP("ImportWords", "of style '%1': its lines were skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has a blend mode, which was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "and others were changed or skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has a clip path, which was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "was skipped: scripts are not run"),
    QT_TRANSLATE_NOOP("ImportWords", "was skipped: it refers to itself"),
    QT_TRANSLATE_NOOP("ImportWords", "has no X or no Y and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "is not a stroke and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has markers, which were skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has a filter, which was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "'%1' is unknown and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has no points and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has a mask, which was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "has a zoom, which was ignored"),
    QT_TRANSLATE_NOOP("ImportWords", "is a picture and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "has no size; A4 was assumed"),
    QT_TRANSLATE_NOOP("ImportWords", "of type '%1' is not supported"),
    QT_TRANSLATE_NOOP("ImportWords", "is unknown and was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "was read up to an error: %1"),
    QT_TRANSLATE_NOOP("ImportWords", "lost the fill of its area"),
    QT_TRANSLATE_NOOP("ImportWords", "%1; the rest was skipped"),
    QT_TRANSLATE_NOOP("ImportWords", "is no longer dashed"),
    QT_TRANSLATE_NOOP("ImportWords", "got round ends"),
    QT_TRANSLATE_NOOP("ImportWords", "was skipped: %1"),
    QT_TRANSLATE_NOOP("ImportWords", "has no page"),
};

// Those that only the page needs, where a notice is one text.
[[maybe_unused]] constexpr const char* kOfPage[] = {
    QT_TRANSLATE_NOOP("ImportWords", "line %1: %2"),
    QT_TRANSLATE_NOOP("ImportWords", "%1 (and %2 more like it)"),
};

}  // namespace

QString import_words(std::string_view what) {
  static const Sentences kTable("ImportWords", kSentences);
  return kTable.translated(text_of(what));
}

QStringList import_sentences() {
  QStringList all;
  for (const char* const sentence : kSentences) all.push_back(QString::fromUtf8(sentence));
  return all;
}

}  // namespace felt::desktop
