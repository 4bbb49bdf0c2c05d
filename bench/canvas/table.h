#pragma once

#include <string>
#include <vector>

namespace felt::bench {

/// Prints the results: as a table for people, or as one line of JSON per row.
class Table {
 public:
  explicit Table(bool json) : json_(json) {}
  /// Prints a heading, unless the output is JSON.
  void heading(const std::string& text) const;
  /// Prints quantiles of times in us.
  void times(const std::string& what, std::vector<double> us) const;
  void number(const std::string& what, double value, const std::string& unit) const;

 private:
  bool json_;
};

/// Returns the CPU time of this thread, or of all threads of the process, in us.
double thread_cpu_us();
double process_cpu_us();
/// Returns the time of a monotonic wall clock, in us.
double wall_us();

}  // namespace felt::bench
