#include "bench/peers/long_report.h"

#include <cstdio>

#include "bench/peers/measure.h"

namespace felt::bench {
namespace {

void print_calls(const char* what, const std::vector<float>& calls) {
  double sum = 0.0;
  for (const float call : calls) sum += static_cast<double>(call);
  std::printf("  %-22s mean %7.0f  p99 %7.0f  p99.9 %7.0f  p99.99 %7.0f  max %8.0f\n", what,
              sum / static_cast<double>(calls.size()), quantile(calls, 0.99),
              quantile(calls, 0.999), quantile(calls, 0.9999), quantile(calls, 1.0));
}

void print_slowest(const std::vector<float>& calls) {
  const auto slowest = std::max_element(calls.begin(), calls.end());
  std::printf("  slowest call: number %td of %zu\n", slowest - calls.begin() + 1, calls.size());
}

void print_result(const fit_check::Report& r) {
  std::printf("  result: %lld segments, %d strokes over tolerance (max error %.6f), %d G1 breaks\n",
              static_cast<long long>(r.segments), r.over_tolerance, r.max_error, r.breaks[0]);
  std::printf("          %d corners, %d of them where the ink turns by under %g degrees\n",
              r.corners, r.weak_corners[1][0], fit_check::kCornerDeg[0]);
  std::printf("          overshoot %.2f, at most %.2f less than it may be: %s\n\n",
              r.max_overshoot(), -r.overshoot_excess, r.clean() ? "clean" : "NOT clean");
}

/// Removes the last call, which is the pen-up, and returns its time.
float split_pen_up(std::vector<float>& calls) {
  const float pen_up = calls.empty() ? 0.0F : calls.back();
  if (!calls.empty()) calls.pop_back();
  return pen_up;
}

void report(Peer& peer, const fit_check::Ink& ink, double tolerance, int repeats) {
  std::printf("%s, %zu samples, tolerance %g\n", peer.name().c_str(), ink.samples.size(),
              tolerance);
  Probe warm_up(Probe::Mode::kTotal);
  peer.fit(ink, warm_up);
  fit_check::FitCurve curve = peer.curve();

  Probe total(Probe::Mode::kTotal);
  peer.fit(ink, total);
  const auto samples = static_cast<double>(ink.samples.size());
  std::printf("  whole stroke: %.0f ns per sample, %.6f allocations per sample\n",
              static_cast<double>(total.total_ns()) / samples,
              static_cast<double>(total.allocations()) / samples);

  std::vector<float> best;
  for (int i = 0; i < repeats; ++i) {
    Probe each(Probe::Mode::kEachCall);
    peer.fit(ink, each);
    std::vector<float> calls = each.calls_ns();
    keep_smaller(best, calls);
    split_pen_up(calls);
    print_calls(("push(), run " + std::to_string(i + 1)).c_str(), calls);
  }
  const float pen_up = split_pen_up(best);
  print_calls("push(), least of runs", best);
  print_slowest(best);
  std::printf("  end(), least of runs   %.0f\n", static_cast<double>(pen_up));
  std::fflush(stdout);
  print_result(fit_check::check_stroke(ink, curve, tolerance));
}

}  // namespace

void print_long_report(std::int64_t samples, double tolerance, int repeats, unsigned seed,
                       const std::string& only) {
  const fit_check::Ink ink = make_long_stroke(samples, tolerance, seed);
  std::printf(
      "Thread CPU time in ns. An empty measurement takes %lld ns, which every call includes.\n\n",
      static_cast<long long>(timer_overhead_ns()));
  for (const auto& peer : make_feltline_peers(tolerance)) {
    const bool wanted = peer->name().find(only) != std::string::npos;
    if (wanted && peer->call_unit() == "sample") report(*peer, ink, tolerance, repeats);
  }
}

}  // namespace felt::bench
