#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "felt/store/felt_file.h"
#include "tests/reliability/faults/drawings.h"
#include "tests/reliability/faults/fault_state.h"

namespace felt::faults {

/// Something a person does with a document, to be disturbed at every call it makes.
///
/// Each function runs in a process of its own that knows nothing of the others. `act` runs under
/// the interposer and says in `state` what it told the person: `started` before it saves
/// generation n, `acknowledged` when it would show "Saved", or the error.
struct Scenario {
  std::string name;
  /// Makes the folder as it is before, undisturbed.
  std::function<void(const std::string& folder)> prepare;
  std::function<void(const std::string& folder)> act;
  /// Looks at the folder afterwards: "" where all is well, else what is wrong.
  std::function<std::string(const std::string& folder, const FaultState& after)> check;

  bool no_unnamed = false;  ///< FaultState::no_unnamed
  bool read_only = false;
  /// A program to run instead of `act`, interposer preloaded; "@" stands for the folder.
  std::vector<std::string> command = {};
  /// Shows that the driver can find damage; not part of the suite.
  bool is_plant = false;
  /// Every so many calls only, unless all are asked for: the rest takes long.
  std::uint32_t stride = 1;
  /// Allocations can be made to fail in it.
  bool has_memory = false;
};

/// What must hold of a document that was saved generation after generation: it is whole, not older
/// than the last that was called saved, not newer than the last that was begun.
std::string check_generations(const std::string& path, const FaultState& after);

/// The names of the files in `folder` that are none of `known`; sorted, with spaces between.
std::string others_in(const std::string& folder, const std::vector<std::string>& known);

/// Notes an error of the library in `state`.
void say(const Error& error);

/// All of them. `program` is the feltline to run, or "": no scenarios of the program then.
std::vector<Scenario> all_scenarios(const std::string& program);
void add_save_scenarios(std::vector<Scenario>& to);
void add_store_scenarios(std::vector<Scenario>& to);
void add_program_scenarios(std::vector<Scenario>& to, const std::string& program);

}  // namespace felt::faults
