#pragma once

#include <QObject>
#include <QString>

#include "desktop/window/main_window.h"

namespace felt::desktop {

/// The windows of this process, each with a drawing of its own.
class Windows : public QObject {
  Q_OBJECT

 public:
  /// `first` is what the first window's studio gets; the others get the same, but what they do is
  /// told to nobody.
  explicit Windows(StudioOptions first, QObject* parent = nullptr);

  /// A window with a fresh sheet.
  MainWindow* open();
  /// A window with this file: the one that has it already, one with nothing in it, or another one.
  /// Where it cannot be read, the window says so over a fresh sheet.
  MainWindow* open_file(const QString& path);
  /// Likewise with an example; in `here` where nothing was drawn there.
  MainWindow* open_drawing(const Document& drawing, const QString& title, MainWindow* here);
  /// Nobody is asked any more, as the program is told to end: forces go off at once. What was drawn
  /// is on the disk when this returns; what is not saved is offered at the next start.
  void let_go();
  /// Likewise, and closes them all; not from within a dialog.
  void end();
  /// What was open when the program was used last, "" for nothing.
  [[nodiscard]] static QString last_file();

 private:
  MainWindow* make();
  [[nodiscard]] MainWindow* pristine() const;
  static void remember(MainWindow& window);

  StudioOptions options_;
  QList<MainWindow*> windows_;
};

}  // namespace felt::desktop
