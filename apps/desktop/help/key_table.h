#pragma once

#include <QPalette>
#include <QString>
#include <QVector>

#include "desktop/engine/actions.h"

namespace felt::desktop {

/// A command and its keys, as shown to the user.
struct KeyRow {
  QString text;
  QString keys;  ///< "" if it has no keys
};
/// A group of related commands.
struct KeyGroup {
  QString title;
  QVector<KeyRow> rows;
};

/// Returns all actions that have keys, grouped as in the menus, followed by groups with the effects
/// of the pen, the mouse and held keys. If `filter` is not empty, returns only the rows that
/// contain this text in their name or keys.
QVector<KeyGroup> key_groups(const Actions& actions, const QString& filter = {});

/// Returns the groups in columns as HTML for QTextDocument, to show on the screen and to print.
QString key_page(const QVector<KeyGroup>& groups, int columns, const QPalette& palette);

}  // namespace felt::desktop
