#include "desktop/window/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>
#include <clocale>

#include "desktop/engine/settings.h"
#include "desktop/window/window_setting_keys.h"

namespace felt::desktop {
namespace {

QString system_language() {
  for (const QString& wanted : QLocale::system().uiLanguages()) {
    const QString language = wanted.section(QLatin1Char('-'), 0, 0);
    if (languages().contains(language)) return language;
  }
  return QStringLiteral("en");
}

void load(const QString& file, const QString& folder) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  if (translator->load(file, folder)) QCoreApplication::installTranslator(translator);
}

}  // namespace

QStringList languages() {
  return {QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("nl")};
}

QString use_language(const QString& language) {
  QString chosen = language.isEmpty() ? Settings::the().text(window_keys::kLanguage) : language;
  if (chosen.isEmpty()) {
    chosen = system_language();
  } else {
    chosen = chosen.section(QLatin1Char('_'), 0, 0).section(QLatin1Char('-'), 0, 0);
    if (!languages().contains(chosen)) chosen = QStringLiteral("en");
    // Sets the locale, too, because dates and decimal separators must match the language.
    if (QLocale::system().name().section(QLatin1Char('_'), 0, 0) != chosen) {
      QLocale::setDefault(
          QLocale(chosen == QStringLiteral("en") ? QStringLiteral("en_GB") : chosen));
    }
  }
  if (chosen != QStringLiteral("en")) {
    load(QStringLiteral("qtbase_") + chosen, QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    load(QStringLiteral("feltline_") + chosen, QStringLiteral(":/i18n"));
  }
  // QApplication has set the system's locale, but decimal commas in Feltline's files would be
  // wrong.
  std::setlocale(LC_NUMERIC, "C");
  return chosen;
}

}  // namespace felt::desktop
