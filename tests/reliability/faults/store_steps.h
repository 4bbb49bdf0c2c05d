#pragma once

#include <cstdint>
#include <string>

#include "felt/autosave/autosave_database.h"
#include "felt/autosave/recovery.h"

namespace felt::faults {

/// A new store that holds generation `first`, committed.
Result<AutosaveDatabase> new_store(const std::string& root, std::uint32_t first);

/// Adds what leads to this generation and commits, with a piece of a line in work committed before,
/// as it is while a person draws.
Result<void> commit_generation(AutosaveDatabase& store, std::uint32_t generation);

/// The newest generation that the stores below `root`, left by dead processes, give back; 0 where
/// there is none; -1 with `why` where one gives none, or gives one with problems.
int generation_in_stores(const std::string& root, std::string& why);
/// Removes them, as when a person saved what was in them. What still lies below `root` then: "".
std::string remove_stores(const std::string& root);

}  // namespace felt::faults
