#pragma once

#include <QColor>
#include <QIcon>
#include <QStringList>
#include <string_view>

namespace felt::desktop {

/// Returns the icon of a tool ("pencil") or of a command ("undo", "layer-add", ...) in the colours
/// of the current palette. Returns a null icon if no icon has that name. The icon is sharp at any
/// size and screen scale, grey if disabled, and in the colour of selected text if selected. Call it
/// in Qt's main thread.
QIcon icon_of(std::string_view name);

/// Returns all names that icon_of() accepts, sorted.
QStringList icon_names();

/// Returns the accent colour of icons and marks, adapted to this background (contrast at least
/// 3:1).
QColor accent_on(const QColor& background);

}  // namespace felt::desktop
