#include "felt/autosave/recovery.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

#include "felt/autosave/autosave_database.h"
#include "felt/autosave/autosave_reader.h"
#include "felt/autosave/autosave_rows.h"
#include "felt/autosave/edit_blob.h"
#include "felt/autosave/live_ink.h"
#include "felt/io/events/event_reader.h"
#include "felt/session/session.h"
#include "felt/store/byte_writer.h"
#include "felt/tools/tool.h"

namespace felt {
namespace {

namespace fs = std::filesystem;

/// Returns the time when a file was last written, in seconds since 1970, or 0 if it does not exist.
std::int64_t changed_at(const std::string& path) {
  struct stat info {};
  return ::stat(path.c_str(), &info) == 0 ? std::int64_t{info.st_mtime} : 0;
}

std::int64_t autosave_changed_at(const std::string& folder) {
  const std::string path = folder + '/' + kAutosaveDatabaseFile;
  return std::max(changed_at(path), changed_at(path + "-wal"));
}

/// A folder with a copy of a database. The destructor deletes it.
class DatabaseCopy {
 public:
  static Result<DatabaseCopy> of(const std::string& folder) {
    std::error_code error;
    const fs::path temporary = fs::temp_directory_path(error);
    std::string why;
    for (const fs::path& place : {fs::path(folder).parent_path(), temporary}) {
      DatabaseCopy copy;
      const Result<void> made = copy.make(place.string(), folder);
      if (made) return copy;
      why = made.error().message;
    }
    return fail(ErrorCode::kIo, folder + ": cannot copy: " + why);
  }
  DatabaseCopy(DatabaseCopy&& other) noexcept
      : folder_(std::exchange(other.folder_, {})), lock_(std::move(other.lock_)) {}
  DatabaseCopy& operator=(DatabaseCopy&& other) = delete;
  ~DatabaseCopy() {
    if (!folder_.empty()) static_cast<void>(remove_autosave_folder(folder_));
  }
  [[nodiscard]] std::string path() const { return folder_ + '/' + kCopiedDatabaseFile; }

 private:
  DatabaseCopy() = default;

  Result<void> make(const std::string& place, const std::string& from) {
    std::string name = place + "/copy-XXXXXX";
    if (!::mkdtemp(name.data())) return fail(ErrorCode::kIo, place + ": not writable");
    folder_ = name;
    // Locks the copy's folder, so that no process deletes it as an abandoned autosave.
    Result<FolderLock> lock = FolderLock::take(folder_);
    if (!lock) return tl::unexpected(lock.error());
    lock_ = *std::move(lock);
    const std::string store = from + '/' + kAutosaveDatabaseFile;
    for (const char* end : {"", "-wal"}) {
      std::error_code error;
      const bool there = fs::exists(store + end, error);
      if (error) return fail(ErrorCode::kIo, store + end + ": " + error.message());
      if (*end != '\0' && !there) continue;
      fs::copy_file(store + end, path() + end, error);
      if (error) return fail(ErrorCode::kIo, store + end + ": " + error.message());
    }
    return {};
  }

  std::string folder_;
  std::optional<FolderLock> lock_;
};

/// Builds a drawing from the rows of a database.
class Assembly {
 public:
  explicit Assembly(const AutosaveReader& database, std::vector<std::string> problems)
      : database_(database) {
    out_.problems = std::move(problems);
  }

  Result<Recovered> run() {
    read_info();
    read_base();
    read_edits();
    use_about();
    if (database_.ran_out_of_memory()) return fail(ErrorCode::kIo, "not enough memory");
    if (failure_) return tl::unexpected(*failure_);
    read_extras();
    read_live();
    if (database_.ran_out_of_memory()) return fail(ErrorCode::kIo, "not enough memory");
    return std::move(out_);
  }

 private:
  struct Generation {
    std::int64_t id = 0, serial = 0, parts = 0;
  };

