#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace felt::bench {

/// Times calls of some 100 ns. It reads the processor's counter (about 20 ns, subtracted), because
/// the thread CPU clock is a system call that costs more than a query. If the scheduler preempted
/// the thread during a call, the call counts as preempted and the percentiles ignore it. Time lost
/// to interrupts or to the host of a virtual machine cannot be detected and is included. On
/// processors other than x86 it reads the monotonic clock.
class Stopwatch {
 public:
  Stopwatch();
  void start() noexcept;
  /// Returns the ns since `start` without the cost of reading the clock. Returns a negative number
  /// if the thread was preempted since `start`.
  [[nodiscard]] double stop() const noexcept;
  [[nodiscard]] double overhead_ns() const noexcept { return overhead_ * ns_per_count_; }

 private:
  double ns_per_count_ = 1.0;
  double overhead_ = 0.0;
  std::uint64_t started_ = 0;
  long switches_ = 0;
};

/// Returns the CPU time of this thread, in ns.
double thread_cpu_ns() noexcept;

/// One line of the table.
struct Row {
  std::string what;
  std::size_t segments = 0;
  std::vector<double> ns;  ///< one entry for each call
  double nodes = 0.0;      ///< mean per call, 0 if it does not apply
  double pieces = 0.0;
  double unproven = 0.0;  ///< share of the calls that the cap on work ended
};

/// Prints each row when it is added, and writes it to a CSV file if `csv_path` is not null.
class Table {
 public:
  explicit Table(const char* csv_path);
  ~Table();
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  void add(Row row);
  /// Prints a line of text that does not go to the CSV file.
  static void note(const std::string& text);

 private:
  std::FILE* csv_ = nullptr;
};

}  // namespace felt::bench
