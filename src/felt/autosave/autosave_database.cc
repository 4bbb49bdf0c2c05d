#include "felt/autosave/autosave_database.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "felt/autosave/autosave_rows.h"
#include "felt/autosave/edit_blob.h"
#include "felt/base/check.h"
#include "felt/store/byte_writer.h"
#include "felt/store/database.h"

namespace felt {
namespace {

constexpr int kMaxNames = 1000;
constexpr int kGrowBytes = 1 << 20;  // step of the file's growth, to notice a full disk early
constexpr int kCheckpointFrames = 1000;

bool sync_folder(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool done = ::fsync(fd) == 0;
  return ::close(fd) == 0 && done;
}

tl::unexpected<Error> database_error(const std::string& path, const char* doing) {
  const int reason = errno;
  return fail(ErrorCode::kIo, path + ": " + doing + ": " + std::strerror(reason));
}

}  // namespace

std::optional<FileStamp> FileStamp::of(const std::string& path) {
  struct stat info {};
  if (path.empty() || ::stat(path.c_str(), &info) != 0 || !S_ISREG(info.st_mode)) return {};
  constexpr std::int64_t kNsPerS = 1'000'000'000;
  return FileStamp{static_cast<std::uint64_t>(info.st_size),
                   info.st_mtim.tv_sec * kNsPerS + info.st_mtim.tv_nsec};
}

/// The prepared statements and the size of the WAL. This struct is on the heap, because SQLite
/// keeps a pointer to it (for count_frames) when the database object moves.
struct AutosaveDatabase::Statements {
  Statement base, generation, edit, about, live;
  int wal_frames = 0;

