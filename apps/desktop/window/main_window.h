#pragma once

#include <QDialog>
#include <QDockWidget>
#include <QMainWindow>
#include <QPointer>

#include "desktop/canvas/canvas.h"
#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/file_actions.h"

namespace felt::desktop {

/// One drawing with all around it: canvas, tool bar, panels, menus, status line.
///
/// What it looks like (size, place, panels) is kept from one window to the next. Several windows
/// live in one process (windows.h).
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(StudioOptions options, QWidget* parent = nullptr);

  [[nodiscard]] Studio& studio() noexcept { return *studio_; }
  [[nodiscard]] Canvas& canvas() noexcept { return *canvas_; }
  [[nodiscard]] Actions& actions() noexcept { return *actions_; }
  [[nodiscard]] FileActions& files() noexcept { return *files_; }
  /// Shows a panel by its name ("layers", "forces"); false where there is none of that name.
  bool show_panel(const QString& name);
  /// Panels and bars as they come with the program.
  void reset_layout();

 Q_SIGNALS:
  /// "edit.preferences" was asked for.
  void wants_preferences();
  /// An example: here where nothing has been drawn, else in a window of its own.
  void wants_drawing(const felt::Document& drawing, const QString& title);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QDockWidget* add_panel(const QString& name, const QString& title, QWidget* panel);
  QWidget* sheet_with_notices();
  void make_panels();
  void place_panels();
  void add_window_actions();
  void hide_panels(bool hide);
  void set_full_screen(bool on);
  void go_to_next_part();
  void show_title();

  Studio* studio_;
  Canvas* canvas_;
  Actions* actions_;
  FileActions* files_;
  QList<QDockWidget*> panels_;
  QList<QWidget*> hidden_;  // by hide_panels
  QPointer<QDialog> preferences_;
};

}  // namespace felt::desktop
