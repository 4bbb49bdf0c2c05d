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

/// What the database has of its drawing besides the ink.
struct AutosaveInfo {
  std::string name;       ///< what the user calls it
  std::string path;       ///< of the user's file, "" if there is none
  bool modified = false;  ///< there are unsaved changes
  /// Page, material, colour, palette, view, layer in use. The document in it is ignored.
  Drawing head;
};

/// Kinds of live chunks, the pieces of the unfinished gesture (live_ink.h).
enum class LiveKind : std::uint8_t {
  kContext = 1,  ///< what the gesture depends on besides the document
  kEvents = 2,   ///< lines of an event script: what the session handled
  kSamples = 3,  ///< samples of the haptic loop that the session has not handled yet
  kLeaning = 4,  ///< the same, of a pen whose tilt is known
};

/// An autosave of a drawing: an SQLite database in WAL mode, each commit synchronised
/// (synchronous=FULL), in a folder of its own of mode 0700 that is locked by its process
/// (FolderLock). It holds
///   - the drawing as it was once, the *base*, in parts of some 64 KiB;
///   - every edit since, by a serial number that grows by one;
///   - `AutosaveInfo`;
///   - the live chunks: what was drawn and is no edit yet.
/// Every row carries a CRC-32C over its numbers and bytes. Recovery (recovery.h) needs no more than
/// this folder.
///
///   Result<AutosaveDatabase> database = AutosaveDatabase::create(root, "a");
///   database->write_base(drawing);             // or begin_base, and write_base_part() until done
///   database->put_info({name, path, false, {}});
///   database->commit();
///   database->add_edit(edit); database->clear_live(); database->commit();     // a finished
///   gesture database->add_live(LiveKind::kEvents, lines); database->commit();         // or an
///   unfinished one std::move(*database).remove();             // if everything is in the user's
///   file
///
/// What was added since the last commit is missing after a crash, whole or in part; what was
/// committed is there, also after a power cut on a disk that keeps its word. A new base replaces
/// the last one, and the edits up to its beginning, in the commit that completes it.
///
/// After an error nothing in this database may be tried again: an fsync that failed once succeeds
/// the next time, whatever was lost. Create another one, from memory, in another folder. Messages
/// begin with the folder. One thread at a time.
class AutosaveDatabase {
 public:
  /// Creates a database without a base in a new folder `root`/`name`, or `name`-2, -3 ... if that
  /// exists. `vfs`: SQLite's name of a file system, for tests of faults; null is the system's.
  static Result<AutosaveDatabase> create(const std::string& root, const std::string& name,
                                         const char* vfs = nullptr);

  AutosaveDatabase(AutosaveDatabase&& other) noexcept;
  AutosaveDatabase& operator=(AutosaveDatabase&& other) noexcept;
  /// Closes it and leaves the files, as a crash does.
  ~AutosaveDatabase();

  /// Writes a whole base, which is valid from the next commit on.
  Result<void> write_base(const Drawing& drawing);
  /// Starts a base: the drawing after the last edit that was added. Requires !base_in_progress().
  Result<void> begin_base(std::shared_ptr<const Drawing> drawing);
  /// Writes the next part of it. True after the last one: the base is valid from the next commit
  /// on.
  Result<bool> write_base_part();
  [[nodiscard]] bool base_in_progress() const noexcept { return base_ != nullptr; }
  /// Deletes a few of the rows that no base needs any more. False if there are none left.
  Result<bool> tidy();

  /// Returns its serial: 1, 2, 3 ...
  Result<std::uint64_t> add_edit(const Edit& edit);
  Result<void> put_info(const AutosaveInfo& about);
  Result<void> add_live(LiveKind kind, std::string_view bytes);
  /// The unfinished gesture has become an edit, or nothing.
  Result<void> clear_live();
  /// Makes everything since the last commit durable.
  Result<void> commit();

  /// Of the last edit that was added.
  [[nodiscard]] std::uint64_t serial() const noexcept { return serial_; }
  /// Bytes of edits since the newest base: when this has grown large, a new base saves time later.
  [[nodiscard]] std::uint64_t edit_bytes() const noexcept { return edit_bytes_; }
  [[nodiscard]] const std::string& folder() const noexcept { return folder_; }

  /// Closes it and deletes the folder with all that is in it.
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

/// Name of the database in its folder; `-wal` is beside it.
inline constexpr const char* kAutosaveDatabaseFile = "store.db";

}  // namespace felt