  static int count_frames(void* self, sqlite3*, const char*, int frames) {
    static_cast<Statements*>(self)->wal_frames = frames;
    return SQLITE_OK;
  }
};

struct AutosaveDatabase::BaseInProgress {
  std::shared_ptr<const Drawing> drawing;
  std::uint64_t serial = 0, part = 0;
  std::size_t layer = 0, index = 0;
};

AutosaveDatabase::AutosaveDatabase() = default;

AutosaveDatabase::AutosaveDatabase(AutosaveDatabase&& other) noexcept {
  *this = std::move(other);
}

AutosaveDatabase& AutosaveDatabase::operator=(AutosaveDatabase&& other) noexcept {
  std::swap(folder_, other.folder_);
  std::swap(lock_, other.lock_);
  std::swap(db_, other.db_);
  std::swap(statements_, other.statements_);
  std::swap(base_, other.base_);
  std::swap(in_transaction_, other.in_transaction_);
  std::swap(untidy_, other.untidy_);
  std::swap(serial_, other.serial_);
  std::swap(generation_, other.generation_);
  std::swap(first_serial_, other.first_serial_);
  std::swap(live_, other.live_);
  std::swap(edit_bytes_, other.edit_bytes_);
  std::swap(edit_bytes_before_base_, other.edit_bytes_before_base_);
  return *this;
}

AutosaveDatabase::~AutosaveDatabase() {
  close();
}

void AutosaveDatabase::close() noexcept {
  statements_.reset();
  sqlite3_close(std::exchange(db_, nullptr));
}

tl::unexpected<Error> AutosaveDatabase::error() const {
  std::string why = db_ ? sqlite3_errmsg(db_) : "not enough memory";
  const int reason = db_ ? sqlite3_system_errno(db_) : 0;
  if (reason != 0) why += std::string(" (") + std::strerror(reason) + ")";
  return fail(ErrorCode::kIo, folder_ + ": " + why);
}

Result<void> AutosaveDatabase::run(const char* sql) {
  if (sqlite3_exec(db_, sql, nullptr, nullptr, nullptr) != SQLITE_OK) return error();
  return {};
}

Result<AutosaveDatabase> AutosaveDatabase::create(const std::string& root, const std::string& name,
                                                  const char* vfs) {
  if (auto ok = make_private_folder(root); !ok) return tl::unexpected(ok.error());
  for (int number = 1; number <= kMaxNames; ++number) {
    std::string folder = root + '/' + name;
    if (number > 1) folder += '-' + std::to_string(number);
    if (::mkdir(folder.c_str(), 0700) != 0) {
      if (errno == EEXIST) continue;
      return database_error(folder, "cannot create");
    }
    Result<FolderLock> lock = FolderLock::take(folder);
    if (!lock) {
      // A process that searches for abandoned autosaves has just locked the folder and will remove
      // it.
      if (lock.error().code != ErrorCode::kIo) continue;
      return tl::unexpected(lock.error());
    }
    AutosaveDatabase database;
    database.folder_ = std::move(folder);
    database.lock_ = *std::move(lock);
    // Uses another file name until the schema is complete.
    Result<void> made = database.open(kNewDatabaseFile, vfs);
    if (made) {
      std::string schema = "BEGIN";
      for (const char* table : kAutosaveTables) schema += std::string("; ") + table;
      schema += "; PRAGMA application_id=" + std::to_string(kAutosaveApplicationId) +
                "; PRAGMA user_version=" + std::to_string(kAutosaveVersion) + "; COMMIT";
      made = database.run(schema.c_str());
    }
    if (made && sqlite3_wal_checkpoint_v2(database.db_, nullptr, SQLITE_CHECKPOINT_TRUNCATE,
                                          nullptr, nullptr) != SQLITE_OK) {
      made = database.error();
    }
    database.close();
    const std::string from = database.folder_ + '/' + kNewDatabaseFile;
    if (made) {
      ::unlink((from + "-wal").c_str());
      const std::string to = database.folder_ + '/' + kAutosaveDatabaseFile;
      if (::rename(from.c_str(), to.c_str()) != 0 || !sync_folder(database.folder_) ||
          !sync_folder(root)) {
        made = database_error(database.folder_, "cannot create");
      }
    }
    if (made) made = database.open(kAutosaveDatabaseFile, vfs);
    if (made) return database;
    static_cast<void>(std::move(database).remove());  // no other process has opened it
    return tl::unexpected(made.error());
  }
  return fail(ErrorCode::kIo, root + '/' + name + ": too many files have this name");
}

Result<void> AutosaveDatabase::open(const std::string& name, const char* vfs) {
  const std::string path = folder_ + '/' + name;
  const int flags =
      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_PRIVATECACHE;
  if (sqlite3_open_v2(path.c_str(), &db_, flags, vfs) != SQLITE_OK) return error();
  // Makes no checkpoint on closing: recovery reads the WAL, and a file that failed must not be
  // written again.
  sqlite3_db_config(db_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
  sqlite3_extended_result_codes(db_, 1);
  int grow = kGrowBytes;
  sqlite3_file_control(db_, "main", SQLITE_FCNTL_CHUNK_SIZE, &grow);
  // Only one process uses the database, so no shared memory file is needed. Our own checkpoints
  // report their failures; SQLite's automatic checkpoints would not.
  if (auto ok = run("PRAGMA locking_mode=EXCLUSIVE; PRAGMA journal_mode=WAL; "
                    "PRAGMA synchronous=FULL; PRAGMA wal_autocheckpoint=0; "
                    "PRAGMA temp_store=MEMORY");
      !ok) {
    return ok;
  }
  statements_ = std::make_unique<Statements>();
  sqlite3_wal_hook(db_, &Statements::count_frames, statements_.get());
  const auto mode = Statement::of(db_, "PRAGMA journal_mode");
  if (!mode) return error();
  if (const Result<bool> row = mode->step(); !row || !*row) return error();
  if (mode->text(0) != "wal")
    return fail(ErrorCode::kIo, folder_ + ": the file system does not support a write-ahead log");
  if (name != kAutosaveDatabaseFile) return {};
  const auto prepare = [this](Statement& statement, const char* sql) {
    Result<Statement> made = Statement::of(db_, sql);
    if (made) statement = *std::move(made);
    return made.has_value();
  };
  if (!prepare(statements_->base, "INSERT INTO base VALUES(?,?,?)") ||
      !prepare(statements_->generation, "INSERT INTO generation VALUES(?,?,?,?)") ||
      !prepare(statements_->edit, "INSERT INTO edit VALUES(?,?,?)") ||
      !prepare(statements_->about, "INSERT OR REPLACE INTO about VALUES(1,?,?)") ||
      !prepare(statements_->live, "INSERT INTO live VALUES(?,?,?,?,?)")) {
    return error();
  }
  return {};
}

Result<void> AutosaveDatabase::want_transaction() {
  if (in_transaction_) return {};
  auto begun = run("BEGIN");
  in_transaction_ = begun.has_value();
  return begun;
}

namespace {

Result<void> step(const Statement& row) {
  const Result<bool> done = row.step();
  row.reset();
  if (!done) return tl::unexpected(done.error());
  return {};
}

}  // namespace

Result<void> AutosaveDatabase::write_base(const Drawing& drawing) {
  auto shared = std::make_shared<const Drawing>(drawing);
  if (auto ok = begin_base(std::move(shared)); !ok) return ok;
  for (;;) {
    const Result<bool> done = write_base_part();
    if (!done) return tl::unexpected(done.error());
    if (*done) return {};
  }
}

Result<void> AutosaveDatabase::begin_base(std::shared_ptr<const Drawing> drawing) {
  FELT_CHECK(!base_ && drawing);
  base_ = std::make_unique<BaseInProgress>(BaseInProgress{std::move(drawing), serial_, 0, 0, 0});
  ++generation_;
  edit_bytes_before_base_ = edit_bytes_;
  return {};
}

Result<bool> AutosaveDatabase::write_base_part() {
  FELT_CHECK(base_ != nullptr);
  if (auto ok = want_transaction(); !ok) return tl::unexpected(ok.error());
  const Document& document = base_->drawing->document;
  const auto layers = document.layers();
  Result<std::string> bytes;
  if (base_->part == 0) {
    bytes = base_head_bytes(*base_->drawing);
  } else {
    bytes = base_run_bytes(document, layers[base_->layer], base_->index);
  }
  if (!bytes) return tl::unexpected(with_context(bytes.error(), folder_));
  const Statement& row = statements_->base;
  row.bind(1, base_row(generation_, base_->part));
  row.bind(2, row_crc(generation_, base_->part, *bytes));
  row.bind_blob(3, *bytes);
  if (!step(row)) return error();
  ++base_->part;
  const auto size_of = [](const Layer& layer) { return layer.strokes.size() + layer.fills.size(); };
  while (base_->layer < layers.size() && base_->index == size_of(layers[base_->layer])) {
    ++base_->layer;
    base_->index = 0;
  }
  if (base_->layer < layers.size()) return false;
  return complete_base().map([] { return true; });
}

Result<void> AutosaveDatabase::complete_base() {
  const Statement& row = statements_->generation;
  std::string parts;
  ByteWriter(parts).u64(base_->part);
  row.bind(1, static_cast<std::int64_t>(generation_));
  row.bind(2, static_cast<std::int64_t>(base_->serial));
  row.bind(3, static_cast<std::int64_t>(base_->part));
  row.bind(4, row_crc(generation_, base_->serial, parts));
  if (!step(row)) return error();
  first_serial_ = base_->serial;
  edit_bytes_ -= edit_bytes_before_base_;
  untidy_ = generation_ > 1;
  base_.reset();
  return {};
}

Result<bool> AutosaveDatabase::tidy() {
  if (!untidy_ || base_) return false;
  if (auto ok = want_transaction(); !ok) return tl::unexpected(ok.error());
  // Deletes a few rows at a time, so that no commit takes long.
  const std::string sql = "DELETE FROM base WHERE id IN (SELECT id FROM base WHERE id < " +
                          std::to_string(base_row(generation_, 0)) +
                          " LIMIT 4); DELETE FROM generation WHERE id < " +
                          std::to_string(generation_);
  if (auto ok = run(sql.c_str()); !ok) return tl::unexpected(ok.error());
  const std::string edits =
      "DELETE FROM edit WHERE serial IN (SELECT serial FROM edit WHERE "
      "serial <= " +
      std::to_string(first_serial_) + " LIMIT 64)";
  if (auto ok = run(edits.c_str()); !ok) return tl::unexpected(ok.error());
  const std::string left =
      "SELECT EXISTS(SELECT 1 FROM edit WHERE serial <= " + std::to_string(first_serial_) +
      ") OR EXISTS(SELECT 1 FROM base WHERE id < " + std::to_string(base_row(generation_, 0)) + ")";
  const Result<Statement> query = Statement::of(db_, left.c_str());
  if (!query) return error();
  const Result<bool> row = query->step();
  if (!row || !*row) return error();
  untidy_ = query->integer(0) != 0;
  return untidy_;
}

Result<std::uint64_t> AutosaveDatabase::add_edit(const Edit& edit) {
  std::string bytes;
  if (auto ok = append_edit_blob(bytes, edit); !ok) {
    return tl::unexpected(with_context(ok.error(), folder_));
  }
  if (auto ok = want_transaction(); !ok) return tl::unexpected(ok.error());
  const Statement& row = statements_->edit;
  row.bind(1, static_cast<std::int64_t>(++serial_));
  row.bind(2, row_crc(serial_, 0, bytes));
  row.bind_blob(3, bytes);
  if (!step(row)) return error();
  edit_bytes_ += bytes.size();
  return serial_;
}

Result<void> AutosaveDatabase::put_info(const AutosaveInfo& info) {
  const Result<std::string> bytes = info_bytes(info);
  if (!bytes) return tl::unexpected(with_context(bytes.error(), folder_));
  if (auto ok = want_transaction(); !ok) return ok;
  const Statement& row = statements_->about;
  row.bind(1, row_crc(1, 0, *bytes));
  row.bind_blob(2, *bytes);
  if (!step(row)) return error();
  return {};
}

Result<void> AutosaveDatabase::add_live(LiveKind kind, std::string_view bytes) {
  if (auto ok = want_transaction(); !ok) return ok;
  const Statement& row = statements_->live;
  row.bind(1, static_cast<std::int64_t>(++live_));
  row.bind(2, static_cast<std::int64_t>(kind));
  row.bind(3, static_cast<std::int64_t>(bytes.size()));
  row.bind(4, row_crc(live_, static_cast<std::uint64_t>(kind), bytes));
  row.bind_blob(5, bytes);
  if (!step(row)) return error();
  return {};
}

Result<void> AutosaveDatabase::clear_live() {
  return want_transaction().and_then([this] { return run("DELETE FROM live"); });
}

Result<void> AutosaveDatabase::commit() {
  if (!in_transaction_) return {};
  if (auto ok = run("COMMIT"); !ok) return ok;
  in_transaction_ = false;
  if (statements_->wal_frames < kCheckpointFrames) return {};
  statements_->wal_frames = 0;
  if (sqlite3_wal_checkpoint_v2(db_, nullptr, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr) !=
      SQLITE_OK) {
    return error();
  }
  return {};
}

Result<void> AutosaveDatabase::remove() && {
  close();
  return remove_autosave_folder(folder_);
}

}  // namespace felt
