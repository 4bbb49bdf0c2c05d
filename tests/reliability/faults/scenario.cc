#include "tests/reliability/faults/scenario.h"

#include <algorithm>
#include <filesystem>

namespace felt::faults {

namespace fs = std::filesystem;

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
  add_store_scenarios(all);
  if (!program.empty()) add_program_scenarios(all, program);
  return all;
}

}  // namespace felt::faults
