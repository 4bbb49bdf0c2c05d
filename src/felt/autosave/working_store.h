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

/// What a working store says of its drawing besides the ink.
struct WorkingAbout {
  std::string name;       ///< what the person calls it
  std::string path;       ///< the person's file, "" where there is none
  bool modified = false;  ///< it holds what no file of the person's has
  /// Page, material, colour, palette, view, layer in use. The document in it counts for nothing:
  /// no strokes, and none need be there.
  StoredDrawing head;
};

/// What a live chunk, a piece of the unfinished gesture, is made of (live_ink.h).
enum class LiveKind : std::uint8_t {
  kContext = 1,  ///< what the gesture depends on besides the document
  kEvents = 2,   ///< lines of an event script that the session was told
  kSamples = 3,  ///< samples of the haptic loop that the session was not told yet
  kLeaning = 4,  ///< likewise, of a pen whose lean is known
};

/// The drawing on the desk while it is worked on, on disk: one SQLite database in WAL mode, each
/// commit synchronised (synchronous=FULL), in a folder of its own of mode 0700 that is locked by
/// its process (FolderLock). It holds
///   - the drawing as it was once, the *base*, in parts of some 64 KiB;
///   - every edit since, by a serial number that grows by one;
///   - `WorkingAbout`;
///   - the live chunks: what was drawn and is no edit yet.
/// Every row carries a CRC-32C over its numbers and bytes. Recovery (recovery.h) needs no more than
/// this folder.
///
///   Result<WorkingStore> store = WorkingStore::create(root);
///   store->write_base(drawing);                // or begin_base, and write_base_part() until done
///   store->put_about({name, path, false, {}});
///   store->commit();
///   store->add_edit(edit); store->clear_live(); store->commit();     // a gesture came to this
///   store->add_live(LiveKind::kEvents, lines); store->commit();      // or is still in work
///   std::move(*store).remove();                // all is in the person's file; else it stays
///
/// What was added since the last commit is not there after a crash, whole or in part; what was
/// committed is, also after a power cut on a disk that keeps its word. A new base takes the place
/// of the last one, and of the edits up to its beginning, in the commit that completes it.
///
/// After an error nothing in this store may be tried again: an fsync that failed once succeeds the
/// next time whatever was lost. Make another store, from memory, in another place. Messages begin
/// with the folder. One thread at a time.
class WorkingStore {
 public:
  /// A store without a base, in a new folder `root`/`name`, or `name`-2, -3 ... where that exists.
  /// `vfs`: SQLite's name of a file system, for tests of faults; null is the system's.
  static Result<WorkingStore> create(const std::string& root, const std::string& name,
                                     const char* vfs = nullptr);

  WorkingStore(WorkingStore&& other) noexcept;
  WorkingStore& operator=(WorkingStore&& other) noexcept;
  /// Closes it and leaves everything where it is, as a crash does.
  ~WorkingStore();

  /// All of it in one go; it counts from the next commit on.
  Result<void> write_base(const StoredDrawing& drawing);
  /// The drawing as it is after the last edit that was added. Requires no other base in work.
  Result<void> begin_base(std::shared_ptr<const StoredDrawing> drawing);
  /// The next part of it. True once all are there: then it counts from the next commit on.
  Result<bool> write_base_part();
  [[nodiscard]] bool base_in_work() const noexcept { return base_ != nullptr; }
  /// Deletes a few of the rows that no base needs any more; false: there were none.
  Result<bool> tidy();

  /// Returns its serial: 1, 2, 3 ...
  Result<std::uint64_t> add_edit(const Edit& edit);
  Result<void> put_about(const WorkingAbout& about);
  Result<void> add_live(LiveKind kind, std::string_view bytes);
  /// What was in work has become an edit, or nothing.
  Result<void> clear_live();
  /// Makes durable what was added since the last commit; nothing where nothing was.
  Result<void> commit();

  /// Of the last edit that was added.
  [[nodiscard]] std::uint64_t serial() const noexcept { return serial_; }
  /// Bytes of edits since the newest base: when this has grown large, a new base saves time later.
  [[nodiscard]] std::uint64_t edit_bytes() const noexcept { return edit_bytes_; }
  [[nodiscard]] const std::string& folder() const noexcept { return folder_; }

  /// Closes it and deletes the folder with all that is in it.
  Result<void> remove() &&;

 private:
  struct BaseInWork;
  struct Statements;

  WorkingStore();
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
  std::unique_ptr<BaseInWork> base_;
  bool in_transaction_ = false, untidy_ = false;
  std::uint64_t serial_ = 0, generation_ = 0, first_serial_ = 0, live_ = 0;
  std::uint64_t edit_bytes_ = 0, edit_bytes_before_base_ = 0;
};

/// The database's name in the folder; `-wal` is beside it.
inline constexpr const char* kWorkingStoreFile = "store.db";

}  // namespace felt
