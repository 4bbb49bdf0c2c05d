// bench_stability [FILE [TRIAL]]: writes the whole stability matrix to FILE (docs/stability.md),
// which takes about two minutes on two cores. It uses virtual time, so the figures are the same on
// a busy machine. With a TRIAL ("shake"), runs and reports only these trials.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <thread>

#include "tests/devices/stability/stability_matrix.h"

int main(int argc, char** argv) {
  const std::string path = argc > 1 ? argv[1] : "docs/stability.md";
  auto cells = felt::all_cells();
  if (argc > 2) {
    std::erase_if(cells, [&](const auto& c) { return felt::name_of(c.trial) != argv[2]; });
  }
  std::printf("%zu trials ...\n", cells.size());
  const auto results = felt::run_cells(cells, std::max(1u, std::thread::hardware_concurrency()));
  const auto failing = std::count_if(results.begin(), results.end(),
                                     [](const auto& result) { return !felt::passes(result); });
  std::ofstream out(path, std::ios::binary);
  out << felt::stability_report(cells, results);
  out.close();
  if (!out) {
    std::fprintf(stderr, "bench_stability: cannot write %s\n", path.c_str());
    return 1;
  }
  std::printf("%ld fail; %s\n", static_cast<long>(failing), path.c_str());
  return 0;
}
