#include "desktop/panels/layers_panel.h"

namespace felt::desktop {

LayersPanel::LayersPanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {}

}  // namespace felt::desktop
