#include "desktop/engine/tool_texts.h"

#include <QCoreApplication>

namespace felt::desktop {
namespace {

QString translate(const char* context, std::string_view text) {
  const QByteArray key(text.data(), qsizetype(text.size()));
  return QCoreApplication::translate(context, key.constData());
}

}  // namespace

QString translated(std::string_view text) {
  return text.empty() ? QString() : translate("tools", text);
}

QString choice_text(std::string_view choice) {
  QString text = translated(choice);
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

QString edit_text(std::string_view label) {
  return label.empty() ? QString() : translate("edits", label);
}

}  // namespace felt::desktop
