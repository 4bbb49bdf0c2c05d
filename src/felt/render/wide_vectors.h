#pragma once

#include <cstddef>  // defines __GLIBC__ if the C library is glibc

/// FELT_WIDE_VECTORS before a function that is a loop over plain numbers compiles it twice: for any
/// x86-64 processor, and for those with vectors of 256 bits (AVX2). The loader selects the version
/// for this machine. Both versions give the same numbers, because multiplications and additions are
/// not fused (cmake/options.cmake). The macro is empty on other platforms, and under sanitizers,
/// because the loader's choice would run before their runtime is ready.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FELT_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define FELT_WIDE_VECTORS
#endif
