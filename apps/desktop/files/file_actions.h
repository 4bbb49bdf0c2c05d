#pragma once

#include <QObject>
#include <QString>
#include <QWidget>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"

namespace felt::desktop {

/// Which file a window shows, and all that concerns files: new, open, recent, save, save as,
/// import, export, copy as a picture, page, print. Adds its actions ("file.open", "edit.copy").
/// Nothing is ever lost without being asked about.
class FileActions : public QObject {
  Q_OBJECT

 public:
  FileActions(Studio& studio, Actions& actions, QWidget* window);

  /// "" for a drawing without a name.
  [[nodiscard]] const QString& path() const noexcept { return path_; }
  /// Opens it here; asks about unsaved changes first. False: it was not opened, and the person has
  /// been told why.
  bool open(const QString& path);
  bool save();
  bool save_as();
  /// Saves, throws away or stops, as the person says. True: the drawing may go.
  bool may_close();

 Q_SIGNALS:
  void path_changed(const QString& path);
  /// Another window for that file, "" for an empty drawing.
  void wants_window(const QString& path);

 private:
  Studio& studio_;
  QWidget* window_;
  QString path_;
};

}  // namespace felt::desktop
