#include "felt/io/inkml/inkml_trace.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace felt {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

bool is_space(char c) noexcept {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// Returns the start of unreadable text, in a form that is safe to show.
std::string shown(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 12)) out += c >= ' ' && c <= '~' ? c : '?';
  return out;
}

}  // namespace

InkmlTraceReader::InkmlTraceReader(std::string_view text, std::size_t channels)
    : rest_(text), channels_(channels), values_(channels) {}

bool InkmlTraceReader::next() {
  skip_spaces();
  while (!rest_.empty() && rest_.front() == ',') {
    rest_.remove_prefix(1);
    skip_spaces();
  }
  if (rest_.empty() || !problem_.empty()) return false;
  ++points_;
  std::size_t count = 0;
  for (; !rest_.empty() && rest_.front() != ','; skip_spaces()) {
    if (count == channels_.size()) return stop("has more values than channels");
    if (!read_value(channels_[count], values_[count])) return false;
    ++count;
  }
  for (; count < values_.size(); ++count) values_[count] = kUnknown;
  return true;
}

void InkmlTraceReader::skip_spaces() noexcept {
  while (!rest_.empty() && is_space(rest_.front())) rest_.remove_prefix(1);
}

bool InkmlTraceReader::read_value(Channel& channel, double& value) {
  const char prefix = rest_.front();
  if (prefix == '!' || prefix == '\'' || prefix == '"') {
    channel.mode = prefix == '!' ? Mode::kExplicit : prefix == '\'' ? Mode::kFirst : Mode::kSecond;
    rest_.remove_prefix(1);
    skip_spaces();
  }
  const char first = rest_.empty() ? '\0' : rest_.front();
  if (first == '?' || first == '*') {
    rest_.remove_prefix(1);
    value = first == '?' || !channel.known ? kUnknown : go_on(channel);
  } else if (first == 'T' || first == 'F') {
    rest_.remove_prefix(1);
    channel.mode = Mode::kExplicit;
    value = step(channel, first == 'T' ? 1.0 : 0.0);
  } else {
    double number = 0.0;
    if (!read_number(number)) {
      return stop("has '" + shown(rest_) + "' instead of a value");
    }
    value = step(channel, number);
  }
  if (std::fabs(value) > limits::kMaxTimeMs) return stop("has a value that is too large");
  return true;
}

bool InkmlTraceReader::read_number(double& number) {
  std::string_view digits = rest_;
  if (!digits.empty() && digits.front() == '#') {
    long long hex = 0;
    const char* begin = digits.data() + 1;
    const auto [end, error] = std::from_chars(begin, digits.data() + digits.size(), hex, 16);
    if (error != std::errc()) return false;
    number = static_cast<double>(hex);
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return true;
  }
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const auto length = static_cast<std::size_t>(end - rest_.data());
  if (error != std::errc() || !std::isfinite(number) || length > limits::kMaxNumberChars) {
    return false;
  }
  rest_.remove_prefix(length);
  return true;
}

double InkmlTraceReader::step(Channel& channel, double number) noexcept {
  const double before = channel.known ? channel.value : 0.0;
  const double difference = channel.mode == Mode::kExplicit ? number - before
                            : channel.mode == Mode::kFirst  ? number
                                                            : channel.difference + number;
  channel.value = channel.mode == Mode::kExplicit ? number : before + difference;
  channel.second = channel.mode == Mode::kSecond ? number : difference - channel.difference;
  channel.difference = channel.known || channel.mode != Mode::kExplicit ? difference : 0.0;
  channel.known = true;
  return channel.value;
}

double InkmlTraceReader::go_on(Channel& channel) noexcept {
  switch (channel.mode) {
    case Mode::kExplicit:
      channel.difference = 0.0;
      break;
    case Mode::kFirst:
      channel.value += channel.difference;
      break;
    case Mode::kSecond:
      channel.difference += channel.second;
      channel.value += channel.difference;
      break;
  }
  return channel.value;
}

bool InkmlTraceReader::stop(std::string problem) {
  problem_ = std::move(problem) + ", in point " + std::to_string(points_);
  return false;
}

}  // namespace felt
