#include "desktop/pens/button_role.h"

#include <QCoreApplication>
#include <array>

namespace felt::desktop {
namespace {

struct Row {
  const char* name;
  const char* label;
};
/// The sequence is that of ButtonRole.
constexpr std::array<Row, 10> kRows = {{
    {"none", QT_TRANSLATE_NOOP("ButtonRole", "Nothing")},
    {"eraser", QT_TRANSLATE_NOOP("ButtonRole", "Erase while held")},
    {"pull", QT_TRANSLATE_NOOP("ButtonRole", "Pull while held")},
    {"lasso", QT_TRANSLATE_NOOP("ButtonRole", "Select while held")},
    {"pan", QT_TRANSLATE_NOOP("ButtonRole", "Move the view while held")},
    {"undo", QT_TRANSLATE_NOOP("ButtonRole", "Undo")},
    {"popup", QT_TRANSLATE_NOOP("ButtonRole", "Open the palette at the pointer")},
    {"ring", QT_TRANSLATE_NOOP("ButtonRole", "Open the ring of tools; release to choose")},
    {"modifier-1", QT_TRANSLATE_NOOP("ButtonRole", "The tool's first modifier (Shift)")},
    {"modifier-2", QT_TRANSLATE_NOOP("ButtonRole", "The tool's second modifier (Ctrl)")},
}};
constexpr std::array kRoles = {
    ButtonRole::kNone,          ButtonRole::kEraser,         ButtonRole::kPull,  ButtonRole::kLasso,
    ButtonRole::kPan,           ButtonRole::kUndo,           ButtonRole::kPopup, ButtonRole::kRing,
    ButtonRole::kFirstModifier, ButtonRole::kSecondModifier,
};
static_assert(kRoles.size() == kRows.size());

const Row& row_of(ButtonRole role) {
  return kRows[static_cast<std::size_t>(role)];
}

}  // namespace

std::span<const ButtonRole> button_roles() noexcept {
  return kRoles;
}

QString name_of(ButtonRole role) {
  return QString::fromLatin1(row_of(role).name);
}

ButtonRole button_role(const QString& name) {
  for (const ButtonRole role : kRoles) {
    if (name == QLatin1String(row_of(role).name)) return role;
  }
  return ButtonRole::kNone;
}

QString label_of(ButtonRole role) {
  return QCoreApplication::translate("ButtonRole", row_of(role).label);
}

}  // namespace felt::desktop
