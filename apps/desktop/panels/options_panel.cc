#include "desktop/panels/options_panel.h"

namespace felt::desktop {

OptionsPanel::OptionsPanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {}

}  // namespace felt::desktop
