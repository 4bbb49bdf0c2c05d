#pragma once

#include <QMainWindow>
#include <QMenu>

#include "desktop/engine/actions.h"

namespace felt::desktop {

/// Makes the menu bar. A table of action names defines the menus and the sequence of their entries.
/// Names without an action are skipped. An action whose name is not in the table is added to the
/// end of the menu that its name starts with, so that every action is in a menu. `recent` is the
/// menu of recent files, or null.
void make_menus(QMainWindow& window, const Actions& actions, QMenu* recent);

/// Sets the icons of the actions, in the colours of the current palette.
void set_action_icons(const Actions& actions);

/// Returns the title of an action's menu, for lists: "File" for "file.open". It is translated and
/// has no mnemonic.
QString menu_title_of(const QString& action_name);

}  // namespace felt::desktop
