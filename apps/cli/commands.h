#pragma once

#include <CLI/CLI.hpp>

#include "console.h"
#include "felt/base/result.h"

/// The sub-commands. Each function adds one sub-command to the program, with its options and its
/// help. The sub-command runs if the command line names it, reports errors through `console`, and
/// throws UsageError if options contradict each other.
namespace felt::cli {

void add_fit_command(CLI::App& app, Console& console);
void add_render_command(CLI::App& app, Console& console);
void add_convert_command(CLI::App& app, Console& console);
void add_inbetween_command(CLI::App& app, Console& console);
void add_steady_command(CLI::App& app, Console& console);
void add_gather_command(CLI::App& app, Console& console);
void add_inflate_command(CLI::App& app, Console& console);  // only with FELT_SOLIDS
void add_check_command(CLI::App& app, Console& console);
void add_info_command(CLI::App& app, Console& console);
void add_formats_command(CLI::App& app);
void add_bench_command(CLI::App& app, Console& console);
void add_recover_command(CLI::App& app, Console& console);
void add_replay_command(CLI::App& app, Console& console);
void add_timelapse_command(CLI::App& app, Console& console);
void add_demo_command(CLI::App& app, Console& console);
void add_paper_command(CLI::App& app, Console& console);
void add_materials_command(CLI::App& app, Console& console);
void add_tools_command(CLI::App& app, Console& console);
void add_devices_command(CLI::App& app, Console& console);
void add_doctor_command(CLI::App& app, Console& console);
void add_device_test_command(CLI::App& app, Console& console);
void add_record_command(CLI::App& app, Console& console);
void add_trial_command(CLI::App& app, Console& console);
/// Adds `feltline trial export`.
void add_trial_export_command(CLI::App& trial, Console& console);
/// Adds `feltline trial preregister`.
void add_trial_preregister_command(CLI::App& trial, Console& console);

/// Thrown if the command line is invalid: the message is shown and the exit code is 2. A UsageError
/// made from an Error with kInvalidData, for example because an option names a damaged picture, has
/// the exit code 1; so have all errors that are not usage errors.
class UsageError : public CLI::Error {
 public:
  explicit UsageError(const std::string& message) : CLI::Error("UsageError", message, 2) {}
  explicit UsageError(const felt::Error& error)
      : CLI::Error("UsageError", error.message, error.code == ErrorCode::kInvalidData ? 1 : 2) {}
};

/// Accepts a number from `low` to `high`. Unlike CLI::Range it rejects NaN.
CLI::Validator number_between(double low, double high);

/// Adds --limit, the largest force of the pen, with the bounds that it has in the window.
void add_force_limit(CLI::App& command, double& limit_n);

/// Accepts any text that is not empty.
CLI::Validator not_empty();

/// Accepts a whole number from 0 to 2^64 - 1. This check is needed because CLI11 itself accepts -1
/// and numbers that are too large.
CLI::Validator whole_number();

/// Returns a footer with examples, one on each line, below a title.
std::string examples(const std::string& lines);

}  // namespace felt::cli
