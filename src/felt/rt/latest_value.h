#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <type_traits>

namespace felt {

/// Passes the newest value from one publishing thread to one reading thread. A value that is not
/// read in time is replaced, not queued. Publisher and reader are wait-free. It is a triple buffer:
/// the publisher owns one slot, the reader owns another, and each of them can swap its slot for the
/// third by one atomic exchange. The reader never sees a partial value, and never a value older
/// than one that it has already seen.
///
/// A seqlock would save one copy, but its reader must retry if the writer interferes. The haptic
/// thread is one of the readers and must not retry.
template <class T>
class LatestValue {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  LatestValue() = default;
  explicit LatestValue(const T& value) : slots_{Slot{value}, Slot{value}, Slot{value}} {}
  LatestValue(const LatestValue&) = delete;
  LatestValue& operator=(const LatestValue&) = delete;

  /// Makes a value available to the reader's next update(). Publisher's thread only.
  void publish(const T& value) noexcept {
    slots_[writing_].value = value;
    const std::uint8_t old =
        shared_.exchange(static_cast<std::uint8_t>(writing_ | kFresh), std::memory_order_acq_rel);
    writing_ = old & kIndex;
  }

  /// Fetches the newest value. Returns false if get() already returns that value. Reader's thread
  /// only.
  bool update() noexcept {
    if ((shared_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    reading_ = shared_.exchange(reading_, std::memory_order_acq_rel) & kIndex;
    return true;
  }

  /// Returns the value of the last update(). It stays valid and unchanged until the next update().
  /// Reader's thread only.
  [[nodiscard]] const T& get() const noexcept { return slots_[reading_].value; }

 private:
  static constexpr std::uint8_t kIndex = 3;
  static constexpr std::uint8_t kFresh = 4;  // published since the reader's last update
  static constexpr std::size_t kCacheLine = 64;

  struct alignas(kCacheLine) Slot {
    T value{};
  };

  std::array<Slot, 3> slots_{};
  alignas(kCacheLine) std::atomic<std::uint8_t> shared_{1};
  alignas(kCacheLine) std::uint8_t writing_ = 0;  // publisher's
  alignas(kCacheLine) std::uint8_t reading_ = 2;  // reader's
};

}  // namespace felt
