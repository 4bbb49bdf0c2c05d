#include "tests/faults/scenario.h"

#include <algorithm>
#include <deque>
#include <filesystem>

#include "felt/base/read_file.h"
#include "felt/document/random_document.h"

namespace felt::faults {

namespace fs = std::filesystem;

const StoredDrawing& drawing_of(std::uint32_t generation) {
  static std::deque<StoredDrawing> drawings;
  static felt::testing::RandomEdits edits(7);
  while (drawings.size() <= generation) {
    StoredDrawing next = drawings.empty() ? StoredDrawing{} : drawings.back();
    for (int i = 0; i < 4; ++i) static_cast<void>(next.document.apply(edits.next(next.document)));
    next.page.width_mm = 100.0 + static_cast<double>(drawings.size());
    next.material = "paper";
    drawings.push_back(std::move(next));
  }
  return drawings[generation];
}

int generation_at(const std::string& path, std::uint32_t most, std::string& why) {
  if (!fs::exists(path)) {
    why = path + " is gone";
    return -1;
  }
  const Result<StoredDrawing> drawing = read_felt(path);
  if (!drawing) {
    why = drawing.error().message;
    return -2;
  }
  for (std::uint32_t generation = 0; generation <= most; ++generation) {
    if (*drawing == drawing_of(generation)) return static_cast<int>(generation);
  }
  why = path + " holds a drawing that nobody saved";
  return -2;
}

std::string check_generations(const std::string& path, const FaultState& after) {
  std::string why;
  const int found = generation_at(path, after.started, why);
  if (found < 0) return "DAMAGED: " + why;
  if (found < static_cast<int>(after.acknowledged)) {
    return "LOST: generation " + std::to_string(found) + " where " +
           std::to_string(after.acknowledged) + " was called saved";
  }
  return "";
}

std::string others_in(const std::string& folder, const std::vector<std::string>& known) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::string name = entry.path().filename().string();
    if (std::find(known.begin(), known.end(), name) == known.end()) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

void say(const Error& error) {
  state->say_error(error.message);
}

std::vector<Scenario> all_scenarios(const std::string& program) {
  std::vector<Scenario> all;
  add_save_scenarios(all);
  if (!program.empty()) add_program_scenarios(all, program);
  return all;
}

}  // namespace felt::faults
