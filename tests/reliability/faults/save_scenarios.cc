// Saves a .felt file: over an existing file, as a new file, through a link, and on file systems
// that lack features.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>

#include "felt/base/atomic_file.h"
#include "tests/reliability/faults/scenario.h"

namespace felt::faults {
namespace {

namespace fs = std::filesystem;

std::string document_in(const std::string& folder) {
  return folder + "/drawing.felt";
}

void prepare_document(const std::string& folder) {
  if (const auto made = write_felt(document_in(folder), drawing_of(0)); !made) {
    std::fprintf(stderr, "%s\n", made.error().message.c_str());
    std::abort();
  }
}

/// Saves the generations `first` to `last` to the same file. Stops at the first error.
void save_generations(const std::string& path, std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t generation = first; generation <= last; ++generation) {
    state->started = generation;
    if (const auto saved = write_felt(path, drawing_of(generation)); !saved) {
      return say(saved.error());
    }
    state->acknowledged = generation;
  }
}

/// Checks that an error names the file and then gives a reason.
std::string check_message(const std::string& path, const FaultState& after) {
  if (after.outcome != Outcome::kError) return "";
  const std::string message = after.message;
  if (message.rfind(path + ": ", 0) != 0) return "an error without the file: " + message;
  return message.size() < path.size() + 10 ? "an error without a reason: " + message : "";
}

/// Checks that no temporary files remain. If the program survived and could remove them, they must
/// be gone immediately, otherwise after the next save.
std::string check_folder(const std::string& folder, const std::string& path,
                         const std::vector<std::string>& known, const FaultState& after) {
  const bool lived = after.outcome == Outcome::kOk || after.outcome == Outcome::kError;
  const bool could_remove =
      !after.persistent && std::string(after.hit_name).rfind("unlink", 0) != 0;
  const std::string left = others_in(folder, known);
  // If the save failed late, the previous file remains under a hidden name because the user may
  // need it.
  const bool is_kept = after.outcome == Outcome::kError && left.ends_with(".old") &&
                       left.find(' ') == std::string::npos;
  if (lived && could_remove && !left.empty() && !is_kept) return "left behind: " + left;
  if (const auto next = write_felt(path, drawing_of(9)); !next) {
    return "the next save fails: " + next.error().message;
  }
  const std::string still_left = others_in(folder, known);
  if (!still_left.empty()) return "still there after the next save: " + still_left;
  std::string why;
  return generation_at(path, 9, why) == 9 ? "" : "the next save is not what lies there: " + why;
}

std::string check_save(const std::string& folder, const FaultState& after) {
  const std::string path = document_in(folder);
  std::string problem = check_generations(path, after);
  if (problem.empty()) problem = check_message(path, after);
  if (problem.empty()) problem = check_folder(folder, path, {"drawing.felt"}, after);
  return problem;
}

Scenario save_over() {
  return {"save_over", prepare_document,
          [](const std::string& folder) { save_generations(document_in(folder), 1, 2); },
          check_save};
}

/// Saves a file that does not exist before. A missing file counts as generation 0.
Scenario save_new() {
  return {"save_new", [](const std::string&) {},
          [](const std::string& folder) { save_generations(document_in(folder), 1, 1); },
          [](const std::string& folder, const FaultState& after) {
            const std::string path = document_in(folder);
            if (fs::exists(path)) return check_save(folder, after);
            if (after.acknowledged > 0) return "LOST: " + path + " was called saved";
            const std::string problem = check_message(path, after);
            return problem.empty() ? check_folder(folder, path, {"drawing.felt"}, after) : problem;
          }};
}

Scenario save_through_link() {
  return {"save_through_link",
          [](const std::string& folder) {
            fs::create_directory(folder + "/real");
            static_cast<void>(write_felt(folder + "/real/kept.felt", drawing_of(0)));
            ::chmod((folder + "/real/kept.felt").c_str(), 0640);
            fs::create_symlink("real/kept.felt", document_in(folder));
          },
          [](const std::string& folder) { save_generations(document_in(folder), 1, 1); },
          [](const std::string& folder, const FaultState& after) {
            const std::string path = document_in(folder);
            if (!fs::is_symlink(path)) return std::string("the link is gone");
            std::string problem = check_generations(path, after);
            if (problem.empty()) problem = check_message(path, after);
            if (problem.empty()) {
              problem = check_folder(folder + "/real", path, {"kept.felt"}, after);
            }
            // If the permissions cannot be restored, fewer users may have access, never more.
            const auto beyond = fs::status(path).permissions() & ~fs::perms(0640);
            if (problem.empty() && beyond != fs::perms::none) problem = "open to others";
            return problem.empty() ? others_in(folder, {"drawing.felt", "real"}) : problem;
          }};
}

/// Saves in a folder in which no file can be created. The document must be the old or the new one.
Scenario save_in_read_only_folder() {
  Scenario scenario{"save_in_read_only_folder", prepare_document,
                    [](const std::string& folder) { save_generations(document_in(folder), 1, 1); },
                    check_save};
  scenario.read_only = true;
  return scenario;
}

/// A bad saver that truncates the file before it writes. The driver must report damage.
Scenario truncating_saver() {
  Scenario scenario = save_over();
  scenario.name = "plant_truncate";
  scenario.is_plant = true;
  scenario.act = [](const std::string& folder) {
    const std::string bytes = felt_bytes(drawing_of(1)).value();
    state->started = 1;
    const int fd = ::open(document_in(folder).c_str(), O_WRONLY | O_TRUNC);
    bool ok = fd >= 0;
    for (std::size_t at = 0; ok && at < bytes.size(); at += 4096) {
      const std::size_t size = std::min<std::size_t>(4096, bytes.size() - at);
      ok = ::write(fd, bytes.data() + at, size) == static_cast<ssize_t>(size);
    }
    if (fd >= 0) ok = ::close(fd) == 0 && ok;
    if (ok) state->acknowledged = 1;
    if (!ok) state->say_error(document_in(folder) + ": cannot write");
  };
  return scenario;
}

/// A bad saver that reports "Saved" even if the save failed. The driver must report a loss.
Scenario careless_saver() {
  Scenario scenario = save_over();
  scenario.name = "plant_careless";
  scenario.is_plant = true;
  scenario.act = [](const std::string& folder) {
    state->started = 1;
    static_cast<void>(write_felt(document_in(folder), drawing_of(1)));
    state->acknowledged = 1;
  };
  return scenario;
}

}  // namespace

void add_save_scenarios(std::vector<Scenario>& to) {
  for (Scenario scenario : {save_over(), save_new(), save_through_link()}) {
    scenario.has_memory = true;
    to.push_back(scenario);
    scenario.name += "_no_unnamed";
    scenario.no_unnamed = true;
    scenario.has_memory = false;
    to.push_back(scenario);
  }
  to.push_back(save_in_read_only_folder());
  to.push_back(truncating_saver());
  to.push_back(careless_saver());
}

}  // namespace felt::faults
