#pragma once

#include <cstdint>
#include <string>

#include "tests/reliability/faults/scenario.h"

namespace felt::faults {

/// What is disturbed, and how.
struct Fault {
  Mode mode = Mode::kNone;
  std::uint32_t at = 0;
  bool persistent = false;
  bool memory = false;
};

/// How one run ended. `problem` is empty where all is well.
struct RunResult {
  std::string problem;
  std::uint32_t seen = 0, hits = 0;
  Outcome outcome = Outcome::kRunning;
  bool killed = false;
  std::string hit_name, message;
};

/// Counts over many runs.
struct Tally {
  std::uint64_t runs = 0, hits = 0, killed = 0, errors = 0, completed = 0, out_of_memory = 0,
                terminated = 0, problems = 0, damaged = 0;
  void add(const RunResult& run);
};

/// Runs scenarios in processes of their own, in folders of its own below `base`.
class Driver {
 public:
  /// `preload`: the interposer as a library, for scenarios with a command.
  Driver(std::string base, std::string preload);
  ~Driver();
  Driver(const Driver&) = delete;
  Driver& operator=(const Driver&) = delete;

  /// Makes the folder that each run of the scenario starts from.
  void prepare(const Scenario& scenario);
  /// One run, from prepared.
  RunResult run(const Scenario& scenario, const Fault& fault);
  /// Where the runs are.
  [[nodiscard]] const std::string& folder() const noexcept { return folder_; }

 private:
  void reset_state(const Scenario& scenario, const Fault& fault);
  void play(const Scenario& scenario);
  void exec(const Scenario& scenario);

  std::string base_, template_, folder_, preload_, shared_path_;
  FaultState* state_ = nullptr;
  char* answer_ = nullptr;  ///< of the checking process
};

}  // namespace felt::faults
