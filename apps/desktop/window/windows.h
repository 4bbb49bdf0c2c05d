#pragma once

#include <QObject>
#include <QString>

#include "desktop/window/main_window.h"

namespace felt::desktop {

/// The windows of this process, each with its own drawing.
class Windows : public QObject {
  Q_OBJECT

 public:
  /// `first` are the options of the first window's studio. The studios of other windows get the
  /// same device and the same `live`, but are not recorded.
  explicit Windows(StudioOptions first, QObject* parent = nullptr);

  /// Opens a window with an empty page.
  MainWindow* open();
  /// Shows the file in a window and returns the window. Uses the window that already shows the
  /// file, if there is one; otherwise a window in which nothing was drawn or opened, or a new
  /// window. If the file cannot be read, that window shows the error over an empty page.
  MainWindow* open_file(const QString& path);
  /// Opens an example: in `here` if nothing was drawn or opened there, otherwise in a new window.
  MainWindow* open_drawing(const Document& drawing, const QString& title, MainWindow* here);
  /// Prepares for the end of the program and asks the user nothing. Switches forces off immediately
  /// and autosaves all drawings. When the function returns, all drawings are on the disk. The next
  /// start offers to recover those with unsaved changes.
  void release();
  /// Calls release() and closes all windows. Must not be called from within a dialog.
  void end();
  /// Returns the path of the drawing that was opened or saved last, if the next start should open
  /// it again and the file exists; otherwise "".
  [[nodiscard]] static QString last_file();

 private:
  MainWindow* make();
  [[nodiscard]] MainWindow* pristine() const;
  static void remember(MainWindow& window);

  StudioOptions options_;
  QList<MainWindow*> windows_;
};

}  // namespace felt::desktop
