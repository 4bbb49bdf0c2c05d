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

/// What a drawing's file holds besides and others in the window know: its palette, what is seen.
struct DrawingLooks {
  std::function<void(Drawing&)> tell = {};        ///< fills them in
  std::function<void(const Drawing&)> show = {};  ///< shows those that the drawing has
};

/// Which file a window shows, and all that concerns files: new, open, recent, save, save as,
/// import, export, copy as a picture, page, print. Adds its actions ("file.open", "edit.copy").
/// Nothing is ever lost without being asked about.
///
/// Files are written beside the window (FileWorker), from a copy: the pen never waits. A drawing
/// counts as saved when its bytes are on the disk. `path()` is always a .felt file; what is opened
/// from another format, or from a drawing that is called otherwise, has no path yet, so that Save
/// never writes over it. What could not be taken of a file is told by `taken`.
class FileActions : public QObject {
  Q_OBJECT

 public:
  /// `dialogs` are for tests; null: the native ones.
  FileActions(Studio& studio, Actions& actions, QWidget* window,
              std::unique_ptr<FileDialogs> dialogs = nullptr);
  ~FileActions() override;

  /// "" for a drawing without a name.
  [[nodiscard]] const QString& path() const noexcept { return path_; }
  /// For titles: the file's name, or what the drawing without one is called.
  [[nodiscard]] QString display_name() const;
  /// The drawing's file is there and may not be written.
  [[nodiscard]] bool is_read_only() const;
  /// Nothing was drawn, opened or saved here: another drawing may take the place.
  [[nodiscard]] bool is_pristine() const;

  /// Opens it here; asks about unsaved changes once it could be read. False: it was not opened, and
  /// the person has been told why.
  bool open(const QString& path);
  /// Begins to write; false: the person stopped it. What comes of it is told by `saved`.
  bool save();
  bool save_as();
  /// Saves, throws away or stops, as the person says, and waits for what is being written. True:
  /// the drawing may go.
  bool may_close();
  /// The strokes of another file are added, as one step, with their media (added_strokes.h).
  bool import(const QString& path);
  /// Opens the first where this window is pristine, imports the others.
  void take_dropped(const QStringList& paths);
  /// A drawing that comes from no file, an example: it has this name, and nothing to save. Asks
  /// nothing: for a window that is pristine.
  void show_unsaved(Document document, const SheetPage& page, const QString& name);
  /// A drawing that was rescued: it has changes and this name, and no file.
  void adopt(Drawing drawing, const QString& name);

  void set_looks(DrawingLooks looks) { looks_ = std::move(looks); }

  /// Protects the drawing against a crash from now on. A live studio's window calls it by itself.
  void start_autosave(const QStringList& roots);
  [[nodiscard]] StudioAutosave* autosave() const noexcept { return autosave_.get(); }
  /// Asks what to do with drawings that a crash left behind, if there are any.
  void offer_recovery(const QStringList& roots);

  /// "Open recent", kept up to date; owned by the window.
  [[nodiscard]] QMenu* recent_menu() const noexcept { return recent_menu_; }
  /// Waits until no file is being written.
  void finish_writing() { worker_.wait(); }
  /// The whole drawing, to be written elsewhere.
  [[nodiscard]] Drawing drawing() const;
  [[nodiscard]] FileWorker& worker() noexcept { return worker_; }
  /// Where files of this drawing are looked for first.
  [[nodiscard]] QString folder() const { return folder_.isEmpty() ? last_folder() : folder_; }
  [[nodiscard]] FileDialogs& dialogs() noexcept { return *dialogs_; }

 Q_SIGNALS:
  void path_changed(const QString& path);
  /// A drawing was written to `path()`, or not.
  void saved(bool done);
  /// Another drawing is here: opened, new or rescued; after Studio::opened.
  void drawing_changed();
  /// A file was opened, imported or pasted from; its report may be empty. `name` is for people.
  void taken(const QString& name, const felt::ImportReport& report);
  /// Another window for that file, "" for an empty drawing.
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
  std::vector<AbandonedAutosave> rescued_;  // until what was in them is saved
  QPointer<QLabel> warning_;                // that it is not kept as it should be
  QMenu* recent_menu_;
  QString path_;
  QString name_;    // of a drawing without a path; "" is "Untitled"
  QString folder_;  // where it came from
  DrawingLooks looks_;
  std::shared_ptr<const DrawingExtras> extras_;  // what its file holds that is only carried
  QDateTime seen_on_disk_;                       // of path_, when it was read or written here
  int saves_in_work_ = 0;
  bool last_save_failed_ = false, is_showing_ = false;
  bool has_page_of_file_ = false;  // it came with a file that was opened
};

}  // namespace felt::desktop
