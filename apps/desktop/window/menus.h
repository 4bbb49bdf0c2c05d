#pragma once

#include <QMainWindow>
#include <QMenu>

#include "desktop/engine/actions.h"

namespace felt::desktop {

/// Makes the menu bar from the actions by their names. One table has the order. Names without an
/// action are skipped; actions that are not in the table come at the end of the menu that their
/// name starts with, so that every action has a menu. `recent` is the menu of recent files, or
/// null.
void make_menus(QMainWindow& window, const Actions& actions, QMenu* recent);

/// Sets the icons of the actions, in the colours of the current palette.
void set_action_icons(const Actions& actions);

/// Returns the title of the menu of an action, for lists: "File" for "file.open", translated,
/// without mnemonic.
QString menu_title_of(const QString& action_name);

}  // namespace felt::desktop