  /// Notes an error. Damaged data is left out. An error of another kind (kIo, for example too
  /// little memory) fails the recovery, because the data may be intact.
  void note(const Error& error) {
    if (error.code == ErrorCode::kIo && !failure_) failure_ = error;
  }

  void problem(std::string what) { out_.problems.push_back(std::move(what)); }

  void read_info() {
    bool whole = true;
    const bool all = database_.rows("about", "id", "crc, bytes", 1, [&](const Statement& row) {
      whole = false;
      if (row_crc(1, 0, row.blob(2)) != row.integer(1)) return;
      Result<AutosaveInfo> about = read_about_row(row.blob(2));
      if (!about) return note(about.error());
      about_ = *std::move(about);
      whole = about_.has_value();
    });
    if (!whole || !all)
      problem("the name, the page and the colours of the drawing could not be read");
    if (!about_) return;
    out_.name = about_->name;
    out_.path = about_->path;
  }

  static Result<AutosaveInfo> read_about_row(std::string_view bytes) {
    return felt::read_info(bytes);
  }

  /// Returns the newest complete base.
  std::optional<Generation> find_generation() {
    std::optional<Generation> found;
    database_.rows("generation", "id", "serial, parts, crc", 0, [&found](const Statement& row) {
      const Generation row_says{row.integer(0), row.integer(1), row.integer(2)};
      std::string parts;
      ByteWriter(parts).u64(static_cast<std::uint64_t>(row_says.parts));
      const std::int64_t crc = row_crc(static_cast<std::uint64_t>(row_says.id),
                                       static_cast<std::uint64_t>(row_says.serial), parts);
      if (crc == row.integer(3)) found = row_says;
    });
    return found;
  }

  void read_base() {
    if (const auto generation = find_generation()) {
      first_serial_ = generation->serial;
      return read_parts(generation->id, generation->parts);
    }
    // The process died before it completed the base of a drawing that it had just opened.
    if (!out_.path.empty()) {
      if (Result<Drawing> file = read_felt(out_.path)) {
        out_.drawing = *std::move(file);
        return problem("the drawing had not been copied completely; this is " + out_.path +
                       " as it is now, with the changes made since it was opened");
      }
    }
    read_parts(1, 0);
    problem("the drawing had not been copied completely; some of its first strokes are missing");
  }

  /// Reads the parts of a base. `parts` is the expected number, or 0 if it is not known.
  void read_parts(std::int64_t generation, std::int64_t parts) {
    std::map<std::int64_t, std::string> rows;
    const auto first = base_row(static_cast<std::uint64_t>(generation), 0);
    database_.rows("base", "id", "crc, bytes", first, [&](const Statement& row) {
      const std::int64_t part = row.integer(0) - first;
      if (part >= std::int64_t{1} << 32) return;
      const std::int64_t crc = row_crc(static_cast<std::uint64_t>(generation),
                                       static_cast<std::uint64_t>(part), row.blob(2));
      if (crc == row.integer(1)) rows.emplace(part, row.blob(2));
    });
    std::int64_t lost = parts > 0 ? parts - static_cast<std::int64_t>(rows.size()) : 0;
    if (const auto head = rows.find(0); head != rows.end()) {
      if (Result<Drawing> drawing = read_base_head(head->second)) {
        out_.drawing = *std::move(drawing);
      } else {
        ++lost;
        note(drawing.error());
      }
    }
    Edit edit;
    std::map<LayerId, std::size_t> places, fill_places;
    for (const auto& [part, bytes] : rows) {
      if (part == 0) continue;
      if (Result<BaseRun> run = read_base_run(bytes)) {
        add_run(*std::move(run), edit, places, fill_places);
      } else {
        ++lost;
      }
    }
    const Result<void> done = out_.drawing.document.apply(edit);
    if (!done) problem("the first strokes of the drawing are invalid: " + done.error().message);
    if (lost > 0) {
      problem("of the drawing as it was before the last changes, " + std::to_string(lost) + " of " +
              std::to_string(parts) + " parts could not be read");
    }
  }

