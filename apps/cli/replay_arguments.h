#pragma once

#include <optional>
#include <string>

#include "felt/replay/replay_machine.h"

namespace CLI {
class App;
}

namespace felt::cli {

/// The settings of a replay as command line options.
struct ReplayArguments {
  std::string device = "touch";
  std::string hand = "typical";
  std::optional<double> rate_hz;
  std::optional<int> delay_ticks;
  bool no_force = false;
  double limit_n = 3.0;

  /// Adds --device and --hand.
  void add_pen_to(CLI::App& command);
  /// Adds --rate, --delay, --limit and --no-force.
  void add_loop_to(CLI::App& command);
  /// Requires that the command line was parsed, so that all names are valid.
  [[nodiscard]] ReplaySettings settings() const;
};

}  // namespace felt::cli
