#pragma once

#include <QIcon>
#include <string_view>

namespace felt::desktop {

/// The icon of a tool ("pencil") or of a command ("undo", "layer-add", ...), drawn by us, in the
/// colours of the palette in use; a null icon for a name that has none.
QIcon icon_of(std::string_view name);

}  // namespace felt::desktop