  void add_run(BaseRun run, Edit& edit, std::map<LayerId, std::size_t>& places,
               std::map<LayerId, std::size_t>& fill_places) const {
    const Document& document = out_.drawing.document;
    const LayerId layer = document.layer(run.layer) ? run.layer : document.layers().back().id;
    for (auto& [id, stroke] : run.strokes) {
      edit.changes.push_back({id, nullptr, std::move(stroke), {}, {layer, places[layer]++}});
    }
    for (auto& [id, fill] : run.fills) {
      edit.fills.push_back({id, nullptr, std::move(fill), {}, {layer, fill_places[layer]++}});
    }
  }

  void read_edits() {
    std::int64_t next = first_serial_ + 1;
    std::int64_t lost = 0, loose = 0;
    const bool whole =
        database_.rows("edit", "serial", "crc, bytes", next, [&](const Statement& row) {
          const std::int64_t serial = row.integer(0);
          lost += serial - next;
          next = serial + 1;
          const std::string_view bytes = row.blob(2);
          if (row_crc(static_cast<std::uint64_t>(serial), 0, bytes) != row.integer(1)) {
            ++lost;
            return;
          }
          ++out_.edits;
          Document& document = out_.drawing.document;
          const Result<Edit> edit = read_edit_blob(bytes, document);
          if (edit && document.apply(*edit)) return;
          if (apply_what_fits(bytes, document)) {
            ++loose;
          } else {
            ++lost;
          }
        });
    if (!whole && lost == 0) problem("the last changes could not be read");
    if (lost > 0) problem(std::to_string(lost) + " changes could not be read");
    if (loose > 0) {
      problem(std::to_string(loose) +
              " changes applied to parts that are missing; their strokes were recovered");
    }
  }

  void use_about() {
    out_.has_changes = about_ ? about_->modified : out_.edits > 0;
    if (about_) {
      about_->head.document = std::move(out_.drawing.document);
      about_->head.names = std::move(out_.drawing.names);
      out_.drawing = std::move(about_->head);
    }
    out_.drawing.extras = nullptr;
    if (!out_.drawing.document.layer(out_.drawing.layer)) out_.drawing.layer = {};
  }

  /// Recordings, and content of a newer Feltline, do not change while drawing, so they are read
  /// from the user's file, if that is still the file that was last read or saved.
  void read_extras() {
    if (out_.path.empty() || (about_ && about_->has_extras == false)) return;
    const std::optional<FileStamp> stamp = FileStamp::of(out_.path);
    const Result<Drawing> file = read_felt(out_.path);
    const bool had_extras = about_ && about_->has_extras == true;
    const bool is_same = about_ && stamp && stamp == about_->stamp;
    if (file && (is_same || file->document == out_.drawing.document)) {
      out_.drawing.extras = file->extras;
    } else if (had_extras || (file && file->extras)) {
      problem(
          "recordings and other data beside the drawing were not recovered, because " + out_.path +
          (stamp ? " has changed since Feltline last read or saved it" : " is not there any more"));
    }
  }

  void read_live() {
    LiveStretch stretch;
    bool good = true, any = false;
    std::int64_t next = 0;
    const bool whole = database_.rows(
        "live", "sequence", "kind, length, crc, bytes", 0, [&](const Statement& row) {
          if (!good) return;
          const std::int64_t sequence = row.integer(0), kind = row.integer(1);
          const std::string_view bytes = row.blob(4);
          good = (!any || sequence == next) && row.integer(2) == std::int64_t(bytes.size()) &&
                 row.integer(3) == row_crc(static_cast<std::uint64_t>(sequence),
                                           static_cast<std::uint64_t>(kind), bytes) &&
                 kind == (any ? kind : std::int64_t(LiveKind::kContext)) &&
                 read_live_chunk(static_cast<LiveKind>(kind), bytes, stretch);
          next = sequence + 1;
          any = true;
        });
    if (!whole || !good) problem("the end of the line that was being drawn could not be read");
    if (!stretch.script.empty()) play(stretch);
  }

