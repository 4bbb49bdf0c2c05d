#pragma once

#include <QPalette>
#include <QString>
#include <QVector>

#include "desktop/engine/actions.h"

namespace felt::desktop {

/// A command and how it is reached, for people.
struct KeyRow {
  QString text;
  QString keys;  ///< "" for none
};
/// What belongs together.
struct KeyGroup {
  QString title;
  QVector<KeyRow> rows;
};

/// All actions that have keys, grouped as in the menus, and what pen, mouse and held keys do.
/// `filter`: only rows that contain it, in text or keys.
QVector<KeyGroup> key_groups(const Actions& actions, const QString& filter = {});

/// The groups in columns, for QTextDocument: on screen and on paper.
QString key_page(const QVector<KeyGroup>& groups, int columns, const QPalette& palette);

}  // namespace felt::desktop
