#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace felt {

/// The names of numbered files: "walk-%03d.svg".
class NumberedNames {
 public:
  /// Parses a path whose file name contains one "%d" or "%03d". Returns nullopt if it contains
  /// none.
  static std::optional<NumberedNames> parse(const std::string& text);
  /// Returns the names "walk-001.svg" and so on for "walk.svg", without a meaning of "%". The
  /// number is put before the last dot of the file name.
  static NumberedNames before_suffix(const std::string& path);
  /// Returns the name with a number.
  [[nodiscard]] std::string name(std::size_t number) const;

 private:
  std::string before_, after_;
  std::size_t digits_ = 1;
};

}  // namespace felt
