#pragma once

#include <QToolBar>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"

namespace felt::desktop {

/// What one reaches for all the time: undo, redo, zoom, the sheet's material, the forces.
class TopBar : public QToolBar {
  Q_OBJECT

 public:
  TopBar(const Actions& actions, Canvas& canvas, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void add_forces(const Actions& actions);
  void show_forces();
  void add_named(const Actions& actions, const char* name);
  void add_material(Studio& studio);

  Studio& studio_;
  QAction* forces_ = nullptr;
};

}  // namespace felt::desktop
