#pragma once

#include <QMenu>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Lists the user's presets (presets.h): a click uses a preset. The last entries keep the present
/// pen as a preset and remove presets. The list is read from the settings each time it opens.
class PresetMenu : public QMenu {
  Q_OBJECT

 public:
  /// `actions` must have edit.preset_keep.
  PresetMenu(const Actions& actions, Studio& studio, QWidget* parent = nullptr);

 private:
  void fill();

  const Actions& actions_;
  Studio& studio_;
};

/// Adds edit.preset_keep, which asks for a name and keeps the present pen under this name. All
/// arguments must outlive the action.
void add_preset_actions(Actions& actions, Studio& studio, QWidget* window);

}  // namespace felt::desktop
