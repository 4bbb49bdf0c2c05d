#pragma once

#include <array>
#include <cstddef>
#include <iterator>
#include <memory>
#include <vector>

namespace felt {

/// A sequence that grows at its end and never moves its elements, so that appending the millionth
/// element costs the same as the first. Used for ink in progress: a growing `std::vector` would
/// copy all its elements and delay the next sample. `clear()` keeps the memory, so that a reused
/// vector does not allocate again (`std::deque` frees its chunks).
///
/// Requires: T is default constructible and copyable. Not thread-safe.
template <class T, std::size_t kChunk = 256>
class ChunkedVector {
 public:
  using value_type = T;

  ChunkedVector() = default;
  ChunkedVector(const ChunkedVector& other) { append(other); }
  ChunkedVector(ChunkedVector&&) noexcept = default;
  ChunkedVector& operator=(const ChunkedVector& other) {
    if (this != &other) {
      clear();
      append(other);
    }
    return *this;
  }
  ChunkedVector& operator=(ChunkedVector&&) noexcept = default;
  ~ChunkedVector() = default;

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] T& operator[](std::size_t i) noexcept { return (*chunks_[i / kChunk])[i % kChunk]; }
  [[nodiscard]] const T& operator[](std::size_t i) const noexcept {
    return (*chunks_[i / kChunk])[i % kChunk];
  }
  [[nodiscard]] const T& back() const noexcept { return (*this)[size_ - 1]; }
  [[nodiscard]] T& back() noexcept { return (*this)[size_ - 1]; }

  /// Appends one element; allocates only when it uses a new chunk for the first time.
  void push_back(const T& value) {
    if (size_ == chunks_.size() * kChunk) chunks_.push_back(std::make_unique<Chunk>());
    (*this)[size_] = value;
    ++size_;
  }
  /// Removes the last element. Requires: not empty.
  void pop_back() noexcept { --size_; }
  /// Removes all elements and keeps the memory.
  void clear() noexcept { size_ = 0; }
  /// Removes all elements after the first `size`. Requires: size <= size().
  void truncate(std::size_t size) noexcept { size_ = size; }

  /// Returns a copy of all elements in one contiguous vector.
  [[nodiscard]] std::vector<T> to_vector() const { return std::vector<T>(begin(), end()); }

  /// Forward iteration over const elements.
  class ConstIterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = const T&;

    ConstIterator() = default;
    ConstIterator(const ChunkedVector* owner, std::size_t index) : owner_(owner), index_(index) {}
    reference operator*() const noexcept { return (*owner_)[index_]; }
    pointer operator->() const noexcept { return &(*owner_)[index_]; }
    ConstIterator& operator++() noexcept {
      ++index_;
      return *this;
    }
    ConstIterator operator++(int) noexcept {
      ConstIterator old = *this;
      ++index_;
      return old;
    }
    friend bool operator==(const ConstIterator&, const ConstIterator&) noexcept = default;

   private:
    const ChunkedVector* owner_ = nullptr;
    std::size_t index_ = 0;
  };
  using const_iterator = ConstIterator;
  [[nodiscard]] ConstIterator begin() const noexcept { return {this, 0}; }
  [[nodiscard]] ConstIterator end() const noexcept { return {this, size_}; }

  friend bool operator==(const ChunkedVector& a, const ChunkedVector& b) noexcept {
    if (a.size_ != b.size_) return false;
    for (std::size_t i = 0; i < a.size_; ++i) {
      if (!(a[i] == b[i])) return false;
    }
    return true;
  }

 private:
  using Chunk = std::array<T, kChunk>;

  void append(const ChunkedVector& other) {
    for (const T& value : other) push_back(value);
  }

  std::vector<std::unique_ptr<Chunk>> chunks_;
  std::size_t size_ = 0;
};

}  // namespace felt
