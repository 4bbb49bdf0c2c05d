#pragma once

#include <QComboBox>
#include <QToolBar>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"
#include "desktop/materials/media_pictures.h"

namespace felt::desktop {

/// A bar with the controls that are used most often: undo, redo, zoom, medium, surface, forces.
class TopBar : public QToolBar {
  Q_OBJECT

 public:
  TopBar(const Actions& actions, Canvas& canvas, const MediaPictures& pictures,
         QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void add_forces(const Actions& actions);
  void show_forces();
  void add_named(const Actions& actions, const char* name);
  QComboBox* add_list(const QString& label, const QString& name, const QString& tip);
  void add_media(const MediaPictures& pictures);
  void add_presets(const Actions& actions);
  void add_size();
  void add_surfaces();

  Studio& studio_;
  QAction* forces_ = nullptr;
};

}  // namespace felt::desktop
