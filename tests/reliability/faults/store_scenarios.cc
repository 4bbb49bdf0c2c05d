// Tests the autosave database: creation, commits, a new base, checkpoints and recovery after a
// crash. Also tests that the autosave uses another folder if one fails.
#include <cstdlib>
#include <filesystem>

#include "felt/autosave/autosave.h"
#include "tests/reliability/faults/scenario.h"
#include "tests/reliability/faults/store_steps.h"

namespace felt::faults {
namespace {

namespace fs = std::filesystem;

std::string root_in(const std::string& folder) {
  return folder + "/state";
}

/// Commits the generations `first` to `last`. Stops at the first error, because its header forbids
/// the use of a database after an error.
void commit_generations(AutosaveDatabase& store, std::uint32_t first, std::uint32_t last) {
  for (std::uint32_t generation = first; generation <= last; ++generation) {
    state->started = generation;
    if (const auto done = commit_generation(store, generation); !done) return say(done.error());
    state->acknowledged = generation;
  }
}

/// Checks that the recovered drawing is intact and contains everything that was committed, and that
/// nothing remains once the autosaves are removed.
std::string check_stores(const std::string& root, const FaultState& after) {
  std::string why;
  const int found = generation_in_stores(root, why);
  if (found < 0) return "DAMAGED: " + why;
  if (found < static_cast<int>(after.acknowledged)) {
    return "LOST: generation " + std::to_string(found) + " where " +
           std::to_string(after.acknowledged) + " was committed";
  }
  if (found > static_cast<int>(after.started)) return "DAMAGED: more than was ever made";
  return remove_stores(root);
}

std::string check_store(const std::string& folder, const FaultState& after) {
  const std::string problem = check_stores(root_in(folder), after);
  if (!problem.empty() || after.outcome != Outcome::kError) return problem;
  const std::string message = after.message;
  const bool names_it = message.find(root_in(folder)) == 0 && message.size() > folder.size() + 20;
  return names_it ? "" : "an error without folder or reason: " + message;
}

/// Creates a database. Its first content is generation 1.
Scenario store_create() {
  return {"store_create", [](const std::string&) {},
          [](const std::string& folder) {
            state->started = 1;
            const auto store = new_store(root_in(folder), 1);
            if (!store) return say(store.error());
            state->acknowledged = 1;
          },
          check_store};
}

Scenario store_commit() {
  return {"store_commit", [](const std::string&) {},
          [](const std::string& folder) {
            state->armed = false;
            auto store = new_store(root_in(folder), 1);
            if (!store) std::abort();
            state->acknowledged = 1;
            state->armed = true;
            commit_generations(*store, 2, 4);
          },
          check_store};
}

/// Writes a new base while edits continue, then removes the records that the new base replaces.
Scenario store_renew() {
  return {"store_renew", [](const std::string&) {},
          [](const std::string& folder) {
            state->armed = false;
            auto store = new_store(root_in(folder), 1);
            if (!store) std::abort();
            commit_generations(*store, 2, 6);
            state->armed = true;
            auto begun = store->begin_base(std::make_shared<Drawing>(drawing_of(6)));
            if (!begun) return say(begun.error());
            for (bool done = false; !done;) {
              const auto part = store->write_base_part();
              if (!part) return say(part.error());
              done = *part;
            }
            commit_generations(*store, 7, 7);
            for (bool more = true; more && state->outcome != Outcome::kError;) {
              const auto tidied = store->tidy();
              if (!tidied) return say(tidied.error());
              more = *tidied;
              if (const auto done = store->commit(); !done) return say(done.error());
            }
            if (state->outcome != Outcome::kError) commit_generations(*store, 8, 8);
          },
          check_store};
}

/// Makes so many commits that SQLite moves their pages from the journal into the database.
Scenario store_checkpoint() {
  Scenario scenario = store_commit();
  scenario.name = "store_checkpoint";
  scenario.stride = 401;
  scenario.act = [](const std::string& folder) {
    state->armed = false;
    auto store = new_store(root_in(folder), 1);
    if (!store) std::abort();
    // A long line in progress fills the journal to just below the checkpoint limit. It is written
    // twice: when it is added, and when it is cleared, because SQLite overwrites freed pages.
    constexpr std::size_t kLineBytes = std::size_t{460} * 4096;
    if (!store->add_live(LiveKind::kSamples, std::string(kLineBytes, '\0')) || !store->commit() ||
        !store->clear_live() || !store->commit()) {
      std::abort();
    }
    state->armed = true;
    commit_generations(*store, 2, 9);
  };
  return scenario;
}

/// Recovers all autosaves after a crash, saves them, and only then removes them. The drawing that
/// is recovered and saved is generation 6.
Scenario store_recover() {
  return {"store_recover",
          [](const std::string& folder) {
            auto store = new_store(root_in(folder), 1);
            for (std::uint32_t generation = 2; store && generation <= 6; ++generation) {
              if (!commit_generation(*store, generation)) std::abort();
            }
            if (!store) std::abort();
          },
          [](const std::string& folder) {
            const std::string path = folder + "/recovered.felt";
            state->started = 6;
            for (AbandonedAutosave& store : find_abandoned_autosaves({root_in(folder)})) {
              const auto recovered = recover_autosave(store.folder);
              if (!recovered) return say(recovered.error());
              // If the recovery reports problems, the user keeps the autosave.
              if (!recovered->problems.empty()) return state->say_error(store.folder + ": told of");
              if (const auto saved = write_felt(path, recovered->drawing); !saved) {
                return say(saved.error());
              }
              if (const auto removed = std::move(store).remove(); !removed) {
                return say(removed.error());
              }
            }
          },
          [](const std::string& folder, const FaultState&) -> std::string {
            std::string why;
            const std::string path = folder + "/recovered.felt";
            int found = generation_in_stores(root_in(folder), why);
            if (found < 0) return "DAMAGED: " + why;
            if (fs::exists(path)) found = std::max(found, generation_at(path, 6, why));
            if (found < 6) return "LOST: generation " + std::to_string(found) + " of 6 " + why;
            return remove_stores(root_in(folder));
          }};
}

/// Runs the autosave with two folders. Only the first folder fails. The autosave must lose nothing
/// that it reported as committed, and must switch to the second folder.
Scenario autosave_elsewhere() {
  return {"autosave_elsewhere", [](const std::string&) {},
          [](const std::string& folder) {
            std::snprintf(state->folder, sizeof state->folder, "%s/first", folder.c_str());
            AutosaveOptions options;
            options.roots = {folder + "/first", folder + "/second"};
            options.live = false;
            Autosave autosave(std::move(options));
            state->started = 1;
            autosave.post({.drawing = std::make_unique<Drawing>(drawing_of(1)),
                           .name = "a drawing",
                           .path = "",
                           .modified = true});
            for (std::uint32_t generation = 1; generation <= 4; ++generation) {
              state->started = generation;
              for (const Edit& edit : edits_to(generation)) {
                if (generation > 1) autosave.post({.edit = edit});
              }
              autosave.post({.head = std::make_unique<Drawing>(drawing_of(generation))});
              autosave.flush();
              const AutosaveStatus status = autosave.status();
              if (status.state == AutosaveStatus::State::kFailing) {
                return state->say_error("failing, though the second place works: " + status.why);
              }
              state->acknowledged = generation;
            }
          },
          [](const std::string& folder, const FaultState& after) -> std::string {
            if (after.outcome == Outcome::kError) return after.message;
            std::string why_first, why;
            const int first = generation_in_stores(folder + "/first", why_first);
            const int second = generation_in_stores(folder + "/second", why);
            if (second < 0) return "DAMAGED: " + why;
            if (first < 0 && second < static_cast<int>(after.acknowledged)) {
              return "DAMAGED: " + why_first;
            }
            const int found = std::max(first, second);
            if (found < static_cast<int>(after.acknowledged)) {
              return "LOST: generation " + std::to_string(found) + " where " +
                     std::to_string(after.acknowledged) + " was kept";
            }
            return "";
          }};
}

}  // namespace

void add_store_scenarios(std::vector<Scenario>& to) {
  for (Scenario scenario :
       {store_create(), store_commit(), store_renew(), store_recover(), autosave_elsewhere()}) {
    scenario.has_memory = true;
    scenario.stride = 13;
    to.push_back(scenario);
  }
  to.push_back(store_checkpoint());
}

}  // namespace felt::faults
