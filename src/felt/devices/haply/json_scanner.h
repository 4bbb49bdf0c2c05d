#pragma once

#include <cstdint>
#include <string_view>

namespace felt::haply {

/// The kinds of token in a JSON text.
enum class JsonToken : std::uint8_t {
  kBeginObject,
  kEndObject,
  kBeginArray,
  kEndArray,
  kKey,  ///< a key, see text(); the next token begins its value
  kString,
  kNumber,
  kTrue,
  kFalse,
  kNull,
  kEnd,  ///< end of a well-formed text
  kBad,  ///< not JSON, too deep, or a number too large for a double; permanent
};

/// Reads a JSON text (RFC 8259) token by token in place: without allocation, recursion or
/// exceptions, so that the haptic thread can read the service's messages. The scanner checks the
/// grammar, the numbers, and control characters and escapes in strings. It does not check that
/// strings are valid UTF-8.
class JsonScanner {
 public:
  static constexpr int kMaxDepth = 24;

  explicit JsonScanner(std::string_view json) noexcept : rest_(json) {}

  JsonToken next() noexcept;
  /// Returns the text between the quotes of the newest kKey or kString. Escapes are not decoded.
  [[nodiscard]] std::string_view text() const noexcept { return text_; }
  /// Returns the value of the newest kNumber, which is finite.
  [[nodiscard]] double number() const noexcept { return number_; }
  /// Returns how many objects and arrays are open.
  [[nodiscard]] int depth() const noexcept { return depth_; }
  /// Skips the rest of an object or array, including its end. `depth` is the value that depth() had
  /// immediately after the beginning of the object or array was read. Returns false if the text is
  /// bad.
  bool leave(int depth) noexcept;
  /// Skips the next value, whatever it is. Returns false if the text is bad.
  bool skip_value() noexcept;

 private:
  enum class Expect : std::uint8_t { kValue, kFirstKey, kKey, kFirstItem, kCommaOrEnd, kNothing };

  void skip_space() noexcept;
  JsonToken bad() noexcept;
  JsonToken value() noexcept;
  JsonToken scalar() noexcept;
  JsonToken open(bool is_object) noexcept;
  JsonToken close() noexcept;
  JsonToken key() noexcept;
  JsonToken after_value() noexcept;
  JsonToken literal(std::string_view word, JsonToken token) noexcept;
  JsonToken read_number() noexcept;
  bool read_string() noexcept;
  void value_is_over() noexcept;
  [[nodiscard]] bool in_object() const noexcept {
    return depth_ > 0 && ((objects_ >> (depth_ - 1)) & 1u) != 0;
  }

  std::string_view rest_;
  std::string_view text_;
  double number_ = 0.0;
  int depth_ = 0;
  std::uint32_t objects_ = 0;  // bit i: the container at depth i is an object, not an array
  Expect expect_ = Expect::kValue;
  bool is_bad_ = false;
};

}  // namespace felt::haply
