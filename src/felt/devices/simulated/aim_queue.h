#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "felt/geometry/vec3.h"

namespace felt {

/// What a hand wants from now on.
struct Aim {
  Vec3 target_mm;
  std::optional<double> pressure{};
  std::uint32_t buttons = 0;

  friend constexpr bool operator==(const Aim&, const Aim&) noexcept = default;
};

/// Aims on their way from the thread of mouse or tablet to the haptic thread: one writer, one
/// reader, no waiting. A full queue, which means that the reader has stood still for a second or
/// more, refuses.
class AimQueue {
 public:
  static constexpr std::size_t kCapacity = 256;

  /// False where it is full.
  bool push(const Aim& aim) noexcept {
    const std::size_t end = end_.load(std::memory_order_relaxed);
    if (end - begin_.load(std::memory_order_acquire) == kCapacity) return false;
    aims_[end % kCapacity] = aim;
    end_.store(end + 1, std::memory_order_release);
    return true;
  }
  /// The oldest one, or null; stays until pop().
  [[nodiscard]] const Aim* front() const noexcept {
    const std::size_t begin = begin_.load(std::memory_order_relaxed);
    return begin == end_.load(std::memory_order_acquire) ? nullptr : &aims_[begin % kCapacity];
  }
  void pop() noexcept {
    begin_.store(begin_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }

 private:
  std::array<Aim, kCapacity> aims_{};
  alignas(64) std::atomic<std::size_t> end_{0};
  alignas(64) std::atomic<std::size_t> begin_{0};
};

}  // namespace felt
