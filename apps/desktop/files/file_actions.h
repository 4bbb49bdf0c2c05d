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
#include "felt/formats/lost_objects.h"

class QLabel;
class QMenu;

namespace felt::desktop {

class ClipboardActions;
class PictureActions;

/// Functions for palette and view, the parts of a drawing that FileActions does not own.
struct DrawingLooks {
  std::function<void(Drawing&)> report = {};      ///< adds palette and view to a drawing
  std::function<void(const Drawing&)> show = {};  ///< shows palette and view of a drawing
};

/// The file of a window, and all commands for files: new, open, recent, save, save as, import,
/// export, copy as a picture, page, print. Adds its actions ("file.open", "edit.copy"). Asks the
/// user before unsaved changes are lost.
///
/// Another thread writes a copy of the drawing (FileWorker), so that the pen never waits. A drawing
/// counts as saved when its bytes are on the disk. `path()` is always a .felt file. If a drawing
/// was opened from another format, or from a .felt file with another extension, its path is empty,
/// so that Save never overwrites the opened file. `taken` reports the unsupported content of a
/// file.
class FileActions : public QObject {
  Q_OBJECT

 public:
  /// `dialogs` are for tests; if null, the native dialogs are used.
  FileActions(Studio& studio, Actions& actions, QWidget* window,
              std::unique_ptr<FileDialogs> dialogs = nullptr);
  ~FileActions() override;

  [[nodiscard]] ClipboardActions& clipboard() noexcept { return *clipboard_; }
  /// Returns the path, or "" for a drawing without a name.
  [[nodiscard]] const QString& path() const noexcept { return path_; }
  /// Returns a name for titles: the file's name, or the drawing's name if it has no file.
  [[nodiscard]] QString display_name() const;
  /// Returns true if the drawing's file exists and is write-protected.
  [[nodiscard]] bool is_read_only() const;
  /// Returns true if nothing was drawn, opened or saved in this window, so that another drawing
  /// may replace the empty one.
  [[nodiscard]] bool is_pristine() const;

  /// Opens a file here. If the drawing has unsaved changes, asks about them after the file was
  /// read. Returns false if the file was not opened; the error has been shown to the user.
  bool open(const QString& path);
  /// Starts to save. Returns false if the user cancelled. `saved` reports the result.
  bool save();
  bool save_as();
  /// Asks whether to save, discard or cancel, and waits for saves in progress. Returns true if the
  /// window may close.
  bool may_close();
  /// Adds the strokes of another file, as one step of undo, with their media (added_strokes.h).
  bool import(const QString& path);
  /// Opens the first file if this window is pristine. Imports all other files. Pictures
  /// (is_picture_path) become layers to draw over.
  void take_dropped(const QStringList& paths);
  /// Shows a drawing that has no file, such as an example, under this name and without unsaved
  /// changes. Does not ask the user; requires that the window is pristine.
  void show_unsaved(Document document, const Page& page, const QString& name);
  /// Shows a recovered drawing. It has this name and unsaved changes, but no file.
  void adopt(Drawing drawing, const QString& name);

  void set_looks(DrawingLooks looks) { looks_ = std::move(looks); }

  /// Starts the autosave of the drawing. If the studio is live, the FileActions object calls this
  /// function itself.
  void start_autosave(const QStringList& roots);
  [[nodiscard]] StudioAutosave* autosave() const noexcept { return autosave_.get(); }
  /// If a crash left drawings behind, asks the user what to do with them.
  void offer_recovery(const QStringList& roots);

  /// Returns the menu "Open recent", kept up to date; the window owns it.
  [[nodiscard]] QMenu* recent_menu() const noexcept { return recent_menu_; }
  /// Waits until no file is being written.
  void finish_writing() { worker_.wait(); }
  /// Returns the whole drawing, so that the caller can write it to another file.
  [[nodiscard]] Drawing drawing() const;
  [[nodiscard]] FileWorker& worker() noexcept { return worker_; }
  /// Returns the folder in which file dialogs of this drawing start.
  [[nodiscard]] QString folder() const { return folder_.isEmpty() ? last_folder() : folder_; }
  [[nodiscard]] FileDialogs& dialogs() noexcept { return *dialogs_; }

 Q_SIGNALS:
  void path_changed(const QString& path);
  /// The save to `path()` has ended; `done` is true if it succeeded.
  void saved(bool done);
  /// The drawing was exported to this file, without the objects that the format cannot hold.
  /// `changed` says what else differs: what was changed for swell paper, or the paint of a solid.
  void exported(const QString& path, const felt::LostObjects& lost, const QString& changed);
  /// Emitted after Studio::opened when another drawing is shown: opened, new or recovered.
  void drawing_changed();
  /// A file was opened or imported, or strokes were pasted. `report` lists the unsupported content
  /// and may be empty; `name` is the source as shown to the user.
  void taken(const QString& name, const felt::ImportReport& report);
  /// Asks for another window that shows the file `path`; if `path` is "", for a window with an
  /// empty drawing.
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
  void receive_opened();
  void set_path(const QString& path);
  void remember(const QString& path);
  void fill_recent_menu();
  void show_offers(std::vector<RecoveryOffer> offers);
  void take_over(RecoveryOffer offer);
  void forget_rescued();
  void offer_once();
  void report_added(const QString& name, const ImportReport& report);
  void show_status(const AutosaveStatus& status);
  [[nodiscard]] QString last_folder() const;

  Studio& studio_;
  QWidget* window_;
  std::unique_ptr<FileDialogs> dialogs_;
  FileWorker worker_;
  std::unique_ptr<StudioAutosave> autosave_;
  std::vector<AbandonedAutosave> rescued_;  // autosaves of recovered drawings, kept until these
                                            // drawings are saved
  QPointer<QLabel> warning_;                // shown while the autosave fails
  PictureActions* pictures_ = nullptr;
  QMenu* recent_menu_;
  ClipboardActions* clipboard_ = nullptr;
  QString path_;
  QString name_;    // name of a drawing without a path; "" is "Untitled"
  QString folder_;  // folder of the file that was opened or saved last
  DrawingLooks looks_;
  std::shared_ptr<const DrawingExtras> extras_;  // content of the opened file that Feltline does
                                                 // not use but writes back when it saves
  std::shared_ptr<const StrokeNames> names_;     // Drawing::names
  QDateTime seen_on_disk_;  // modification time of the file path_ when this window last read or
                            // wrote the file
  int saves_in_work_ = 0;
  bool last_save_failed_ = false, is_showing_ = false;
  bool has_page_of_file_ = false;  // true if the page came with an opened file
};

}  // namespace felt::desktop
