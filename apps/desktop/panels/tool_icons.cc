#include "desktop/panels/tool_icons.h"

namespace felt::desktop {

QIcon icon_of(std::string_view) {
  return {};
}

}  // namespace felt::desktop
