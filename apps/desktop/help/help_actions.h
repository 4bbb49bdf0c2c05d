#pragma once

#include <QWidget>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"

namespace felt::desktop {

/// Adds "help.shortcuts", "help.tour", "help.example_1" and on, "help.about".
void add_help_actions(Actions& actions, Canvas& canvas, QWidget* window);

}  // namespace felt::desktop
