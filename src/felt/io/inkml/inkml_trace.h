#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/io/limits.h"

namespace felt {

/// Reads the text of an InkML trace point by point. The text has the values of all channels of the
/// first point, then those of the next point, and so on. They are written as numbers, first
/// differences or second differences, with or without separators (InkML, section 3.3.1).
///
///   1125 18432,'23'43,"7"-8,3-5     ->  (1125,18432) (1148,18475) (1178,18510) (1211,18540)
///
/// Each channel has its own mode, which remains in effect until a prefix changes it: ! explicit, '
/// first difference, " second difference. "*" repeats the previous value, difference or second
/// difference, and "?" is an unknown value. Booleans are T and F, and hexadecimal numbers begin
/// with #.
class InkmlTraceReader {
 public:
  /// Requires at least one channel: regular ones first, then those that a point may omit. The text
  /// must outlive the reader.
  InkmlTraceReader(std::string_view text, std::size_t channels);

  /// Advances to the next point. Returns false at the end of the text, or at an error.
  bool next();
  /// Returns the values of the point, one for each channel; NaN if unknown or omitted.
  [[nodiscard]] std::span<const double> values() const noexcept { return values_; }
  /// Returns the reason why next() stopped before the end of the text, for example "has '..' where
  /// a value must be, in point 3", or an empty string.
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

 private:
  enum class Mode : unsigned char { kExplicit, kFirst, kSecond };
  struct Channel {
    Mode mode = Mode::kExplicit;
    bool known = false;  // a value of this channel was read
    double value = 0.0, difference = 0.0, second = 0.0;
  };

  void skip_spaces() noexcept;
  bool read_value(Channel& channel, double& value);
  bool read_number(double& number);
  static double step(Channel& channel, double number) noexcept;
  static double go_on(Channel& channel) noexcept;
  bool stop(std::string problem);

  std::string_view rest_;
  std::vector<Channel> channels_;
  std::vector<double> values_;
  std::size_t points_ = 0;
  std::string problem_;
};

}  // namespace felt
