/// Fits any samples in any order. The fitter must keep its documented guarantees, both while
/// samples arrive and after refine().

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "felt/base/check.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt {
namespace {

/// More samples than one segment can hold (256), but few enough to try many inputs per second.
constexpr std::size_t kMaxSamples = 600;

/// Reads numbers from the input. After its end, all bytes are 0.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] bool empty() const { return at_ >= size_; }
  std::uint8_t byte() { return empty() ? std::uint8_t{0} : data_[at_++]; }
  int small() { return static_cast<std::int8_t>(byte()); }
  int wide() { return small() * 256 + byte(); }
  double any_double() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits = bits << 8 | byte();
    double number = 0.0;
    std::memcpy(&number, &bits, sizeof number);
    return number;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

InkFitOptions take_options(Bytes& in) {
  constexpr double kTolerancesMm[] = {0.15, 0.01, 1.0, 1e-6, 30.0, 0.05, 0.5, 2.0};
  InkFitOptions options;
  const std::uint8_t flags = in.byte();
  options.curve.tolerance_mm = kTolerancesMm[flags & 7];
  options.filter_artefacts = (flags & 8) != 0;
  options.scheme = (flags & 48) == 48 ? FitScheme::kPaper2002 : FitScheme::kFeltline;
  options.shared_samples = 1 + (flags >> 6);
  return options;
}

/// Returns `mm` if the readers accept it as a coordinate (its size is at most 1e9), otherwise 0.
double readable(double mm) {
  return std::fabs(mm) <= 1e9 ? mm : 0.0;
}

std::vector<InkSample> take_samples(Bytes& in) {
  std::vector<InkSample> samples;
  InkSample now;
  Vec pace;
  while (!in.empty() && samples.size() < kMaxSamples) {
    const std::uint8_t op = in.byte();
    int repeat = 1;
    switch (op & 7) {
      case 0:  // a small step
      case 1:
        pace = Vec{in.small() * 0.05, in.small() * 0.05};
        break;
      case 2:  // continue for some samples along a bend
        repeat = 1 + in.byte() % 64;
        break;
      case 3:  // stand still
        pace = {};
        repeat = 1 + in.byte() % 16;
        break;
      case 4:  // a jump
        now.position = {in.wide() * 0.5, in.wide() * 0.5};
        break;
      case 5:  // any position
        now.position = {readable(in.any_double()), readable(in.any_double())};
        break;
      case 6:
        now.pressure = in.byte() / 255.0;
        break;
      default:  // a change of time, possibly backwards
        now.time_ns = now.time_ns.value_or(0) + in.wide() * std::int64_t{1'000'000};
    }
    const double bend = ((op >> 3) - 16) * 0.01;
    for (int i = 0; i < repeat && samples.size() < kMaxSamples; ++i) {
      now.position = {readable(now.position.x + pace.x), readable(now.position.y + pace.y)};
      pace = pace + bend * perp(pace);
      samples.push_back(now);
    }
  }
  return samples;
}

/// Checks the parameter u of each sample: it is in [0, n], does not decrease from sample to sample,
/// and the curve at u is within the tolerance of the sample.
void check_samples_on_curve(const InkFitter& fitter, const InkFitOptions& options) {
  const FittedCurve& curve = fitter.curve();
  const ChunkedVector<InkSample>& samples = fitter.samples();
  FELT_CHECK(curve.sample_u.size() == samples.size());
  if (options.scheme != FitScheme::kFeltline) return;  // the paper's scheme has no error bound
  const double tolerance_mm = std::max(options.curve.tolerance_mm, kMinSegmentMm);
  double last_u = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double u = curve.sample_u[i];
    FELT_CHECK(u >= last_u && u <= curve.segment_count());
    last_u = u;
    const int segment = std::min(static_cast<int>(u), curve.segment_count() - 1);
    const Cubic cubic = curve.segment(segment);
    double size_mm = 0.0;
    for (const Point p : cubic.p) size_mm = std::max({size_mm, std::fabs(p.x), std::fabs(p.y)});
    const double rounding_mm = 1e-9 * tolerance_mm + 16e-16 * size_mm;
    const Point on_curve = evaluate(cubic, u - segment);
    FELT_CHECK(distance(on_curve, samples[i].position) <= tolerance_mm + rounding_mm);
  }
}

/// Checks that the stable prefix never changes once it was returned.
class PrefixWatch {
 public:
  void look(const InkFitter& fitter) {
    const auto known = static_cast<int>(segments_.size());
    FELT_CHECK(fitter.segment_count() >= known);
    for (int i = 0; i < known; ++i) {
      FELT_CHECK(fitter.segment(i) == segments_[static_cast<std::size_t>(i)]);
      FELT_CHECK(i == 0 || fitter.joint(i) == joints_[static_cast<std::size_t>(i)]);
    }
    for (int i = known; i < fitter.segment_count(); ++i) {
      segments_.push_back(fitter.segment(i));
      joints_.push_back(i == 0 ? JointKind::kEnd : fitter.joint(i));
    }
  }

 private:
  std::vector<Cubic> segments_;
  std::vector<JointKind> joints_;  // the joint before each segment
};

StrokeData finished(const InkFitter& fitter) {
  const Result<Stroke> stroke = fitter.stroke();
  FELT_CHECK(stroke.has_value());
  FELT_CHECK(check_invariants(stroke->data()).has_value());
  return stroke->data();
}

void run(const InkFitOptions& options, std::span<const InkSample> samples) {
  InkFitter fitter(options), silent(options);
  PrefixWatch watch;
  fitter.begin();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    fitter.push(samples[i]);
    if (i % 16 == 0) watch.look(fitter);
    for (const Cubic& live : fitter.live_tail()) FELT_CHECK(is_finite(live.p[3]));
  }
  fitter.end();
  watch.look(fitter);
  check_samples_on_curve(fitter, options);
  const StrokeData online = finished(fitter);
  fitter.refine();
  check_samples_on_curve(fitter, options);
  const StrokeData refined = finished(fitter);
  FELT_CHECK(refined.points.size() <= online.points.size());

  // A fitter that was used before, and that is not queried between the samples, gives the same
  // result.
  silent.begin();
  silent.push(samples.back());
  silent.begin();
  for (const InkSample& sample : samples) silent.push(sample);
  silent.end();
  FELT_CHECK(finished(silent) == online);
  silent.refine();
  FELT_CHECK(finished(silent) == refined);
}

}  // namespace
}  // namespace felt

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  felt::Bytes in(data, size);
  const felt::InkFitOptions options = felt::take_options(in);
  const std::vector<felt::InkSample> samples = felt::take_samples(in);
  if (!samples.empty()) felt::run(options, samples);
  return 0;
}
