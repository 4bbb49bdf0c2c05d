#include "desktop/feel/force_panel.h"

namespace felt::desktop {

ForcePanel::ForcePanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {}

}  // namespace felt::desktop
