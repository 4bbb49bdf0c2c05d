#include "desktop/help/help_actions.h"

namespace felt::desktop {

void add_help_actions(Actions&, Canvas&, QWidget*) {}

}  // namespace felt::desktop
