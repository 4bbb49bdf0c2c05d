#include "desktop/files/swell_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace felt::desktop {
namespace {

QString swell_text(const char* english, std::size_t count) {
  return QCoreApplication::translate("SwellWords", english).arg(QLocale().toString(int(count)));
}

}  // namespace

QString swell_words(const SwellReport& report) {
  QStringList all;
  const auto add = [&all](const char* english, std::size_t count) {
    if (count > 0) all << swell_text(english, count);
  };
  add(QT_TRANSLATE_NOOP("SwellWords", "Lines widened: %1."), report.widened);
  add(QT_TRANSLATE_NOOP("SwellWords", "Lines with another width: %1."), report.made_even);
  add(QT_TRANSLATE_NOOP("SwellWords", "Lines made black: %1."), report.recolored);
  add(QT_TRANSLATE_NOOP("SwellWords", "Areas with a texture: %1."), report.textures);
  add(QT_TRANSLATE_NOOP("SwellWords", "Areas too narrow for a texture: %1."), report.outlines);
  add(QT_TRANSLATE_NOOP("SwellWords", "Lines left out, because they are not seen: %1."),
      report.unseen_lines);
  add(QT_TRANSLATE_NOOP("SwellWords", "Areas left out, because they are not seen: %1."),
      report.unseen_areas);
  add(QT_TRANSLATE_NOOP("SwellWords", "Pictures left out: %1."), report.pictures);
  add(QT_TRANSLATE_NOOP("SwellWords",
                        "Faults that a fingertip would notice: %1. The panel “Tactile check” "
                        "shows them."),
      report.faults);
  if (report.area_colors > SwellRules::kTextures) {
    all << QCoreApplication::translate("SwellWords", "Some colours share a texture.");
  }
  return all.join(QLatin1Char(' '));
}

}  // namespace felt::desktop
