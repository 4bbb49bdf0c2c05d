#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "felt/store/felt_file.h"
#include "tests/reliability/faults/drawings.h"
#include "tests/reliability/faults/fault_state.h"

namespace felt::faults {

/// One use of a document, repeated with a fault at each of its system calls.
///
/// Each function runs in a separate process. `act` runs under the interposer and reports to `state`
/// what a user would see: it sets `started` before it saves a generation, and `acknowledged` when
/// it would show "Saved", or it reports the error.
struct Scenario {
  std::string name;
  /// Creates the initial content of the folder. Runs without faults.
  std::function<void(const std::string& folder)> prepare;
  std::function<void(const std::string& folder)> act;
  /// Checks the folder after `act`. Returns "" if all is well, otherwise the problem.
  std::function<std::string(const std::string& folder, const FaultState& after)> check;

  bool no_unnamed = false;  ///< FaultState::no_unnamed
  bool read_only = false;
  /// Command to run instead of `act`, with the interposer preloaded. "@" stands for the folder.
  std::vector<std::string> command = {};
  /// True for a deliberately bad saver, which proves that the driver finds damage. Not part of the
  /// suite.
  bool is_plant = false;
  /// Only every `stride`-th call fails, because all calls would take too long. The user can
  /// override this.
  std::uint32_t stride = 1;
  /// True if the scenario also runs with failing allocations.
  bool has_memory = false;
};

/// Checks a document that was saved generation after generation. It must be intact, not older than
/// `acknowledged` and not newer than `started`. Returns "" or the problem.
std::string check_generations(const std::string& path, const FaultState& after);

/// Returns the names of the files in `folder` that are not in `known`, sorted and separated by
/// spaces.
std::string others_in(const std::string& folder, const std::vector<std::string>& known);

/// Stores an error of the library in `state`.
void say(const Error& error);

/// Returns all scenarios. `program` is the path of the program feltline. If it is empty, the
/// scenarios that run the program are left out.
std::vector<Scenario> all_scenarios(const std::string& program);
void add_save_scenarios(std::vector<Scenario>& to);
void add_store_scenarios(std::vector<Scenario>& to);
void add_program_scenarios(std::vector<Scenario>& to, const std::string& program);

}  // namespace felt::faults
