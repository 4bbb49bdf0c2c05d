#pragma once

#include <cstddef>  // defines __GLIBC__ if the C library is glibc

/// FELT_WIDE_VECTORS is written before a function that loops over plain numbers. The function is
/// then compiled twice: for any x86-64 processor, and for those with vectors of 256 bits (AVX2).
/// The loader selects the version for this machine. Both versions give the same numbers, because
/// multiplications and additions are not fused (cmake/options.cmake). The macro is empty on other
/// platforms and with clang. It is also empty with sanitizers, because the loader would select a
/// version before the sanitizer's runtime is ready.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FELT_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define FELT_WIDE_VECTORS
#endif
