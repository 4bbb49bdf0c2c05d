#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace felt::cli {

/// What the program says to the person at the terminal: errors, notices, and a progress line while
/// work goes on. All of it on stderr, since stdout carries data. Main thread only.
class Console {
 public:
  /// The progress line is shown when stderr is a terminal that can erase a line.
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

  /// Prints "feltline: message" and remembers that something failed.
  void error(const std::string& message);
  /// Prints "feltline: message": something of a file could not be taken as it was, and the rest
  /// goes on. No failure unless --strict.
  void notice(const std::string& message);
  /// Something failed, and stdout says what.
  void set_failed() noexcept { failed_ = true; }
  /// True once an error was reported: the exit code is then 1.
  [[nodiscard]] bool failed() const noexcept { return failed_; }

  /// Shows how far `what` is: `done` of `total` bytes (0: unknown) and `strokes` strokes. Draws at
  /// most ten times a second, and nothing during the first half second.
  void progress(const char* what, std::int64_t done, std::int64_t total, std::int64_t strokes);
  /// Shows how things are, in a line that the next one replaces; at most ten times a second.
  void status(const std::string& line);
  /// Removes the progress line.
  void end_progress();

 private:
  using Clock = std::chrono::steady_clock;

  bool shows_progress_;
  bool shows_notices_ = true;
  bool strict_ = false;
  bool failed_ = false;
  bool drawn_ = false;
  Clock::time_point next_draw_;
};

}  // namespace felt::cli
