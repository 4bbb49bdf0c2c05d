#pragma once

#include <QDateTime>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "desktop/engine/actions.h"
#include "desktop/engine/studio.h"
#include "desktop/files/drawing_file.h"
#include "desktop/files/file_dialogs.h"
#include "desktop/files/file_worker.h"
#include "desktop/files/recovery_offer.h"
#include "desktop/files/studio_autosave.h"

class QLabel;
class QMenu;

namespace felt::desktop {

/// The parts of a drawing's file that other parts of the window own: its palette and its view.
struct DrawingLooks {
  std::function<void(Drawing&)> tell = {};        ///< adds them to a drawing
  std::function<void(const Drawing&)> show = {};  ///< shows those of a drawing
};

/// The file of a window, and all commands for files: new, open, recent, save, save as, import,
/// export, copy as a picture, page, print. Adds its actions ("file.open", "edit.copy"). Asks before
/// anything unsaved is lost.
///
/// Files are written from a copy on another thread (FileWorker), so that the pen never waits. A
/// drawing counts as saved when its bytes are on the disk. `path()` is always a .felt file. A
/// drawing that was opened from another format, or from a .felt file with another extension, has no
/// path yet, so that Save never overwrites its source. `taken` reports what in a file is not
/// supported.
class FileActions : public QObject {
  Q_OBJECT

 public:
  /// `dialogs` are for tests; null: the native dialogs.
  FileActions(Studio& studio, Actions& actions, QWidget* window,
              std::unique_ptr<FileDialogs> dialogs = nullptr);
  ~FileActions() override;

  /// Returns the path, or "" for a drawing without a name.
  [[nodiscard]] const QString& path() const noexcept { return path_; }
  /// Returns a name for titles: the file's, or that of a drawing without a file.
  [[nodiscard]] QString display_name() const;
  /// Returns true if the drawing's file exists and may not be written.
  [[nodiscard]] bool is_read_only() const;
  /// Returns true if nothing was drawn, opened or saved here, so that another drawing may replace
  /// it.
  [[nodiscard]] bool is_pristine() const;

  /// Opens a file here; asks about unsaved changes after the file was read. Returns false if it was
  /// not opened; an error has been shown to the user.
  bool open(const QString& path);
  /// Starts to save. Returns false if the user cancelled. `saved` reports the result.
  bool save();
  bool save_as();
  /// Asks whether to save, discard or cancel, and waits for running saves. Returns true if the
  /// window may close.
  bool may_close();
  /// Adds the strokes of another file, as one step of undo, with their media (added_strokes.h).
  bool import(const QString& path);
  /// Opens the first file if this window is pristine; imports the others.
  void take_dropped(const QStringList& paths);
  /// Shows a drawing without a file, for example an example, under this name and without unsaved
  /// changes. Does not ask, so requires that the window is pristine.
  void show_unsaved(Document document, const SheetPage& page, const QString& name);
  /// Shows a recovered drawing: it has unsaved changes and this name, but no file.
  void adopt(Drawing drawing, const QString& name);

  void set_looks(DrawingLooks looks) { looks_ = std::move(looks); }

  /// Starts the autosave of the drawing. The window of a live studio calls it itself.
  void start_autosave(const QStringList& roots);
  [[nodiscard]] StudioAutosave* autosave() const noexcept { return autosave_.get(); }
  /// If a crash left drawings behind, asks what to do with them.
  void offer_recovery(const QStringList& roots);

  /// Returns the menu "Open recent", kept up to date; the window owns it.
  [[nodiscard]] QMenu* recent_menu() const noexcept { return recent_menu_; }
  /// Waits until no file is being written.
  void finish_writing() { worker_.wait(); }
  /// Returns the whole drawing, to be written elsewhere.
  [[nodiscard]] Drawing drawing() const;
  [[nodiscard]] FileWorker& worker() noexcept { return worker_; }
  /// Returns the folder in which file dialogs of this drawing start.
  [[nodiscard]] QString folder() const { return folder_.isEmpty() ? last_folder() : folder_; }
  [[nodiscard]] FileDialogs& dialogs() noexcept { return *dialogs_; }

 Q_SIGNALS:
  void path_changed(const QString& path);
  /// The save to `path()` ended; `done`: it succeeded.
  void saved(bool done);
  /// Another drawing is shown: opened, new or recovered. Emitted after Studio::opened.
  void drawing_changed();
  /// A file was opened, imported or pasted from; its report may be empty. `name` is shown to the
  /// user.
  void taken(const QString& name, const felt::ImportReport& report);
  /// Asks for another window for that file, "" for an empty drawing.
  void wants_window(const QString& path);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  void add_file_actions(Actions& actions);
  bool may_replace();
  void start_new();
  void ask_open();
  void ask_import();
  bool begin_save(const QString& path);
  void end_save(const QString& path, const ChangeMark& mark, const Result<void>& done);
  Result<Imported> read(const QString& path);
  void show(Drawing drawing, const QString& path, const QString& name);
  void hear_opened();
  void set_path(const QString& path);
  void remember(const QString& path);
  void fill_recent_menu();
  void show_offers(std::vector<RecoveryOffer> offers);
  void take_over(RecoveryOffer offer);
  void forget_rescued();
  void offer_once();
  void show_status(const AutosaveStatus& status);
  [[nodiscard]] QString last_folder() const;

  Studio& studio_;
  QWidget* window_;
  std::unique_ptr<FileDialogs> dialogs_;
  FileWorker worker_;
  std::unique_ptr<StudioAutosave> autosave_;
  std::vector<AbandonedAutosave> rescued_;  // until their drawings are saved
  QPointer<QLabel> warning_;                // shown while the autosave fails
  QMenu* recent_menu_;
  QString path_;
  QString name_;    // of a drawing without a path; "" is "Untitled"
  QString folder_;  // of the file that was opened or saved last
  DrawingLooks looks_;
  std::shared_ptr<const DrawingExtras> extras_;  // the content of its file that is only carried
                                                 // along
  QDateTime seen_on_disk_;                       // of path_, when it was read or written here
  int saves_in_work_ = 0;
  bool last_save_failed_ = false, is_showing_ = false;
  bool has_page_of_file_ = false;  // the page came with a file that was opened
};

}  // namespace felt::desktop
