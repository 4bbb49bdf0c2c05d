#pragma once

#include <QMainWindow>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/file_actions.h"

namespace felt::desktop {

/// One drawing with all around it: canvas, tool bar, panels, menus, status line.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(StudioOptions options, QWidget* parent = nullptr);

  [[nodiscard]] Studio& studio() noexcept { return *studio_; }
  [[nodiscard]] Canvas& canvas() noexcept { return *canvas_; }
  [[nodiscard]] Actions& actions() noexcept { return *actions_; }
  [[nodiscard]] FileActions& files() noexcept { return *files_; }

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  Studio* studio_;
  Canvas* canvas_;
  Actions* actions_;
  FileActions* files_;
};

}  // namespace felt::desktop
