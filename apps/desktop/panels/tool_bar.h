#pragma once

#include <QToolBar>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Adds tool.pencil, tool.pull, ... of the session's tools, with the shortcuts of their ToolInfo,
/// one of them checked: the tool in hand, a borrowed one too. And tool.size_down, tool.size_up,
/// tool.strength_down, tool.strength_up, which change the size and the forces of the tool in hand.
/// Both must live as long as the actions.
void add_tool_actions(Actions& actions, Studio& studio);

/// The tools in a bar: picture, name, shortcut; the one in hand is pressed. While a tool is
/// borrowed the bar says so, and which one comes back. Made from the actions of add_tool_actions().
class ToolBar : public QToolBar {
  Q_OBJECT

 public:
  ToolBar(Studio& studio, const Actions& actions, QWidget* parent = nullptr);

 private:
  void follow_tool();

  Studio& studio_;
  const Actions& actions_;
  QString home_;  // the tool that comes back
};

}  // namespace felt::desktop
