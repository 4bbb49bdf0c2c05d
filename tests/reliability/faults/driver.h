#pragma once

#include <cstdint>
#include <string>

#include "tests/reliability/faults/scenario.h"

namespace felt::faults {

/// The fault of one run: which call fails, and how.
struct Fault {
  Mode mode = Mode::kNone;
  std::uint32_t at = 0;
  bool persistent = false;
  bool memory = false;
};

/// Result of one run. `problem` is empty if the run passed.
struct RunResult {
  std::string problem;
  std::uint32_t seen = 0, hits = 0;
  Outcome outcome = Outcome::kRunning;
  bool killed = false;
  std::string hit_name, message;
};

/// Sums over many runs.
struct Tally {
  std::uint64_t runs = 0, hits = 0, killed = 0, errors = 0, completed = 0, out_of_memory = 0,
                terminated = 0, problems = 0, damaged = 0;
  void add(const RunResult& run);
};

/// Runs each scenario in a separate process, in folders below `base`.
class Driver {
 public:
  /// `preload` is the path of the interposer library, for scenarios that run a command.
  Driver(std::string base, std::string preload);
  ~Driver();
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  /// Creates the folder from which each run of the scenario starts.
  void prepare(const Scenario& scenario);
  /// Runs the scenario once with `fault`. Requires prepare().
  RunResult run(const Scenario& scenario, const Fault& fault);
  /// Returns the folder in which the runs take place.
  [[nodiscard]] const std::string& folder() const noexcept { return folder_; }

 private:
  void reset_state(const Scenario& scenario, const Fault& fault);
  void play(const Scenario& scenario);
  void exec(const Scenario& scenario);

  std::string base_, template_, folder_, preload_, shared_path_;
  FaultState* state_ = nullptr;
  char* answer_ = nullptr;  ///< result of the checking process, in shared memory
};

}  // namespace felt::faults
