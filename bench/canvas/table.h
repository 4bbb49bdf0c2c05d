#pragma once

#include <string>
#include <vector>

namespace felt::bench {

/// What was timed, in rows: for people, or a line of JSON each.
class Table {
 public:
  explicit Table(bool json) : json_(json) {}
  /// A heading for people.
  void heading(const std::string& text) const;
  /// Times in us.
  void times(const std::string& what, std::vector<double> us) const;
  void number(const std::string& what, double value, const std::string& unit) const;

 private:
  bool json_;
};

/// Of this thread, or of all threads, in us.
double thread_cpu_us();
double process_cpu_us();
/// A clock that does not stop while others work.
double wall_us();

}  // namespace felt::bench
