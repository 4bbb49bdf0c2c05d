#include "desktop/panels/colors_panel.h"

namespace felt::desktop {

ColorsPanel::ColorsPanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {}

}  // namespace felt::desktop
