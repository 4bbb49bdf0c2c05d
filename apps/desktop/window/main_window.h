#pragma once

#include <QDialog>
#include <QDockWidget>
#include <QMainWindow>
#include <QPointer>

#include "desktop/canvas/canvas.h"
#include "desktop/devices/device_care.h"
#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/file_actions.h"
#include "desktop/materials/material_editor.h"
#include "desktop/materials/material_editor_model.h"
#include "desktop/materials/media_pictures.h"

namespace felt::desktop {

/// The window of one drawing: canvas, tool bar, panels, menus, status line.
///
/// The layout of the window (size, position, panels) is stored for the next window. A process may
/// have several windows (windows.h).
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(StudioOptions options, QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] Studio& studio() noexcept { return *studio_; }
  [[nodiscard]] Canvas& canvas() noexcept { return *canvas_; }
  [[nodiscard]] Actions& actions() noexcept { return *actions_; }
  [[nodiscard]] FileActions& files() noexcept { return *files_; }
  [[nodiscard]] DeviceCare& care() noexcept { return *care_; }
  [[nodiscard]] MaterialEditorModel& materials() noexcept { return *materials_; }
  [[nodiscard]] const MediaPictures& media_pictures() const noexcept { return *media_pictures_; }
  /// Returns the window in which surfaces and media are edited; makes it on the first call.
  MaterialEditor& material_editor();
  [[nodiscard]] DeviceNotice& device_notice() noexcept { return *device_notice_; }
  /// Shows a panel by its name ("layers", "forces"). Returns false if no panel has that name.
  bool show_panel(const QString& name);
  /// Restores the original layout of panels and bars.
  void reset_layout();
  /// Stores the layout of window, panels and bars for the next start.
  void keep_layout();

 Q_SIGNALS:
  /// Emitted when "edit.preferences" was triggered.
  void wants_preferences();
  /// Emitted when the user chose an example. The receiver shows the drawing in this window if the
  /// window is pristine, otherwise in a new window.
  void wants_drawing(const felt::Document& drawing, const QString& title);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QDockWidget* add_panel(const QString& name, const QString& title, QWidget* panel,
                         const QList<QKeySequence>& keys = {});
  QWidget* canvas_with_notices();
  void make_panels();
  void make_solid_panel();
  void place_panels();
  void check_panel_actions();
  void add_window_actions();
  void add_material_actions();
  void hide_panels(bool hide);
  void show_panels();
  void set_full_screen(bool on);
  void go_to_next_part();
  void show_title();

  Studio* studio_;
  Canvas* canvas_;
  Actions* actions_;
  FileActions* files_;
  MaterialEditorModel* materials_;
  MediaPictures* media_pictures_;
  DeviceNotice* device_notice_ = nullptr;
  DeviceCare* care_ = nullptr;
  QList<QDockWidget*> panels_;
  QList<QWidget*> hidden_;  // the widgets that hide_panels() has hidden
  QByteArray layout_;       // before they were hidden
  QPointer<QDialog> preferences_;
  QPointer<MaterialEditor> material_editor_;
};

}  // namespace felt::desktop
