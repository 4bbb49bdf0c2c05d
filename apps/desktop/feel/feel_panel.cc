#include "desktop/feel/feel_panel.h"

namespace felt::desktop {

FeelPanel::FeelPanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {}

}  // namespace felt::desktop
