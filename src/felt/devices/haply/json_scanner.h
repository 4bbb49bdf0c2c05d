#pragma once

#include <cstdint>
#include <string_view>

namespace felt::haply {

/// What stands next in a JSON text.
enum class JsonToken : std::uint8_t {
  kBeginObject,
  kEndObject,
  kBeginArray,
  kEndArray,
  kKey,  ///< text(); its value comes next
  kString,
  kNumber,
  kTrue,
  kFalse,
  kNull,
  kEnd,  ///< the text is over, and was well-formed
  kBad,  ///< it is not JSON, or too deep, or a number is beyond a double; said for ever
};

/// Reads a JSON text (RFC 8259) token by token where it lies: without memory of its own, recursion
/// or exception, so that the haptic thread can read what a service says. Grammar and numbers are
/// checked; the bytes of strings are checked for control characters and escapes, not for UTF-8.
class JsonScanner {
 public:
  static constexpr int kMostDepth = 24;

  explicit JsonScanner(std::string_view json) noexcept : rest_(json) {}

  JsonToken next() noexcept;
  /// Of the newest kKey or kString: what stands between the quotes, escapes as they are written.
  [[nodiscard]] std::string_view text() const noexcept { return text_; }
  /// Of the newest kNumber; finite.
  [[nodiscard]] double number() const noexcept { return number_; }
  /// How many objects and arrays are open.
  [[nodiscard]] int depth() const noexcept { return depth_; }
  /// Goes on until the object or array that stood at this depth() when it had been entered is
  /// over. False: bad.
  bool leave(int depth) noexcept;
  /// The next value, whatever it is, is passed over. False: bad.
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
  std::uint32_t objects_ = 0;  // bit i: the i-th open one is an object
  Expect expect_ = Expect::kValue;
  bool is_bad_ = false;
};

}  // namespace felt::haply
