#pragma once

#include <CLI/CLI.hpp>

#include "console.h"
#include "felt/base/result.h"

/// The sub-commands. Each function adds one to the program, with its options and its help; it runs
/// when the command line names it, says what goes wrong through `console`, and throws UsageError
/// for options that make no sense together.
namespace felt::cli {

void add_fit_command(CLI::App& app, Console& console);
void add_render_command(CLI::App& app, Console& console);
void add_convert_command(CLI::App& app, Console& console);
void add_info_command(CLI::App& app, Console& console);
void add_formats_command(CLI::App& app);
void add_bench_command(CLI::App& app, Console& console);
void add_recover_command(CLI::App& app, Console& console);
void add_replay_command(CLI::App& app, Console& console);
void add_demo_command(CLI::App& app, Console& console);
void add_materials_command(CLI::App& app, Console& console);
void add_tools_command(CLI::App& app, Console& console);
void add_devices_command(CLI::App& app, Console& console);
void add_doctor_command(CLI::App& app, Console& console);
void add_device_test_command(CLI::App& app, Console& console);
void add_record_command(CLI::App& app, Console& console);

/// A command line that makes no sense: the message is shown and the exit code is 2. Of a file that
/// is named there and damaged the exit code is 1.
class UsageError : public CLI::Error {
 public:
  explicit UsageError(const std::string& message) : CLI::Error("UsageError", message, 2) {}
  explicit UsageError(const felt::Error& error)
      : CLI::Error("UsageError", error.message, error.code == ErrorCode::kInvalidData ? 1 : 2) {}
};

/// Accepts a number from `low` to `high`; unlike CLI::Range not NaN, which is in no range.
CLI::Validator number_between(double low, double high);

/// Accepts any text but "".
CLI::Validator not_empty();

/// Accepts a whole number from 0 to 2^64 - 1; CLI11 itself takes -1 and what is too large.
CLI::Validator whole_number();

/// A footer with examples, one a line, below a title.
std::string examples(const std::string& lines);

}  // namespace felt::cli
