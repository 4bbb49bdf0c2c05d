#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace felt::cli {

/// Shows errors and notices on the terminal, and a progress line during long work. Everything is
/// written to stderr, because stdout carries data. Each message is one line, with control
/// characters escaped. A message that cannot be written is dropped (print.h). Use it only on the
/// main thread.
class Console {
 public:
  /// The progress line is shown if stderr is a terminal that can erase a line.
  Console();
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// Hides the progress line and all notices (--quiet). Errors are always shown.
  void set_quiet() noexcept {
    shows_progress_ = false;
    shows_notices_ = false;
  }
  /// Makes every notice an error (--strict).
  void set_strict() noexcept { strict_ = true; }

  /// Prints "feltline: message" and records a failure.
  void error(const std::string& message);
  /// Prints "feltline: message". Used if a part of a file is not supported and the rest is
  /// processed. This counts as a failure only with --strict.
  void notice(const std::string& message);
  /// Prints "feltline: message", unless --quiet: a result or advice, which is no failure.
  void summary(const std::string& message);
  /// Reports a record that could not be read from a file or written to the output. Prints
  /// "feltline: name:line: what", without the line if it is 0. If messages about the same file
  /// differ only in numbers and names, they are of one kind. The first kShownOfAKind messages of
  /// each kind are printed; end_records() prints the number of the others.
  void record_error(const std::string& name, std::int64_t line, const std::string& what);
  /// For each kind, prints how many messages were not printed: "name: ... and 65,997 more like it".
  void end_records();
  static constexpr std::int64_t kShownOfAKind = 3;
  /// Records a failure without a message, because stdout already describes it.
  void set_failed() noexcept { failed_ = true; }
  /// Returns true if a failure was recorded; the exit code of the program is then 1.
  [[nodiscard]] bool failed() const noexcept { return failed_; }

  /// Shows the progress of `what`: `done` of `total` bytes, and `strokes` strokes. Pass 0 for
  /// `total` if it is unknown. Draws at most ten times a second, and does not draw during the first
  /// half second.
  void progress(const char* what, std::int64_t done, std::int64_t total, std::int64_t strokes);
  /// Shows a status line, at most ten times a second. Each line replaces the one before.
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
