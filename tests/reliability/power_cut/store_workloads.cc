// Workloads of the autosave database: first creation, commits, new bases, checkpoints, recovery
// after a crash, and commits while the user's file is saved.
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "felt/autosave/autosave.h"
#include "tests/reliability/faults/drawings.h"
#include "tests/reliability/faults/store_steps.h"
#include "tests/reliability/power_cut/workload.h"

namespace felt::power_cut {
namespace {

namespace fs = std::filesystem;
using faults::commit_generation;
using faults::drawing_of;

constexpr unsigned kPauseUs = 20'000;  // pause between commits, as in the autosave

std::string root_in(const std::string& folder) {
  return folder + "/state";
}
std::string document_in(const std::string& folder) {
  return folder + "/drawing.felt";
}

int find_in_stores(const std::string& folder, std::uint32_t largest, std::string& why) {
  const int found = faults::generation_in_stores(root_in(folder), why);
  if (found <= static_cast<int>(largest)) return found;
  why = "more than was ever made";
  return -1;
}

/// Creates an autosave database with generation `from` and then removes the autosaves that a power
/// cut left, as the program does at its start. The new one is complete before the old ones go.
Result<AutosaveDatabase> take_up(const std::string& folder, std::uint32_t from) {
  std::vector<AbandonedAutosave> left = find_abandoned_autosaves({root_in(folder)});
  Result<AutosaveDatabase> store = faults::new_store(root_in(folder), from);
  if (!store) return store;
  for (AbandonedAutosave& old : left) {
    if (const auto gone = std::move(old).remove(); !gone) return tl::unexpected(gone.error());
  }
  return store;
}

using Between = std::function<Result<void>(AutosaveDatabase& store, std::uint32_t generation)>;

Workload commit_loop(std::string name, std::uint32_t commits, unsigned pause_us, Between between) {
  return {std::move(name),
          [=](const std::string& folder, std::uint32_t from, Diary& diary) {
            const std::uint32_t first = std::max<std::uint32_t>(from, 1);
            diary.start(first);
            Result<AutosaveDatabase> store = take_up(folder, first);
            if (!store) return diary.fail(store.error().message);
            diary.acknowledge(first);
            for (std::uint32_t i = first + 1; i < first + commits; ++i) {
              diary.start(i);
              Result<void> done = commit_generation(*store, i);
              if (!done) return diary.fail(done.error().message);
              diary.acknowledge(i);
              if (done = between(*store, i); !done) return diary.fail(done.error().message);
              if (pause_us > 0) ::usleep(pause_us);
            }
          },
          find_in_stores};
}

Result<void> nothing(AutosaveDatabase&, std::uint32_t) {
  return {};
}

/// Starts a new base at every fifth generation. The commits after it remove the obsolete records.
Result<void> renew(AutosaveDatabase& store, std::uint32_t generation) {
  Result<void> done;
  if (generation % 5 == 0) {
    done = store.begin_base(std::make_shared<Drawing>(drawing_of(generation)));
    for (bool more = true; done && more;) {
      done = store.write_base_part().map([&more](bool is_last) { more = !is_last; });
    }
  } else {
    done = store.tidy().map([](bool) {});
  }
  return done ? store.commit() : done;
}

/// Recovers and saves the same drawing eight times, as if the program crashed each time before it
/// removed the autosave. Removes the autosave in the last round.
Workload recover() {
  return {"recover",
          [](const std::string& folder, std::uint32_t from, Diary& diary) {
            const std::uint32_t last = from + 5;
            diary.start(last);
            {
              Result<AutosaveDatabase> store = take_up(folder, from + 1);
              if (!store) return diary.fail(store.error().message);
              for (std::uint32_t i = from + 2; i <= last; ++i) {
                if (const auto done = commit_generation(*store, i); !done) {
                  return diary.fail(done.error().message);
                }
              }
            }
            diary.acknowledge(last);
            for (int round = 0; round < 8; ++round) {
              for (AbandonedAutosave& store : find_abandoned_autosaves({root_in(folder)})) {
                const auto recovered = recover_autosave(store.folder);
                if (!recovered) return diary.fail(recovered.error().message);
                if (faults::generation_of(recovered->drawing) != static_cast<int>(last)) {
                  return diary.fail("recovered another drawing");
                }
                const auto saved = write_felt(document_in(folder), recovered->drawing);
                if (!saved) return diary.fail(saved.error().message);
                if (round == 7) static_cast<void>(std::move(store).remove());
              }
              ::usleep(kPauseUs);
            }
          },
          [](const std::string& folder, std::uint32_t largest, std::string& why) {
            const int in_stores = find_in_stores(folder, largest, why);
            if (in_stores < 0 || !fs::exists(document_in(folder))) return in_stores;
            const int saved = faults::generation_at(document_in(folder), largest, why);
            return saved < 0 ? -1 : std::max(in_stores, saved);
          }};
}

/// Commits, and saves the file at every sixth commit. The file must never be older than the last
/// save.
Workload save_while_committing() {
  Workload workload = commit_loop("save_and_commit", 40, kPauseUs, nothing);
  workload.run = [](const std::string& folder, std::uint32_t from, Diary& diary) {
    const Between save = [&](AutosaveDatabase&, std::uint32_t generation) -> Result<void> {
      if (generation % 6 != 0) return {};
      const std::string mark = folder + "/saved";
      auto saved = write_felt(document_in(folder), drawing_of(generation));
      // Record the saved generation in a second file on the same disk after the save succeeded.
      if (saved) saved = write_felt(mark, drawing_of(generation));
      return saved;
    };
    commit_loop("", 40, kPauseUs, save).run(folder, from, diary);
  };
  workload.find = [](const std::string& folder, std::uint32_t largest, std::string& why) {
    if (fs::exists(folder + "/saved")) {
      const int marked = faults::generation_at(folder + "/saved", largest, why);
      const int saved = faults::generation_at(document_in(folder), largest, why);
      if (marked < 0 || saved < marked) {
        why = "saved " + std::to_string(marked) + ", found " + std::to_string(saved) + " " + why;
        return -1;
      }
    }
    return find_in_stores(folder, largest, why);
  };
  return workload;
}

/// Runs the complete autosave with its thread, as the desktop program does.
Workload autosave() {
  return {"autosave",
          [](const std::string& folder, std::uint32_t from, Diary& diary) {
            const std::uint32_t first = std::max<std::uint32_t>(from, 1);
            std::vector<AbandonedAutosave> left = find_abandoned_autosaves({root_in(folder)});
            AutosaveOptions options;
            options.roots = {root_in(folder)};
            options.max_log_bytes = 20'000;  // so that new bases are written
            // Long, so that only flush() commits. flush() does not wait for this time.
            options.gather = std::chrono::seconds(5);
            // Never deleted, because a power cut does not end the autosave properly either.
            auto* autosave = new Autosave(std::move(options));
            diary.start(first);
            autosave->post({.drawing = std::make_unique<Drawing>(drawing_of(first)),
                            .name = "a drawing",
                            .path = "",
                            .modified = true});
            for (std::uint32_t i = first; i < first + 40; ++i) {
              diary.start(i);
              for (const Edit& edit : faults::edits_to(i)) {
                if (i > first) autosave->post({.edit = edit});
              }
              autosave->post({.head = std::make_unique<Drawing>(drawing_of(i))});
              autosave->flush();
              const AutosaveStatus status = autosave->status();
              if (status.state != AutosaveStatus::State::kWorking) return diary.fail(status.why);
              diary.acknowledge(i);
              for (AbandonedAutosave& old : left) static_cast<void>(std::move(old).remove());
              left.clear();
            }
          },
          find_in_stores};
}

}  // namespace

void add_store_workloads(std::vector<Workload>& to) {
  to.push_back(commit_loop("commit", 60, kPauseUs, nothing));
  to.push_back(commit_loop("create", 2, 0, nothing));
  to.push_back(commit_loop("renew", 60, kPauseUs / 4, renew));
  to.push_back(commit_loop("checkpoint", 150, 0, nothing));
  to.push_back(recover());
  to.push_back(save_while_committing());
  to.push_back(autosave());
}

}  // namespace felt::power_cut
