#include "felt/stroke/fit/ink_fitter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "felt/stroke/fit/curve_fitter.h"
#include "felt/stroke/fit/paper_fitter.h"
#include "felt/stroke/fit/pen_filter.h"
#include "felt/stroke/fit/refine.h"
#include "felt/stroke/fit/sample_faults.h"
#include "felt/stroke/fit/width_fitter.h"
#include "felt/stroke/fit/width_map.h"

namespace felt {
namespace {

bool is_ink(const InkSample& sample) {
  return is_in_range(sample.position);
}

}  // namespace

struct InkFitter::State {
  explicit State(const InkFitOptions& o)
      : options(o),
        filter(o.filter),
        online(o.curve),
        refiner(o.curve),
        paper(o.curve, std::max(0, o.shared_samples)) {}

  void take(const InkSample& sample) {
    samples.push_back(sample);
    if (options.scheme == FitScheme::kPaper2002) {
      paper.push(sample.position);
    } else {
      online.push(sample.position);
    }
  }

  [[nodiscard]] Result<Stroke> stroke(const FittedCurve& fitted, const WidthMapOptions& widths,
                                      const WidthFitOptions& limits) const;

  InkFitOptions options;
  PenFilter filter;
  CurveFitter online;
  Refiner refiner;
  PaperFitter paper;
  ChunkedVector<InkSample> samples;
  SampleCheck check;
  std::size_t ignored = 0;
  bool ended = false;
  // True if `curve` is valid. It is made on the first request after end(), because copying a long
  // stroke takes longer than the time between two samples.
  bool has_curve = false;
  FittedCurve curve;
  std::vector<Cubic> tail;
};

InkFitter::InkFitter(const InkFitOptions& options) : state_(std::make_unique<State>(options)) {
  begin();
}
InkFitter::~InkFitter() = default;
InkFitter::InkFitter(InkFitter&&) noexcept = default;
InkFitter& InkFitter::operator=(InkFitter&&) noexcept = default;

void InkFitter::begin() {
  State& s = *state_;
  s.filter.begin();
  s.online.begin();
  s.paper.begin();
  s.samples.clear();
  s.check.begin();
  s.ignored = 0;
  s.ended = false;
  s.has_curve = false;
}

void InkFitter::copy_stroke(const InkFitter& other) {
  State& s = *state_;
  const State& from = *other.state_;
  s.filter = from.filter;
  s.online = from.online;
  s.paper = from.paper;
  s.samples = from.samples;
  s.check = from.check;
  s.ignored = from.ignored;
  s.ended = from.ended;
  s.has_curve = from.has_curve;
  if (s.has_curve) s.curve = from.curve;
}

void InkFitter::push(const InkSample& reported) {
  State& s = *state_;
  if (!is_ink(reported)) {
    ++s.ignored;
    return;
  }
  s.check.add(reported);
  const InkSample sample = with_valid_pressure(reported);
  if (!s.options.filter_artefacts) {
    s.take(sample);
    return;
  }
  for (const InkSample& ink : s.filter.push(sample)) s.take(ink);
}

void InkFitter::end() {
  State& s = *state_;
  if (s.options.filter_artefacts) {
    for (const InkSample& ink : s.filter.end()) s.take(ink);
  }
  s.ended = true;
  if (s.options.scheme == FitScheme::kPaper2002) {
    s.paper.end();
  } else {
    s.online.end();
  }
}

void InkFitter::refine() {
  State& s = *state_;
  if (!s.ended || s.options.scheme == FitScheme::kPaper2002 || segment_count() < 2) return;
  s.refiner.begin();
  for (const InkSample& sample : s.samples) s.refiner.push(sample.position);
  s.refiner.follow(curve());
  FittedCurve refined = s.refiner.end();
  const int count = refined.segment_count();
  if (count == 0 || count >= segment_count()) return;
  s.curve = std::move(refined);
  s.has_curve = true;
}

int InkFitter::segment_count() const {
  const State& s = *state_;
  if (s.has_curve) return s.curve.segment_count();
  return s.options.scheme == FitScheme::kPaper2002 ? s.paper.curve().segment_count()
                                                   : s.online.segment_count();
}

Cubic InkFitter::segment(int i) const {
  const State& s = *state_;
  if (s.has_curve) return s.curve.segment(i);
  return s.options.scheme == FitScheme::kPaper2002 ? s.paper.curve().segment(i)
                                                   : s.online.segment(i);
}

JointKind InkFitter::joint(int i) const {
  const State& s = *state_;
  const auto k = static_cast<std::size_t>(i - 1);
  if (s.has_curve) return s.curve.joints[k];
  return s.options.scheme == FitScheme::kPaper2002 ? s.paper.curve().joints[k] : s.online.joint(i);
}

const ChunkedVector<SamplePlace>& InkFitter::places() const {
  return state_->online.places();
}

std::span<const Cubic> InkFitter::live_tail() {
  State& s = *state_;
  s.tail.clear();
  if (s.ended) return s.tail;
  if (s.options.scheme == FitScheme::kFeltline) {
    s.online.append_live_tail(s.tail);
  } else if (!s.paper.curve().points.empty() && !s.samples.empty()) {
    s.tail.push_back(straight(s.paper.curve().points.back(), s.samples.back().position));
  }
  if (s.options.filter_artefacts) {
    const auto held = s.filter.held();
    if (held.empty()) return s.tail;
    // The held samples are shown even before the first sample is ink, because a pen that touches
    // must leave a mark.
    Point at = s.samples.empty() ? held.front().position : s.samples.back().position;
    for (const InkSample& sample : held) {
      s.tail.push_back(straight(at, sample.position));
      at = sample.position;
    }
  }
  return s.tail;
}

const ChunkedVector<InkSample>& InkFitter::samples() const {
  return state_->samples;
}

std::size_t InkFitter::ignored_count() const {
  return state_->ignored;
}

const FittedCurve& InkFitter::curve() const {
  State& s = *state_;
  if (!s.has_curve) {
    if (s.options.scheme == FitScheme::kPaper2002) {
      s.curve = s.paper.curve();
    } else {
      s.online.copy_to(s.curve);
    }
    s.has_curve = s.ended;
  }
  return s.curve;
}

SampleFaults InkFitter::faults() const {
  SampleFaults faults = state_->check.faults();
  faults.needs_times = faults.needs_times || state_->options.filter_artefacts;
  return faults;
}

Result<Stroke> InkFitter::stroke() const {
  return state_->stroke(curve(), state_->options.width_map, state_->options.width);
}

Result<Stroke> InkFitter::stroke(const WidthMapOptions& widths) const {
  WidthFitOptions limits = state_->options.width;
  limits.max_mm = std::max(limits.max_mm, widths.max_mm * std::max(1.0, widths.tilt_width));
  return state_->stroke(curve(), widths, limits);
}

Result<Stroke> InkFitter::State::stroke(const FittedCurve& fitted, const WidthMapOptions& widths,
                                        const WidthFitOptions& limits) const {
  if (fitted.points.empty()) {
    return fail(ErrorCode::kInvalidData, ignored > 0 ? "none of the samples has usable coordinates"
                                                     : "the stroke has no samples");
  }
  WidthMap map(widths);
  WidthFitter width(limits);
  map.begin();
  width.begin();
  const bool has_no_clock = check.faults().has_no_clock;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    InkSample sample = samples[i];
    if (has_no_clock) sample.time_ns.reset();
    const InkWidth ink = map.push(sample);
    if (widths.tone) {
      width.push(fitted.sample_u[i], ink.width_mm, ink.tone);
    } else {
      width.push(fitted.sample_u[i], ink.width_mm);
    }
  }
  width.finish(fitted.segment_count());
  StrokeData data;
  data.points = fitted.points;
  data.joints = fitted.joints;
  data.widths.assign(width.knots().begin(), width.knots().end());
  data.medium = options.medium;
  return Stroke::create(std::move(data));
}

}  // namespace felt
