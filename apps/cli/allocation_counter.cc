#include "allocation_counter.h"

#include <cstdlib>
#include <new>

namespace felt::cli {
namespace {

thread_local std::int64_t allocation_count = 0;

}  // namespace

std::int64_t thread_allocations() noexcept {
  return allocation_count;
}

#ifndef FELT_SANITIZED
namespace {

void* allocate(std::size_t size) {
  ++allocation_count;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

void* allocate_aligned(std::size_t size, std::align_val_t alignment) {
  ++allocation_count;
  const auto align = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(align, (size + align - 1) / align * align)) return memory;
  throw std::bad_alloc();
}

}  // namespace
#endif

}  // namespace felt::cli

#ifndef FELT_SANITIZED
// By default the array and nothrow forms call these operators ([new.delete] of the C++ standard).
void* operator new(std::size_t size) {
  return felt::cli::allocate(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return felt::cli::allocate_aligned(size, alignment);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}
#endif
