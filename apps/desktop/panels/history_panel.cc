#include "desktop/panels/history_panel.h"

namespace felt::desktop {

HistoryPanel::HistoryPanel(Studio& studio, QWidget* parent) : QWidget(parent), studio_(studio) {}

}  // namespace felt::desktop
