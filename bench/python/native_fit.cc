// The module bench_python: times the library's fitter on the strokes that run.py fits in Python.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <time.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "felt/io/import.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt::bench {
namespace {

namespace py = pybind11;
using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::int64_t thread_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return std::int64_t{1'000'000'000} * now.tv_sec + now.tv_nsec;
}

std::vector<InkSample> samples_of(const Rows& rows) {
  std::vector<InkSample> samples;
  samples.reserve(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    InkSample sample;
    sample.position = {rows.at(i, 0), rows.at(i, 1)};
    if (!std::isnan(rows.at(i, 2))) sample.pressure = rows.at(i, 2);
    if (!std::isnan(rows.at(i, 3))) sample.time_ns = std::llround(rows.at(i, 3) * 1e6);
    samples.push_back(sample);
  }
  return samples;
}

/// Returns the CPU time in ns of fitting all strokes with one fitter, as a C++ program would, and
/// the number of segments.
std::pair<std::int64_t, int> fit_all(const std::vector<Rows>& strokes, double tolerance_mm,
                                     bool refine) {
  std::vector<std::vector<InkSample>> all;
  all.reserve(strokes.size());
  for (const Rows& rows : strokes) all.push_back(samples_of(rows));
  InkFitOptions options = solid_fit({});
  options.curve.tolerance_mm = tolerance_mm;
  InkFitter fitter(options);
  int segments = 0;
  const std::int64_t start = thread_ns();
  for (const auto& samples : all) {
    fitter.begin();
    for (const InkSample& sample : samples) fitter.push(sample);
    fitter.end();
    if (refine) fitter.refine();
    segments += fitter.stroke()->segment_count();
  }
  return {thread_ns() - start, segments};
}

}  // namespace
}  // namespace felt::bench

PYBIND11_MODULE(bench_python, module) {
  module.def("fit_all", &felt::bench::fit_all);
}
