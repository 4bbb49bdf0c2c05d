#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "felt/autosave/folder_lock.h"
#include "felt/base/result.h"
#include "felt/document/edit.h"
#include "felt/store/felt_file.h"

struct sqlite3;

namespace felt {

/// Tells whether a file is still the one that was read or written: its size and the time of its
/// last change.
struct FileStamp {
  std::uint64_t bytes = 0;
  std::int64_t changed_at_ns = 0;  ///< since 1970

  /// Returns the stamp of a regular file, or nullopt if there is none at `path`.
  static std::optional<FileStamp> of(const std::string& path);
  friend bool operator==(const FileStamp&, const FileStamp&) noexcept = default;
};

/// The content of a database apart from the ink.
struct AutosaveInfo {
  std::string name;       ///< the drawing's name, as shown to the user
  std::string path;       ///< path of the user's file; "" if the drawing has no file
  bool modified = false;  ///< true if the drawing has unsaved changes
  /// Page, colour, palette, view, materials and active layer. The document of `head` is ignored.
  Drawing head;
  /// The state of the file at `path` after it was read or saved; nullopt if the drawing has no
  /// file.
  std::optional<FileStamp> stamp{};
  /// True if the drawing has extras, which only the user's file contains; nullopt if the autosave
  /// is of a version that did not note it.
  std::optional<bool> has_extras{};
};

/// Kinds of live chunks, which hold the unfinished gesture (live_ink.h).
enum class LiveKind : std::uint8_t {
  kContext = 1,  ///< state that the gesture depends on, besides the document
  kEvents = 2,   ///< events that the session handled, as lines of an event script
  kSamples = 3,  ///< samples of the haptic loop that the session has not handled yet
  kTilted = 4,   ///< like kSamples, but with the tilt of the pen
};

/// An autosave of a drawing: an SQLite database in WAL mode that syncs each commit to the disk
/// (synchronous=FULL). It is in a private folder (mode 0700), which its process has locked
/// (FolderLock). The database holds
///   - the *base*: an earlier state of the whole drawing, in parts of about 64 KiB;
///   - every edit since the base, with a serial number that grows by one;
///   - `AutosaveInfo`;
///   - the live chunks: the gesture that is not an edit yet.
/// Every row has a CRC-32C of its numbers and bytes. Recovery (recovery.h) needs only this folder.
///
///   Result<AutosaveDatabase> database = AutosaveDatabase::create(root, "a");
///   database->write_base(drawing);             // or begin_base, and write_base_part() until done
///   database->put_info({name, path, false, {}});
///   database->commit();
///   database->add_edit(edit);                  // a finished gesture
///   database->clear_live();
///   database->commit();
///   database->add_live(LiveKind::kEvents, lines);   // or an unfinished gesture
///   database->commit();
///   std::move(*database).remove();             // if everything is in the user's file
///
/// All committed data survives a crash of the program and, if the disk honours fsync, also a power
/// failure. Data that was added after the last commit may be lost. After the commit that completes
/// a new base, tidy() deletes the previous base and the edits that the new base contains.
///
/// After an error, do not use this database again, because after a failed fsync the next fsync may
/// succeed even though data was lost. Create a new database in another folder from the data in
/// memory. Error messages begin with the path of the folder. Not thread-safe.
class AutosaveDatabase {
 public:
  /// Creates a database without a base in a new folder `root`/`name`, or `name`-2, -3 ... if that
  /// folder exists. `vfs` is the name of an SQLite file system, for tests of faults; if null, the
  /// system's file system is used.
  static Result<AutosaveDatabase> create(const std::string& root, const std::string& name,
                                         const char* vfs = nullptr);

  AutosaveDatabase(AutosaveDatabase&& other) noexcept;
  AutosaveDatabase& operator=(AutosaveDatabase&& other) noexcept;
  /// Closes the database and leaves its files, as after a crash.
  ~AutosaveDatabase();

  /// Writes a whole base. The base is valid after the next commit.
  Result<void> write_base(const Drawing& drawing);
  /// Starts to write a base. `drawing` must be the drawing after the last edit that was added.
  /// Requires !base_in_progress().
  Result<void> begin_base(std::shared_ptr<const Drawing> drawing);
  /// Writes the next part of the base. Returns true after the last part; the base is valid after
  /// the next commit.
  Result<bool> write_base_part();
  [[nodiscard]] bool base_in_progress() const noexcept { return base_ != nullptr; }
  /// Deletes a few of the rows that the newest base has replaced. Returns false if no such rows are
  /// left, or if a base is in progress.
  Result<bool> tidy();

  /// Adds an edit and returns its serial number: 1, 2, 3 ...
  Result<std::uint64_t> add_edit(const Edit& edit);
  Result<void> put_info(const AutosaveInfo& about);
  Result<void> add_live(LiveKind kind, std::string_view bytes);
  /// Deletes the live chunks. Called when the unfinished gesture has become an edit or was
  /// discarded.
  Result<void> clear_live();
  /// Makes everything since the last commit durable.
  Result<void> commit();

  /// Returns the serial number of the last edit that was added.
  [[nodiscard]] std::uint64_t serial() const noexcept { return serial_; }
  /// Returns the size in bytes of the edits since the newest base. If this size is large, a new
  /// base makes recovery faster.
  [[nodiscard]] std::uint64_t edit_bytes() const noexcept { return edit_bytes_; }
  [[nodiscard]] const std::string& folder() const noexcept { return folder_; }

  /// Closes the database and deletes its folder.
  Result<void> remove() &&;

 private:
  struct BaseInProgress;
  struct Statements;

  AutosaveDatabase();
  Result<void> open(const std::string& name, const char* vfs);
  Result<void> run(const char* sql);
  Result<void> want_transaction();
  Result<void> complete_base();
  [[nodiscard]] tl::unexpected<Error> error() const;
  void close() noexcept;

  std::string folder_;
  std::optional<FolderLock> lock_;
  sqlite3* db_ = nullptr;
  std::unique_ptr<Statements> statements_;
  std::unique_ptr<BaseInProgress> base_;
  bool in_transaction_ = false, untidy_ = false;
  std::uint64_t serial_ = 0, generation_ = 0, first_serial_ = 0, live_ = 0;
  std::uint64_t edit_bytes_ = 0, edit_bytes_before_base_ = 0;
};

/// File name of the database. SQLite's log is in the same folder; its name ends in `-wal`.
inline constexpr const char* kAutosaveDatabaseFile = "store.db";

}  // namespace felt
