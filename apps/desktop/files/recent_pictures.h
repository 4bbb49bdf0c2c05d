#pragma once

#include <QIcon>
#include <QMenu>
#include <QSize>
#include <QString>
#include <QStringList>

#include "felt/document/drawing.h"

namespace felt::desktop {

/// Small pictures of recent files, for the menu "Open recent". They are in the user's cache folder,
/// so that the menu opens no drawing.
inline constexpr QSize kRecentPicture{72, 54};

/// Makes the picture of a file that contains this drawing. If it cannot be written, the file has no
/// picture. Safe to call from any thread.
void write_recent_picture(const QString& path, const Drawing& drawing);
/// Returns the picture of a file, or a null icon if there is none.
QIcon recent_picture(const QString& path);
/// Deletes the pictures of all files that are not in the list.
void keep_recent_pictures(const QStringList& paths);
/// Makes the menu show icons in the size of these pictures.
void show_large_icons(QMenu& menu);

}  // namespace felt::desktop
