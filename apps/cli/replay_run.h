#pragma once

#include <string>
#include <vector>

#include "replay_machine.h"
#include "script_feed.h"

namespace felt::cli {

/// Scripts into a machine: what `replay`, `demo` and the benchmark have in common.
class ReplayRun {
 public:
  /// The machine must outlive this.
  ReplayRun(ReplayMachine& machine, double mm_per_unit, std::uint64_t seed);

  /// These files will come: for progress.
  void expect(const std::vector<std::string>& paths);
  /// How far everything is, 0..1, when what is being played is at `part`, 0..1.
  [[nodiscard]] double progress(double part) const noexcept;

  /// Takes a script: its name for errors, the folder from which it imports ("" is the present one).
  /// The error names the place.
  Result<void> script(const std::string& name, const std::string& folder, ReadBytes read);
  /// Takes the script of a command line: a file, or "-".
  Result<void> file(const std::string& path);
  /// Plays what was taken so far; more may follow.
  Result<void> play();

 private:
  FeedSink sink();

  ReplayMachine& machine_;
  ScriptFeed feed_;
  std::string name_;  // of the script that was read last
  std::string folder_;
  double expected_bytes_ = 0.0;  // of all files
  double taken_bytes_ = 0.0;     // so far
  double played_bytes_ = 0.0;    // before the present play
};

}  // namespace felt::cli
