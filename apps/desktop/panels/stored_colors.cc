#include "desktop/panels/stored_colors.h"

#include <QStringList>

#include "desktop/engine/settings.h"
#include "felt/stroke/color_text.h"

namespace felt::desktop {

std::vector<NamedColor> stored_colors(const char* key) {
  std::vector<NamedColor> colors;
  for (const QString& text : Settings::the().value(QString::fromLatin1(key)).toStringList()) {
    if (const auto color = color_from_text(text.toStdString())) colors.push_back({*color, {}});
  }
  return colors;
}

void store_colors(const char* key, const std::vector<NamedColor>& colors) {
  QStringList texts;
  for (const NamedColor& entry : colors) {
    texts.push_back(QString::fromStdString(color_to_text(entry.color)));
  }
  Settings::the().set(QString::fromLatin1(key), texts);
}

}  // namespace felt::desktop
