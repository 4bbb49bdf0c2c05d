#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>

namespace felt {

/// A queue from one producer thread to one consumer thread that delivers every element in order.
/// Producer and consumer are wait-free. If the consumer falls capacity() elements behind, new
/// elements are dropped and counted; the producer never waits. N is a power of two.
///
/// The constructor allocates and touches all memory, so that a push causes neither an allocation
/// nor a page fault.
///
/// We don't use the usual library (moodycamel's ReaderWriterQueue), for three reasons. That library
/// orders memory accesses by stand-alone fences, which the ThreadSanitizer of g++ does not model
/// and so cannot check. It does not count overflows. Every user of our installed headers would also
/// need its package.
template <class T, std::size_t N>
class SpscRing {
  static_assert(std::is_trivially_copyable_v<T>);
  static_assert(N > 1 && (N & (N - 1)) == 0, "a power of two");

 public:
  SpscRing() : SpscRing(N) {}
  /// Makes a queue for fewer elements: `capacity`, rounded down to a power of two, 2..N.
  explicit SpscRing(std::size_t capacity)
      : mask_(std::bit_floor(std::clamp<std::size_t>(capacity, 2, N)) - 1),
        slots_(new T[mask_ + 1]()) {}
  SpscRing(const SpscRing&) = delete;
  SpscRing& operator=(const SpscRing&) = delete;

  [[nodiscard]] std::size_t capacity() const noexcept { return mask_ + 1; }

  /// Adds an element. If the ring is full, drops and counts the element and returns false. Producer
  /// thread only.
  bool push(const T& value) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (tail - head_seen_ > mask_) {
      head_seen_ = head_.load(std::memory_order_acquire);
      if (tail - head_seen_ > mask_) {
        dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        return false;
      }
    }
    slots_[tail & mask_] = value;
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

  /// Removes the oldest element. Returns false if the ring is empty. Consumer thread only.
  bool pop(T& value) noexcept { return pop(std::span<T>(&value, 1)) == 1; }

  /// Removes the oldest elements, at most out.size(), and writes them to the front of `out`.
  /// Returns their number. Consumer thread only.
  std::size_t pop(std::span<T> out) noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    const std::size_t count = std::min(tail_.load(std::memory_order_acquire) - head, out.size());
    for (std::size_t i = 0; i < count; ++i) out[i] = slots_[(head + i) & mask_];
    head_.store(head + count, std::memory_order_release);
    return count;
  }

  /// Returns the number of queued elements. The consumer can pop at least that many; on other
  /// threads the number is an estimate.
  [[nodiscard]] std::size_t size() const noexcept {
    const std::size_t head = head_.load(std::memory_order_acquire);
    return std::min(tail_.load(std::memory_order_acquire) - head, capacity());
  }

  /// Returns the number of elements dropped because the consumer was too slow. Safe to call from
  /// any thread.
  [[nodiscard]] std::uint64_t dropped() const noexcept {
    return dropped_.load(std::memory_order_relaxed);
  }

 private:
  static constexpr std::size_t kCacheLine = 64;  // separates the counters of producer and consumer

  const std::size_t mask_;
  const std::unique_ptr<T[]> slots_;
  alignas(kCacheLine) std::atomic<std::size_t> tail_{0};  // written by the producer
  std::size_t head_seen_ = 0;                             // the producer's last copy of head_
  std::atomic<std::uint64_t> dropped_{0};
  alignas(kCacheLine) std::atomic<std::size_t> head_{0};  // written by the consumer
};

}  // namespace felt
