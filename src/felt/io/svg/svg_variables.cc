#include "felt/io/svg/svg_variables.h"

#include <algorithm>
#include <cmath>

#include "felt/io/svg/svg_scan.h"

namespace felt {
namespace {

constexpr int kMaxVariableNesting = 8;
constexpr std::size_t kMaxBytes = 4096;
/// Maximum number of bytes that one value may read. Each replacement counts kReplacementBytes in
/// addition to the text that it reads.
constexpr std::size_t kMaxReadBytes = std::size_t{64} << 10, kReplacementBytes = 16;
constexpr std::string_view kVar = "var(";

/// Subtracts `bytes` from `left`. Returns false if fewer bytes are left.
bool spend(std::size_t bytes, std::size_t& left) noexcept {
  const bool enough = bytes <= left;
  left -= std::min(bytes, left);
  return enough;
}

/// Returns the position of the parenthesis that closes one opened before the text, or npos.
std::size_t closing(std::string_view text) noexcept {
  int depth = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
    if (depth == 0) return i;
  }
  return std::string_view::npos;
}

/// Returns the value with its variables replaced. `bytes_left` limits the work. Limits on the
/// nesting and on the length of the result would not: if a few values contain 30 variables each and
/// the fallbacks are empty, 10^10 replacements yield an empty text.
std::optional<std::string> replaced(std::string_view value, const SvgVariables& variables,
                                    int nesting, std::size_t& bytes_left) {
  if (nesting > kMaxVariableNesting || !spend(kReplacementBytes + value.size(), bytes_left)) {
    return std::nullopt;
  }
  std::string text;
  while (true) {
    const std::size_t at = value.find(kVar);
    text += value.substr(0, at);
    if (text.size() > kMaxBytes) return std::nullopt;
    if (at == std::string_view::npos) return text;
    value.remove_prefix(at + kVar.size());
    const std::size_t end = closing(value);
    if (end == std::string_view::npos) return std::nullopt;
    const std::string_view inside = value.substr(0, end);
    value.remove_prefix(end + 1);
    const std::size_t comma = inside.find(',');
    const auto known = variables.find(svg_trimmed(inside.substr(0, comma)));
    if (known == variables.end() && comma == std::string_view::npos) return std::nullopt;
    const auto part = replaced(
        known != variables.end() ? std::string_view(known->second) : inside.substr(comma + 1),
        variables, nesting + 1, bytes_left);
    if (!part) return std::nullopt;
    text += *part;
  }
}

/// sum = product {(+|-) product}, product = value {(*|/) value}, value = length | ( sum )
class Calculation {
 public:
  using Length = std::function<std::optional<double>(std::string_view)>;
  Calculation(std::string_view text, const Length& length) : scan_(text), length_(length) {}

  std::optional<double> result() {
    const std::optional<double> sum = this->sum(0);
    return sum && scan_.at_end() && std::isfinite(*sum) ? sum : std::nullopt;
  }

 private:
  std::optional<double> sum(int nesting) {
    std::optional<double> total = product(nesting);
    while (total) {
      scan_.skip_spaces();
      const char sign = scan_.peek();
      if (sign != '+' && sign != '-') return total;
      scan_.take(sign);
      const std::optional<double> next = product(nesting);
      if (!next) return std::nullopt;
      *total += sign == '+' ? *next : -*next;
    }
    return total;
  }

  std::optional<double> product(int nesting) {
    std::optional<double> total = value(nesting);
    while (total) {
      scan_.skip_spaces();
      const char sign = scan_.peek();
      if (sign != '*' && sign != '/') return total;
      scan_.take(sign);
      const std::optional<double> next = value(nesting);
      if (!next || (sign == '/' && *next == 0.0)) return std::nullopt;
      total = sign == '*' ? *total * *next : *total / *next;
    }
    return total;
  }

  std::optional<double> value(int nesting) {
    scan_.skip_spaces();
    if (scan_.take("calc(") || scan_.take('(')) {
      if (nesting == kMaxVariableNesting) return std::nullopt;
      const std::optional<double> inside = sum(nesting + 1);
      scan_.skip_spaces();
      return scan_.take(')') ? inside : std::nullopt;
    }
    const std::string_view from = scan_.rest();
    double number = 0.0;
    if (!scan_.number(number)) return std::nullopt;
    if (!scan_.take('%')) scan_.letters();
    return length_(from.substr(0, from.size() - scan_.rest().size()));
  }

  SvgScan scan_;
  const Length& length_;
};

}  // namespace

std::optional<std::string> svg_with_variables(std::string_view value, const SvgVariables& variables,
                                              std::size_t& bytes_left) {
  const std::size_t at_most = std::min(kMaxReadBytes, bytes_left);
  std::size_t left = at_most;
  std::optional<std::string> text = replaced(value, variables, 0, left);
  bytes_left -= at_most - left;
  return text;
}

std::optional<double> svg_calc(
    std::string_view text, const std::function<std::optional<double>(std::string_view)>& length) {
  return Calculation(text, length).result();
}

}  // namespace felt
