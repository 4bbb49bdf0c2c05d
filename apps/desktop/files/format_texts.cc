#include "desktop/files/format_texts.h"

#include <QCoreApplication>
#include <QStringList>
#include <string>

#include "felt/formats/format_traits.h"

namespace felt::desktop {
namespace {

constexpr const char* kContext = "felt::desktop::Formats";

/// The texts of the table, repeated here so that the translation tool finds them.
constexpr const char* kWords[] = {
    QT_TRANSLATE_NOOP("felt::desktop::Formats", "Feltline drawing"),
    QT_TRANSLATE_NOOP("felt::desktop::Formats", "Everything, exactly."),
    QT_TRANSLATE_NOOP("felt::desktop::Formats", "SVG drawing"),
    QT_TRANSLATE_NOOP("felt::desktop::Formats",
                      "The picture, for browsers, Inkscape and all that show SVG; Feltline reads "
                      "lines, layers and page back exactly."),
    QT_TRANSLATE_NOOP("felt::desktop::Formats", "InkML ink"),
    QT_TRANSLATE_NOOP(
        "felt::desktop::Formats",
        "Lines with their widths, for programs that read InkML; Feltline reads lines, "
        "layers and page back exactly."),
    QT_TRANSLATE_NOOP("felt::desktop::Formats", "Xournal++ notes"),
    QT_TRANSLATE_NOOP("felt::desktop::Formats",
                      "Lines with their widths, in layers, for notes in Xournal++; curves become "
                      "many short lines."),
    QT_TRANSLATE_NOOP("felt::desktop::Formats", "Strokes as lines of JSON"),
    QT_TRANSLATE_NOOP(
        "felt::desktop::Formats",
        "Every visible line, exactly, for programs and scripts; no layers, page or surface."),
    QT_TRANSLATE_NOOP("felt::desktop::Formats", "PDF page"),
    QT_TRANSLATE_NOOP("felt::desktop::Formats",
                      "A page to read and print, sharp at any size; it cannot be opened again."),
    QT_TRANSLATE_NOOP("felt::desktop::Formats", "PNG picture"),
    QT_TRANSLATE_NOOP(
        "felt::desktop::Formats",
        "A picture of pixels at the resolution you choose; it cannot be opened again.")};

QString translated(std::string_view text) {
  return QCoreApplication::translate(kContext, std::string(text).c_str());
}

/// Returns file name patterns such as "*.svg *.svgz".
QString patterns_of(const FormatTraits& row) {
  QStringList patterns;
  for (const std::string_view ending : row.endings) {
    patterns.push_back(QStringLiteral("*") +
                       QString::fromLatin1(ending.data(), qsizetype(ending.size())));
  }
  return patterns.join(QLatin1Char(' '));
}

QString filter(const QString& title, const QString& patterns) {
  return QStringLiteral("%1 (%2)").arg(title, patterns);
}

}  // namespace

std::span<const char* const> format_words() {
  return kWords;
}

QString format_title(FileFormat format) {
  return translated(traits_of(format).title);
}

QString format_kept(FileFormat format) {
  return translated(traits_of(format).kept);
}

QString open_filters() {
  QStringList all, filters;
  for (const FormatTraits& row : format_table()) {
    if (!row.reads) continue;
    all.push_back(patterns_of(row));
    filters.push_back(filter(format_title(row.format), patterns_of(row)));
  }
  filters.prepend(filter(QCoreApplication::translate("felt::desktop::Formats", "All drawings"),
                         all.join(QLatin1Char(' '))));
  filters.push_back(QCoreApplication::translate("felt::desktop::Formats", "All files (*)"));
  return filters.join(QStringLiteral(";;"));
}

QString save_filter(FileFormat format) {
  return filter(format_title(format), patterns_of(traits_of(format)));
}

}  // namespace felt::desktop
