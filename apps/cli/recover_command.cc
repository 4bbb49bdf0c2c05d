#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "commands.h"
#include "felt/autosave/folder_lock.h"
#include "felt/autosave/recovery.h"
#include "felt/base/printable.h"
#include "felt/replay/record_copy.h"
#include "print.h"

namespace felt::cli {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxNames = 1000;

struct RecoverArguments {
  bool list = false;
  std::string folder;
  std::vector<std::string> from;
};

std::string time_text(std::int64_t seconds) {
  const std::time_t when = seconds;
  std::tm local{};
  if (!::localtime_r(&when, &local)) return "?";
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02}", local.tm_year + 1900, local.tm_mon + 1,
                     local.tm_mday, local.tm_hour, local.tm_min, local.tm_sec);
}

/// Returns the file name without its extension: "harbour" for "harbour.felt". The result never
/// contains a path to another folder.
std::string stem_of(const Recovered& recovered) {
  std::string stem = fs::path(recovered.name).filename().string();
  if (stem.size() > 5 && stem.ends_with(".felt")) stem.resize(stem.size() - 5);
  return stem.empty() || stem == "." || stem == ".." ? "Untitled" : stem;
}

std::string described(const Recovered& recovered) {
  const std::size_t count = recovered.drawing.document.stroke_count();
  return fmt::format(
      "{}: {}, {} line{}{}, {}", recovered.name.empty() ? "Untitled" : printable(recovered.name),
      time_text(recovered.changed_at_s), count, count == 1 ? "" : "s",
      recovered.has_changes ? "" : ", all of it saved",
      recovered.path.empty() ? "never saved" : "saved as " + printable(recovered.path));
}

/// Writes the drawing under an unused name and returns that name.
Result<std::string> write_new(const std::string& folder, const Recovered& recovered) {
  const std::string stem = folder + '/' + stem_of(recovered) + " (recovered";
  for (int number = 1; number <= kMaxNames; ++number) {
    const std::string path = stem + (number == 1 ? ").felt" : fmt::format(" {}).felt", number));
    if (::access(path.c_str(), F_OK) == 0) continue;
    return write_felt(path, recovered.drawing).map([&path] { return path; });
  }
  return fail(ErrorCode::kIo, stem + ").felt: too many files have this name");
}

/// Lists the copies that `feltline record` left behind. `convert` can read them. Returns their
/// number.
int list_record_copies(const RecoverArguments& args) {
  std::error_code none;
  const std::vector<std::string> copies = find_record_copies(
      args.from.empty() ? std::vector<std::string>{".", fs::temp_directory_path(none).string()}
                        : args.from);
  for (const std::string& copy : copies) {
    struct stat info {};
    if (::stat(copy.c_str(), &info) != 0) continue;
    print("{}: {}, copy of a recording\n  feltline convert '{}' -o recovered.felt\n",
          printable(copy), time_text(info.st_mtime), printable(copy));
  }
  return static_cast<int>(copies.size());
}

/// Reports folders that do not exist, because their names are probably mistyped. Returns false if
/// an error was reported.
bool check_folders(const RecoverArguments& args, Console& console) {
  for (const std::string& folder : args.from) {
    std::error_code error;
    const fs::file_status status = fs::status(folder, error);
    if (fs::is_directory(status)) continue;
    console.error("--from " + folder + ": " +
                  (fs::exists(status) ? "not a folder" : "the folder does not exist"));
  }
  return !console.failed();
}

void recover(const RecoverArguments& args, Console& console) {
  if (!check_folders(args, console)) return;
  const std::vector<AbandonedAutosave> stores =
      find_abandoned_autosaves(args.from.empty() ? autosave_roots() : args.from);
  if (!args.list) {
    std::error_code error;
    fs::create_directories(args.folder, error);
    if (error) return console.error(args.folder + ": cannot create: " + error.message());
  }
  int found = 0;
  for (const AbandonedAutosave& store : stores) {
    const Result<Recovered> recovered = recover_autosave(store.folder);
    if (!recovered) {
      console.error(recovered.error().message);
      continue;
    }
    for (const std::string& problem : recovered->problems) {
      console.notice(store.folder + ": " + problem);
    }
    const Document& document = recovered->drawing.document;
    if (!recovered->has_changes && document.stroke_count() + document.fill_count() == 0) continue;
    ++found;
    print("{}\n", described(*recovered));
    if (args.list) continue;
    const Result<std::string> path = write_new(args.folder, *recovered);
    if (!path) {
      console.error(path.error().message);
    } else {
      print("  -> {}\n", printable(*path));
    }
  }
  const int copies = list_record_copies(args);
  if (found == 0 && copies > 0) return;
  if (found == 0) {
    print("Nothing to recover: no unsaved drawing was found.\n");
  } else if (args.list) {
    print("To recover them: feltline recover -o FOLDER\n");
  }
}

}  // namespace

void add_recover_command(CLI::App& app, Console& console) {
  CLI::App* command =
      app.add_subcommand("recover", "Recover drawings after a crash, a kill or a power cut");
  const auto args = std::make_shared<RecoverArguments>();
  command->add_flag("--list", args->list, "List the drawings and write nothing");
  command->add_option("-o,--output", args->folder,
                      "Write each into this folder, as 'NAME (recovered).felt'");
  command->add_option("--from", args->from,
                      "Search these folders instead of the autosave folder of feltline-desktop");
  command->footer(
      examples("feltline recover --list\n"
               "feltline recover -o rescued\n"
               "feltline recover --from /media/old/home/me/.local/state/feltline/working -o .") +
      "\n\nA crash of 'feltline record' leaves OUTPUT.unsaved-NUMBER.ndjson beside its output. "
      "Such files\n"
      "in the current folder, in the folder for temporary files and in --from are listed.\n"
      "Nothing is deleted and no file is overwritten: feltline-desktop keeps offering unsaved "
      "drawings\n"
      "until they are saved there or discarded.");
  command->callback([args, &console] {
    if (!args->list && args->folder.empty()) args->list = true;
    recover(*args, console);
  });
}

}  // namespace felt::cli
