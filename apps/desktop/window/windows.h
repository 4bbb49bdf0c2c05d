#pragma once

#include <QObject>
#include <QString>

#include "desktop/window/main_window.h"

namespace felt::desktop {

/// The windows of this process, each with its own drawing.
class Windows : public QObject {
  Q_OBJECT

 public:
  /// `first` contains the options for the studio of the first window. The studios of other windows
  /// use the same device and the same StudioOptions::live, but are not recorded.
  explicit Windows(StudioOptions first, QObject* parent = nullptr);

  /// Opens a window with an empty page.
  MainWindow* open();
  /// Shows the file in a window and returns the window. If no window shows the file yet, opens the
  /// file in a window in which nothing was drawn or opened or, if there is no such window, in a new
  /// window. If the file cannot be read, the returned window shows the error over an empty page.
  MainWindow* open_file(const QString& path);
  /// Opens an example: in `here` if nothing was drawn or opened there, otherwise in a new window.
  MainWindow* open_drawing(const Document& drawing, const QString& title, MainWindow* here);
  /// Prepares for the end of the program without asking the user. Switches forces off immediately,
  /// then waits until all drawings are autosaved to the disk. When Feltline starts again, it offers
  /// to recover the drawings that have unsaved changes.
  void release();
  /// Calls release() and closes all windows. Must not be called from within a dialog.
  void end();
  /// Returns the path of the drawing that was opened or saved last (kLastFile). Returns "" if the
  /// user has not switched on kReopenLast, or if the file does not exist.
  [[nodiscard]] static QString last_file();

 private:
  MainWindow* make();
  [[nodiscard]] MainWindow* pristine() const;
  static void remember(MainWindow& window);

  StudioOptions options_;
  QList<MainWindow*> windows_;
};

}  // namespace felt::desktop
