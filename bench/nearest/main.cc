// Measures the speed and the accuracy of nearest-point queries. See the performance notes in
// nearest.h and bvh.h.
//   bench_nearest [--csv FILE] [--largest N]     times; N is the largest tree (10^6)
//   bench_nearest --check N                      compares N cases with dense sampling
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "rows.h"

int main(int argc, char** argv) {
  using namespace felt::bench;
  const char* csv = nullptr;
  std::size_t largest = 1000000;
  for (int i = 1; i < argc; ++i) {
    const bool has_value = i + 1 < argc;
    if (std::strcmp(argv[i], "--check") == 0 && has_value) {
      return check(std::strtoull(argv[i + 1], nullptr, 10)) == 0 ? 0 : 1;
    }
    if (std::strcmp(argv[i], "--csv") == 0 && has_value) {
      csv = argv[++i];
    } else if (std::strcmp(argv[i], "--largest") == 0 && has_value) {
      largest = std::strtoull(argv[++i], nullptr, 10);
    } else {
      std::fprintf(stderr, "usage: %s [--csv FILE] [--largest N] | --check N\n", argv[0]);
      return 2;
    }
  }
  Stopwatch watch;
  std::printf("reading the clock takes %.0f ns (subtracted)\n", watch.overhead_ns());
  Table table(csv);
  for (std::size_t n = 1000; n <= largest; n *= 10) tree_rows(table, watch, n);
  adversarial_rows(table, watch);
  cubic_rows(table, watch);
  return 0;
}
