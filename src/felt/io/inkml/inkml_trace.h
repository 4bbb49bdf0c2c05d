#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "felt/io/limits.h"

namespace felt {

/// Reads the text of InkML's traces, point by point: values in the order of the channels, explicit
/// or as first and second differences, run together or apart (InkML, section 3.3.1).
///
///   1125 18432,'23'43,"7"-8,3-5     ->  (1125,18432) (1148,18475) (1178,18510) (1211,18540)
///
/// Each channel has a mode of its own, which stays until a prefix changes it: ! explicit,
/// ' first difference, " second difference. "*" goes on as before (the same value, difference or
/// second difference), "?" is not known. Booleans are T and F, hexadecimal numbers begin with #.
class InkmlTraceReader {
 public:
  /// A text and its number of channels, at least one; regular ones first, then those that a point
  /// may leave out. The text must outlive the reader.
  InkmlTraceReader(std::string_view text, std::size_t channels);

  /// Goes to the next point; false at the end of the text, or where it is broken.
  bool next();
  /// Values of the point, one a channel; NaN where they are unknown or left out.
  [[nodiscard]] std::span<const double> values() const noexcept { return values_; }
  /// Why next() stopped before the end: "has '..' where a value must be, in point 3"; else empty.
  [[nodiscard]] const std::string& problem() const noexcept { return problem_; }

 private:
  enum class Mode : unsigned char { kExplicit, kFirst, kSecond };
  struct Channel {
    Mode mode = Mode::kExplicit;
    bool known = false;  // it has had a value
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
