#pragma once

#include <string>
#include <vector>

#include "felt/replay/replay_machine.h"
#include "felt/replay/script_feed.h"

namespace felt {

/// Feeds scripts to a machine.
class ScriptRun {
 public:
  /// Requires that the machine outlives this.
  ScriptRun(ReplayMachine& machine, double mm_per_unit, std::uint64_t seed);

  /// Announces files to be read, so that progress() includes their size.
  void expect(const std::vector<std::string>& paths);
  /// Returns the progress through all scripts, 0..1, if the current play is at `part`, 0..1.
  [[nodiscard]] double progress(double part) const noexcept;

  /// Reads a script. `name` is for errors. Paths of imports are relative to `folder`, which ends
  /// with a slash; "" is the working directory. The error is "NAME:LINE: reason".
  Result<void> script(const std::string& name, const std::string& folder, ReadBytes read);
  /// Returns the faults of the samples of raw strokes in the last script (ScriptFeed::report()).
  [[nodiscard]] const ImportReport& report() const noexcept { return feed_.report(); }
  /// Plays everything read so far. More scripts may follow.
  Result<void> play();

 private:
  FeedSink sink();

  ReplayMachine& machine_;
  ScriptFeed feed_;
  std::string name_;  // name of the last script
  std::string folder_;
  double expected_bytes_ = 0.0;  // size of all files
  double read_bytes_ = 0.0;      // bytes read so far
  double played_bytes_ = 0.0;    // bytes played before the current play
};

}  // namespace felt
