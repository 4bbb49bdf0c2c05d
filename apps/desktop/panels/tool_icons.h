#pragma once

#include <QColor>
#include <QIcon>
#include <QStringList>
#include <string_view>

namespace felt::desktop {

/// The icon of a tool ("pencil") or of a command ("undo", "layer-add", ...), drawn by us, in the
/// colours of the palette in use; a null icon for a name that has none. Crisp at any size and
/// screen; grey where disabled, in the colour of selected text where selected. Qt's main thread.
QIcon icon_of(std::string_view name);

/// All names that icon_of() knows, sorted.
QStringList icon_names();

/// The one accent of our icons and marks, as it reads on this background (3:1 and more).
QColor accent_on(const QColor& background);

}  // namespace felt::desktop
