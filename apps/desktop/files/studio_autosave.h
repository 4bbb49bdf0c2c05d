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
/// subfolders of a test's folder.
QStringList recovery_roots();

/// Autosaves the drawing of a Studio: passes its events and edits, and the samples of its haptic
/// loop, to an Autosave. Changed values of a material are autosaved within half a second, and so is
/// the text of a medium that comes with strokes. Only flush() and the destructor wait for a disk.
/// When a drawing is closed normally, its database is deleted. The databases of dead processes are
/// offered at the next start (recovery_dialog.h).
class StudioAutosave : public QObject {
  Q_OBJECT

 public:
  /// `current` returns the whole drawing.
  StudioAutosave(Studio& studio, std::function<Drawing()> current, const QStringList& roots,
                 QObject* parent = nullptr);
  /// Deletes the database if all changes are saved, or after discard().
  ~StudioAutosave() override;

  /// Starts the autosave of another drawing, named `name`, with its file `path`, which may be "".
  /// If `path` is nullopt, it is the same drawing with more names of strokes.
  void begin(const QString& name, const std::optional<QString>& path);
  /// Updates name and path after a save. Whether the drawing has unsaved changes is stored
  /// separately, whenever Studio::is_modified() changes.
  void rename(const QString& name, const QString& path);
  /// Returns true if the autosave has these names of strokes (Drawing::names).
  [[nodiscard]] bool has_names(const std::shared_ptr<const StrokeNames>& names) const {
    return names == names_;
  }
  /// Reports that the user chose to discard the drawing when the window closes.
  void discard() { is_discarded_ = true; }
  /// Waits until all changes so far are on the disk or could not be written.
  void flush();

  /// Returns the folder of the database; "" if no folder can be used.
  [[nodiscard]] QString folder() const {
    return QString::fromStdString(autosave_->status().folder);
  }

 Q_SIGNALS:
  /// Emitted when the autosave fails, uses another folder, or works again.
  void status_changed(const felt::AutosaveStatus& status);

 private:
  void connect_studio(Studio& studio);
  void post_head();
  void post_head_soon();
  void note_media(const Drawing& drawing);
  [[nodiscard]] bool lacks_medium_of(const Edit& edit) const;

  QPointer<Studio> studio_;  // the window may delete it before this object
  std::function<Drawing()> current_;
  std::optional<Autosave> autosave_;
  QTimer head_timer_;
  std::set<std::string> media_;  // ids of the media whose texts are in the autosave
  std::shared_ptr<const StrokeNames> names_;
  bool is_discarded_ = false;
};

}  // namespace felt::desktop
