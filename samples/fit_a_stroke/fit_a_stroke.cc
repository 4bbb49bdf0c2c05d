// Fits one pen stroke with the installed library and prints its segments.
//
//   cmake -B build && cmake --build build && build/fit_a_stroke
//   g++ -std=c++20 fit_a_stroke.cc $(pkg-config --cflags --libs feltline) -o fit_a_stroke

#include <cmath>
#include <cstdio>
#include <numbers>

#include "felt/stroke/fit/ink_fitter.h"

namespace {

// The samples of a pen at 200 Hz that writes a loop 40 mm wide and presses harder half-way.
felt::InkSample sample(int i, int count) {
  const double phase = static_cast<double>(i) / count;
  const double angle = 2.0 * std::numbers::pi * phase;
  felt::InkSample s;
  s.position = {30.0 + 20.0 * std::sin(angle), 20.0 + 10.0 * std::sin(2.0 * angle)};
  s.pressure = 0.3 + 0.6 * std::sin(std::numbers::pi * phase);
  s.time_ns = std::int64_t{5'000'000} * i;
  return s;
}

}  // namespace

int main() {
  felt::InkFitOptions options;
  options.curve.tolerance_mm = 0.1;  // no sample is farther than this from the curve

  felt::InkFitter fitter(options);
  fitter.begin();
  constexpr int kSamples = 200;
  for (int i = 0; i < kSamples; ++i) fitter.push(sample(i, kSamples));
  fitter.end();     // pen-up: the curve that was shown while drawing is complete
  fitter.refine();  // fewer segments, same tolerance

  const felt::Result<felt::Stroke> stroke = fitter.stroke();
  if (!stroke) {
    std::fprintf(stderr, "fit_a_stroke: %s\n", stroke.error().message.c_str());
    return 1;
  }
  std::printf("%d samples -> %d segments\n", kSamples, stroke->segment_count());
  for (int i = 0; i < stroke->segment_count(); ++i) {
    const auto& p = stroke->segment(i).p;
    std::printf("  (%.2f, %.2f) (%.2f, %.2f) (%.2f, %.2f) (%.2f, %.2f)  %.2f mm wide\n", p[0].x,
                p[0].y, p[1].x, p[1].y, p[2].x, p[2].y, p[3].x, p[3].y, stroke->width_mm(i));
  }
  return 0;
}
