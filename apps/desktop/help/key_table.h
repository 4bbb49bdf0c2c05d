#pragma once

#include <QPalette>
#include <QString>
#include <QVector>

#include "desktop/engine/actions.h"

namespace felt::desktop {

/// A command and its keys, as shown to the user.
struct KeyRow {
  QString text;
  QString keys;  ///< "" if it has none
};
/// A group of related commands.
struct KeyGroup {
  QString title;
  QVector<KeyRow> rows;
};

/// Returns all actions with keys, grouped as in the menus, and the effects of pen, mouse and held
/// keys. `filter`: only rows that contain it in text or keys.
QVector<KeyGroup> key_groups(const Actions& actions, const QString& filter = {});

/// Returns the groups in columns as HTML for QTextDocument: for screen and print.
QString key_page(const QVector<KeyGroup>& groups, int columns, const QPalette& palette);

}  // namespace felt::desktop
