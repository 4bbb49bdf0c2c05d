#pragma once

#include <QToolBar>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Adds tool.pencil, tool.pull, ... for the session's tools, with the shortcuts of their ToolInfo.
/// The action of the current tool is checked, even if the tool is only borrowed. Also adds
/// tool.size_down, tool.size_up, tool.strength_down, tool.strength_up, which change the size and
/// the forces of the current tool. Both arguments must outlive the actions.
void add_tool_actions(Actions& actions, Studio& studio);

/// Shows the tools in a bar with picture, name and shortcut; the current tool is pressed. While a
/// tool is borrowed, the bar shows that it is borrowed, and marks the tool that will be selected
/// again afterwards. The bar is made from the actions of add_tool_actions().
class ToolBar : public QToolBar {
  Q_OBJECT

 public:
  ToolBar(Studio& studio, const Actions& actions, QWidget* parent = nullptr);

 private:
  void follow_tool();

  Studio& studio_;
  const Actions& actions_;
  QString home_;  // the tool that is selected after a borrowed one
};

}  // namespace felt::desktop
