#include "tests/reliability/faults/store_steps.h"

#include <algorithm>
#include <filesystem>

#include "tests/reliability/faults/drawings.h"

namespace felt::faults {

namespace fs = std::filesystem;

namespace {

AutosaveInfo about_of(std::uint32_t generation) {
  AutosaveInfo about{"a drawing", "", true, drawing_of(generation)};
  about.head.document = Document();
  return about;
}

/// Returns true if the process died before the first commit. The user was never told that this
/// autosave holds a drawing, so it may be empty.
bool is_begun(const Recovered& recovered) {
  return recovered.problems.size() == 1 && recovered.drawing == Drawing{} &&
         recovered.problems.front().find("not been copied completely") != std::string::npos;
}

}  // namespace

Result<AutosaveDatabase> new_store(const std::string& root, std::uint32_t first) {
  Result<AutosaveDatabase> store = AutosaveDatabase::create(root, "store");
  if (!store) return store;
  Result<void> done = store->write_base(drawing_of(first));
  if (done) done = store->put_info(about_of(first));
  if (done) done = store->commit();
  if (!done) return tl::unexpected(done.error());
  return store;
}

Result<void> commit_generation(AutosaveDatabase& store, std::uint32_t generation) {
  // The beginning of a line, with no script and an empty selection.
  Result<void> done = store.add_live(LiveKind::kContext, std::string(8, '\0'));
  if (done) done = store.commit();
  for (const Edit& edit : edits_to(generation)) {
    if (done) done = store.add_edit(edit).map([](std::uint64_t) {});
  }
  if (done) done = store.clear_live();
  if (done) done = store.put_info(about_of(generation));
  return done ? store.commit() : done;
}

int generation_in_stores(const std::string& root, std::string& why) {
  int newest = 0;
  for (const AbandonedAutosave& store : find_abandoned_autosaves({root})) {
    const Result<Recovered> recovered = recover_autosave(store.folder);
    if (!recovered) {
      why = recovered.error().message;
      return -1;
    }
    if (is_begun(*recovered)) continue;
    if (!recovered->problems.empty()) {
      why = store.folder + ": " + recovered->problems.front();
      return -1;
    }
    const int found = generation_of(recovered->drawing);
    if (found < 0) {
      why = store.folder + ": holds a drawing that nobody made";
      return -1;
    }
    newest = std::max(newest, found);
  }
  return newest;
}

std::string remove_stores(const std::string& root) {
  for (AbandonedAutosave& store : find_abandoned_autosaves({root})) {
    if (const auto removed = std::move(store).remove(); !removed) return removed.error().message;
  }
  if (!fs::exists(root)) return "";
  std::string left;
  for (const fs::directory_entry& entry : fs::directory_iterator(root)) {
    left += " " + entry.path().filename().string();
  }
  return left.empty() ? "" : "still there:" + left;
}

}  // namespace felt::faults
