#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace felt::cli {

/// Encodes values as bytes, to send them from a child process to its parent. This is not a file
/// format.
class Packer {
 public:
  void put(std::string_view text) {
    put(static_cast<std::uint64_t>(text.size()));
    bytes_.append(text);
  }
  template <class T>
  requires std::is_trivially_copyable_v<T> &&
      (!std::is_convertible_v<T, std::string_view>)void put(const T& value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::string bytes_;
};

/// Decodes the bytes of a Packer. If values are missing, for example because the child process
/// ended before it had written all of them, the missing values are decoded as empty or zero, and
/// is_good() returns false from then on.
class Unpacker {
 public:
  explicit Unpacker(std::string_view bytes) : rest_(bytes) {}

  template <class T>
  T take() {
    if constexpr (std::is_same_v<T, std::string>) {
      const auto size = take<std::uint64_t>();
      if (size > rest_.size()) return give_up(), std::string();
      std::string text(rest_.substr(0, static_cast<std::size_t>(size)));
      rest_.remove_prefix(text.size());
      return text;
    } else {
      static_assert(std::is_trivially_copyable_v<T>);
      T value{};
      if (rest_.size() < sizeof value) return give_up(), value;
      std::memcpy(&value, rest_.data(), sizeof value);
      rest_.remove_prefix(sizeof value);
      return value;
    }
  }
  /// Reads the number of elements that follow. Each element has at least one byte.
  std::size_t take_count() {
    const auto count = take<std::uint64_t>();
    if (count > rest_.size()) return give_up(), std::size_t{0};
    return static_cast<std::size_t>(count);
  }
  [[nodiscard]] bool is_good() const noexcept { return is_good_; }

 private:
  void give_up() {
    is_good_ = false;
    rest_ = {};
  }

  std::string_view rest_;
  bool is_good_ = true;
};

}  // namespace felt::cli
