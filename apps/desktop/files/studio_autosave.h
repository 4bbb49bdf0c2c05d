#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <optional>
#include <set>
#include <string>

#include "desktop/engine/studio.h"
#include "desktop/files/drawing_file.h"
#include "felt/autosave/autosave.h"

namespace felt::desktop {

/// Returns the folders for autosave databases, the preferred one first: autosave_roots(), or
/// folders below that of a test.
QStringList recovery_roots();

/// Connects a Studio and its haptic loop to an Autosave. Changed figures of a material, and the
/// text of a medium that comes with strokes, reach it within half a second. Only flush() and the
/// destructor wait for a disk. The database of a drawing that is closed normally is deleted; the
/// database of a dead process is offered at the next start (recovery_dialog.h).
class StudioAutosave : public QObject {
  Q_OBJECT

 public:
  /// `current` returns the whole drawing.
  StudioAutosave(Studio& studio, std::function<Drawing()> current, const QStringList& roots,
                 QObject* parent = nullptr);
  /// Deletes the database if there are no unsaved changes, or after discard().
  ~StudioAutosave() override;

  /// Starts the autosave of another drawing, named `name`, from the file `path` or none.
  void begin(const QString& name, const QString& path);
  /// Updates name and path after a save. Studio::is_modified() tells whether the file has every
  /// change.
  void rename(const QString& name, const QString& path);
  /// The user chose to discard the drawing when the window closes.
  void discard() { is_discarded_ = true; }
  /// Waits until everything so far is on the disk, or has failed.
  void flush();

  /// Returns the folder of the database; "" if no folder works.
  [[nodiscard]] QString folder() const {
    return QString::fromStdString(autosave_->status().folder);
  }

 Q_SIGNALS:
  /// The autosave fails, uses another folder, or works again.
  void status_changed(const felt::AutosaveStatus& status);

 private:
  void connect_studio(Studio& studio);
  void post_head();
  void post_head_soon();
  void note_media(const Drawing& drawing);
  [[nodiscard]] bool lacks_medium_of(const Edit& edit) const;

  QPointer<Studio> studio_;  // the window may delete it first
  std::function<Drawing()> current_;
  std::optional<Autosave> autosave_;
  QTimer head_timer_;
  std::set<std::string> media_;  // whose texts the autosave has
  bool is_discarded_ = false;
};

}  // namespace felt::desktop