  /// Draws the gesture that was in progress from its samples.
  void play(LiveStretch& stretch) {
    SessionOptions options;
    options.document = std::move(out_.drawing.document);
    options.selection = std::move(stretch.selection);
    Session session(make_tools(), std::move(options));
    std::int64_t reported_ns = INT64_MIN;
    ScriptSink sink;
    sink.event = [&](const Event& event) {
      const bool is_sample = std::holds_alternative<PenEvent>(event.what);
      if (is_sample) reported_ns = std::max(reported_ns, event.time_ns);
      Result<void> done = session.apply(event);
      // The last edit may have removed the active layer before the new active layer was saved. The
      // session then uses the highest layer, as the original session did.
      if (!done && std::holds_alternative<LayerEvent>(event.what)) done = {};
      return done;
    };
    // If an event fails, the gesture ends at that event, with the ink so far.
    if (const Result<void> done = read_script("line", read_text(stretch.script), sink); !done) {
      problem("the line that was being drawn could not be completed: " + done.error().message);
    }
    for (const PenSample& sample : stretch.overhang) {
      if (sample.time_ns <= reported_ns) continue;
      reported_ns = sample.time_ns;
      const Result<void> done = session.sample(sample);
      if (!done && done.error().code != ErrorCode::kLimitExceeded) break;
    }
    static_cast<void>(session.finish());
    out_.last_sample_ns = reported_ns;
    out_.has_changes = out_.has_changes || session.edit_count() > 0;
    out_.drawing.document = session.document();
  }

  const AutosaveReader& database_;
  Recovered out_;
  std::optional<AutosaveInfo> about_;
  std::optional<Error> failure_;
  std::int64_t first_serial_ = 0;
};

}  // namespace

Result<void> AbandonedAutosave::remove() && {
  return remove_autosave_folder(folder);
}

std::vector<AbandonedAutosave> find_abandoned_autosaves(const std::vector<std::string>& roots) {
  std::vector<AbandonedAutosave> found;
  for (const std::string& root : roots) {
    std::error_code error, end;
    for (fs::directory_iterator at(root, end); !end && at != fs::directory_iterator();
         at.increment(end)) {
      const fs::directory_entry& entry = *at;
      if (!entry.is_directory(error) || entry.is_symlink(error)) continue;
      std::string folder = entry.path().string();
      Result<FolderLock> lock = FolderLock::take(folder);
      if (!lock) continue;  // its process is still running
      const fs::file_status there = fs::status(folder + '/' + kAutosaveDatabaseFile, error);
      // If the file cannot be examined, it may be a drawing, so the folder is kept.
      if (there.type() == fs::file_type::none) continue;
      if (fs::exists(there)) {
        const std::int64_t when = autosave_changed_at(folder);
        found.push_back({std::move(folder), *std::move(lock), when});
      } else {
        static_cast<void>(remove_autosave_folder(folder));
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const AbandonedAutosave& a, const AbandonedAutosave& b) {
    return std::pair(a.changed_at_s, a.folder) > std::pair(b.changed_at_s, b.folder);
  });
  return found;
}

Result<Recovered> recover_autosave(const std::string& folder) {
  const Result<DatabaseCopy> copy = DatabaseCopy::of(folder);
  if (!copy) return tl::unexpected(copy.error());
  std::vector<std::string> problems;
  const Result<AutosaveReader> database = AutosaveReader::open(copy->path(), problems);
  if (!database) return tl::unexpected(with_context(database.error(), folder));
  Result<Recovered> out = Assembly(*database, std::move(problems)).run();
  if (!out) return tl::unexpected(with_context(out.error(), folder));
  out->changed_at_s = autosave_changed_at(folder);
  return out;
}

}  // namespace felt
