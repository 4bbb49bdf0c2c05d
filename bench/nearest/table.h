#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace felt::bench {

/// Times pieces of work of some 100 ns. The processor's counter is read (about 20 ns, subtracted),
/// because the thread CPU clock is a system call that costs more than a query. A call during which
/// the scheduler took the processor away is not CPU time, so it counts as preempted and stays out
/// of the percentiles; interrupts and the host of a virtual machine cannot be seen and stay in.
/// Elsewhere than on x86 the monotonic clock is used.
class Stopwatch {
 public:
  Stopwatch();
  void start() noexcept;
  /// Nanoseconds since `start`, less the cost of reading; negative when preempted since.
  [[nodiscard]] double stop() const noexcept;
  [[nodiscard]] double overhead_ns() const noexcept { return overhead_ * ns_per_count_; }

 private:
  double ns_per_count_ = 1.0;
  double overhead_ = 0.0;
  std::uint64_t started_ = 0;
  long switches_ = 0;
};

/// CPU time of this thread so far, in ns.
double thread_cpu_ns() noexcept;

/// One line of the table.
struct Row {
  std::string what;
  std::size_t segments = 0;
  std::vector<double> ns;  ///< one entry for each call
  double nodes = 0.0;      ///< mean per call, 0 when it does not apply
  double pieces = 0.0;
  double unproven = 0.0;  ///< part of the calls that the cap ended
};

/// Prints rows as they come, and writes them to a CSV file when one is named.
class Table {
 public:
  explicit Table(const char* csv_path);
  ~Table();
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  void add(Row row);
  /// A line of text for the reader only.
  static void note(const std::string& text);

 private:
  std::FILE* csv_ = nullptr;
};

}  // namespace felt::bench
