#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace felt::cli {

/// Reports to the user at the terminal: errors, notices, and a progress line during work.
/// Everything goes to stderr, because stdout carries data. Each message is one line, with control
/// characters escaped. A message that cannot be written is dropped (print.h). Thread: main only.
class Console {
 public:
  /// The progress line is shown if stderr is a terminal that can erase a line.
  Console();
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// --quiet: no progress line, no notices. Errors are always shown.
  void set_quiet() noexcept {
    shows_progress_ = false;
    shows_notices_ = false;
  }
  /// --strict: a notice is an error.
  void set_strict() noexcept { strict_ = true; }

  /// Prints "feltline: message" and records a failure.
  void error(const std::string& message);
  /// Prints "feltline: message": a part of a file is not supported, and the rest is processed. This
  /// is not a failure unless --strict.
  void notice(const std::string& message);
  /// Reports a record of a file that could not be read, or not be written to the output: prints
  /// "feltline: name:line: what" (without the line if it is 0). Of the messages that differ only in
  /// numbers and names, the first kShownOfAKind of each file are printed; end_records() counts the
  /// rest.
  void record_error(const std::string& name, std::int64_t line, const std::string& what);
  /// Prints the number of messages of each kind that were not printed: "name: ... and 65,997 more
  /// like it".
  void end_records();
  static constexpr std::int64_t kShownOfAKind = 3;
  /// Records a failure that stdout describes.
  void set_failed() noexcept { failed_ = true; }
  /// Returns true if an error was reported; the exit code is then 1.
  [[nodiscard]] bool failed() const noexcept { return failed_; }

  /// Shows the progress of `what`: `done` of `total` bytes (0: unknown) and `strokes` strokes.
  /// Draws at most ten times a second, and nothing during the first half second.
  void progress(const char* what, std::int64_t done, std::int64_t total, std::int64_t strokes);
  /// Shows a status line that the next one replaces, at most ten times a second.
  void status(const std::string& line);
  /// Removes the progress line.
  void end_progress();

 private:
  using Clock = std::chrono::steady_clock;
  struct Repeated {
    std::string name, kind;
    std::int64_t first_line = 0, count = 0;
  };
  Repeated& repeated(const std::string& name, std::int64_t line, const std::string& what);

  std::vector<Repeated> repeated_;
  bool shows_progress_;
  bool shows_notices_ = true;
  bool strict_ = false;
  bool failed_ = false;
  bool drawn_ = false;
  Clock::time_point next_draw_;
};

}  // namespace felt::cli
