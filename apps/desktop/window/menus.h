#pragma once

#include <QMainWindow>
#include <QMenu>

#include "desktop/engine/actions.h"

namespace felt::desktop {

/// The menu bar, made from the actions by their names. The order stands in one table; names that
/// are not there are left out, and actions that the table does not know come at the end of the menu
/// that their name begins with: nothing is left without a menu. `recent` is the menu of recent
/// files, or null.
void make_menus(QMainWindow& window, const Actions& actions, QMenu* recent);

/// Gives actions their icons, in the colours of the palette in use.
void set_action_icons(const Actions& actions);

/// The menu that an action belongs into, for lists: "File" of "file.open", translated, no mnemonic.
QString menu_title_of(const QString& action_name);

}  // namespace felt::desktop
