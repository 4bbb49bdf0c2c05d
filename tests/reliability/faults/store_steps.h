#pragma once

#include <cstdint>
#include <string>

#include "felt/autosave/autosave_database.h"
#include "felt/autosave/recovery.h"

namespace felt::faults {

/// Creates an autosave database below `root` with generation `first`, committed.
Result<AutosaveDatabase> new_store(const std::string& root, std::uint32_t first);

/// Adds the edits of `generation` and commits them. Before that, commits the beginning of a line in
/// progress, as happens while a user draws.
Result<void> commit_generation(AutosaveDatabase& store, std::uint32_t generation);

/// Recovers all autosaves that dead processes left below `root` and returns the newest generation
/// found, or 0 if no autosave exists. Returns -1 and sets `why` if one of them cannot be recovered
/// without problems.
int generation_in_stores(const std::string& root, std::string& why);
/// Removes these autosaves, as the program does after the user saved the recovered drawing. Returns
/// an empty string if nothing is left below `root`, otherwise the problem.
std::string remove_stores(const std::string& root);

}  // namespace felt::faults
