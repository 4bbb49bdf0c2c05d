#pragma once

#include <cstddef>  // a header of the C library, which says whether it is glibc

/// FELT_WIDE_VECTORS before a function that is a loop over plain numbers: it is compiled twice, for
/// any processor of the family and for those with vectors of 256 bits (AVX2), and the loader takes
/// what this machine has. Both give the same numbers, since nothing is fused (cmake/options.cmake).
/// Elsewhere, and under sanitizers, whose runtime the loader's choice would come before, nothing.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define FELT_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define FELT_WIDE_VECTORS
#endif
