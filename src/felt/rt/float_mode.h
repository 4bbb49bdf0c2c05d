#pragma once

#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <cstdint>
#endif

namespace felt {

/// Treats denormals as zero within a block, and restores the thread's previous mode at the end of
/// the block. Without this mode, a bristle of the friction model or a low-pass filter that decays
/// below 1e-308 would make each operation a hundred times slower. Servo::step is such a block, so
/// that it computes the same numbers for every caller. Has no effect on processors other than
/// x86-64 and AArch64.
class FlushDenormals {
 public:
  FlushDenormals() noexcept : saved_(get()) { set(saved_ | kBits); }
  ~FlushDenormals() noexcept { set(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
#if defined(__SSE2__)
  using Mode = unsigned int;
  static constexpr Mode kBits = 0x8040;  // FTZ: results, DAZ: operands
  static Mode get() noexcept {
    return _mm_getcsr();
  }
  static void set(Mode mode) noexcept {
    _mm_setcsr(mode);
  }
#elif defined(__aarch64__)
  using Mode = std::uint64_t;
  static constexpr Mode kBits = Mode{1} << 24;  // FZ
  static Mode get() noexcept {
    Mode mode = 0;
    asm volatile("mrs %0, fpcr" : "=r"(mode));
    return mode;
  }
  static void set(Mode mode) noexcept {
    asm volatile("msr fpcr, %0" : : "r"(mode));
  }
#else
  using Mode = int;
  static constexpr Mode kBits = 0;
  static Mode get() noexcept {
    return 0;
  }
  static void set(Mode) noexcept {}
#endif

  Mode saved_;
};

}  // namespace felt
