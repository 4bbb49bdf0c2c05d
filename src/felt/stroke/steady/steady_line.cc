#include "felt/stroke/steady/steady_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/stroke/steady/line_shaking.h"

namespace felt {
namespace {

constexpr double kMinStepS = 1e-4;
constexpr double kUsualStepS = 0.0075;
/// Standard deviations of the jerk, see ShakeModel. Chosen like the parameters of ShakeFilter.
constexpr std::array<double, 3> kJerks = {1200.0, 8000.0, 52800.0};
/// Divides the logarithms of likelihoods, because the models are simpler than hands are, so the
/// likelihood is surer than it should be.
constexpr double kTemper = 3.0;
/// Memory of the estimate of how much shaking there is now.
constexpr double kShareMemoryS = 0.4;
/// Intended jerks between which the share that is removed at pen-up falls from all to nothing.
constexpr double kSlowJerk = 33000.0, kFastJerk = 50000.0;

/// Returns the share of the shaking that can be told from an intended motion of this jerk.
double share_of_slow(double jerk_mm_per_s3) noexcept {
  const double fast = std::log(jerk_mm_per_s3 / kSlowJerk) / std::log(kFastJerk / kSlowJerk);
  return 1.0 - std::clamp(fast, 0.0, 1.0);
}

/// Returns the weights that belong to logarithms of likelihoods; their sum is 1.
template <class Weights>
Weights weights_of(const Weights& log_likelihood) noexcept {
  const double most = *std::max_element(log_likelihood.begin(), log_likelihood.end());
  Weights weights{};
  double sum = 0.0;
  for (std::size_t m = 0; m < weights.size(); ++m) {
    weights[m] = std::exp((log_likelihood[m] - most) / kTemper);
    sum += weights[m];
  }
  for (double& weight : weights) weight /= sum;
  return weights;
}

/// Makes the older of two sums fade over a step.
template <class Weights>
void fade_and_add(Weights& sum, const Weights& next, double dt_s) noexcept {
  const double left = std::exp(-dt_s / SteadyLine::kMemoryS);
  for (std::size_t m = 0; m < sum.size(); ++m) sum[m] = left * sum[m] + next[m];
}

}  // namespace

SteadyLine::SteadyLine(const Shake& shake)
    : amplitude_mm_(std::clamp(shake.amplitude_mm, Shake::kMinAmplitudeMm, Shake::kMaxAmplitudeMm)),
      axis_{std::cos(shake.axis_deg * std::numbers::pi / 180.0),
            std::sin(shake.axis_deg * std::numbers::pi / 180.0)},
      hz_(shake.hz),
      ring_(kMaxHeld) {
  for (std::size_t m = 0; m < kModels; ++m) {
    const double hz = shake.hz + kDriftHz * (static_cast<double>(m % 3) - 1.0);
    const double swing = amplitude_mm_ / std::numbers::sqrt2;
    filters_[m] = {ShakeFilter({hz, swing, kJerks[m / 3]}),
                   ShakeFilter({hz, kAcross * swing, kJerks[m / 3]})};
  }
  begin();
}

void SteadyLine::begin() noexcept {
  raw_.clear();
  steps_s_.clear();
  settled_ = 0;
  held_s_ = 0.0;
  recent_ = {};
  removed_mm2_ = 0.5 * amplitude_mm_ * amplitude_mm_ * (1.0 + kAcross * kAcross);
  share_ = 1.0;
  out_.clear();
  shown_.clear();
}

Vec SteadyLine::to_axes(Vec v) const noexcept {
  return {dot(v, axis_), cross(axis_, v)};
}

Point SteadyLine::on_page(Vec along_axes) const noexcept {
  const Vec across{-axis_.y, axis_.x};
  return raw_[0].position + along_axes.x * axis_ + along_axes.y * across;
}

Point SteadyLine::without_shaking(Point pen, Vec estimate, double share) const noexcept {
  const Vec shaking = on_page(estimate) - pen;
  const double size = norm(shaking), limit = kMaxMove * amplitude_mm_;
  return pen + (size > limit ? share * limit / size : share) * shaking;
}

double SteadyLine::step_s(const InkSample& sample) const noexcept {
  const auto& before = raw_.back().time_ns;
  if (!sample.time_ns || !before) return kUsualStepS;
  // Computed in double, because the difference of two invalid times may overflow 64 bits.
  const double s = 1e-9 * (static_cast<double>(*sample.time_ns) - static_cast<double>(*before));
  return std::clamp(s, kMinStepS, kMaxStepS);
}

double SteadyLine::share_of(double squared_mm2) const noexcept {
  const double expected = amplitude_mm_ * std::sqrt(0.5 * (1.0 + kAcross * kAcross));
  const double x = std::clamp(
      (std::sqrt(squared_mm2) / expected - kNoShare) / (kFullShare - kNoShare), 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

std::span<const InkSample> SteadyLine::push(const InkSample& sample) {
  out_.clear();
  if (!is_in_range(sample.position)) return out_;
  const bool is_first = raw_.empty();
  const double dt_s = is_first ? 0.0 : step_s(sample);
  raw_.push_back(sample);
  steps_s_.push_back(dt_s);
  const Vec y = to_axes(sample.position - raw_[0].position);
  Held& held = held_at(raw_.size() - 1);
  std::array<ShakeStep, 3> steps;
  for (std::size_t f = 0; f < steps.size(); ++f) {
    steps[f] = shake_step(filters_[f][0].model().hz, dt_s);
  }
  Weights next{};
  for (std::size_t m = 0; m < kModels; ++m) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      ShakeFilter& filter = filters_[m][axis];
      const double position = axis == 0 ? y.x : y.y;
      ShakeFilter::Record& record = held.records[m][axis];
      record = is_first ? filter.begin(position) : filter.push(position, steps[m % 3]);
      next[m] += ShakeFilter::log_likelihood(record);
    }
  }
  fade_and_add(recent_, next, dt_s);
  held_s_ += dt_s;
  update_tip(held, dt_s);
  const std::size_t count = raw_.size() - settled_;
  if (held_s_ >= kTailS + kGroupS || count == kMaxHeld) revise(count);
  return out_;
}

void SteadyLine::update_tip(const Held& held, double dt_s) {
  const Weights weights = weights_of(recent_);
  Vec estimate;
  for (std::size_t m = 0; m < kModels; ++m) {
    estimate += weights[m] * Vec{held.records[m][0].position, held.records[m][1].position};
  }
  const Point pen = raw_.back().position;
  const Vec removed = to_axes(pen - raw_[0].position) - estimate;
  // A jump of the pen is not shaking.
  const double squared = std::min(norm_squared(removed), 4.0 * amplitude_mm_ * amplitude_mm_);
  removed_mm2_ += (1.0 - std::exp(-dt_s / kShareMemoryS)) * (squared - removed_mm2_);
  share_ = share_of(removed_mm2_);
  tip_ = without_shaking(pen, estimate, share_);
}

/// Estimates the held samples into shown_, and settles those that are older than the tail.
void SteadyLine::revise(std::size_t count) {
  shown_.clear();
  const Weights weights = weights_of(recent_);
  std::array<Vec, kMaxHeld> sum{};
  for (std::size_t m = 0; m < kModels; ++m) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      ShakeFilter::Adjoint adjoint{};
      for (std::size_t i = count; i-- > 0;) {
        const double position =
            weights[m] * ShakeFilter::smooth(held_at(settled_ + i).records[m][axis], adjoint);
        (axis == 0 ? sum[i].x : sum[i].y) += position;
      }
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    InkSample sample = raw_[settled_ + i];
    sample.position = without_shaking(sample.position, sum[i], share_);
    shown_.push_back(sample);
  }
  // The newest sample of a group is at most one tail behind the pen. One sample always stays.
  std::size_t due = 0;
  while (due + 1 < count && (held_s_ > kTailS || count - due == kMaxHeld)) {
    out_.push_back(shown_[due]);
    ++due;
    held_s_ -= steps_s_[settled_ + due];
  }
  settled_ += due;
}

std::span<const InkSample> SteadyLine::held() {
  out_.clear();
  const std::size_t first = settled_;
  const std::size_t count = raw_.size() - first;
  if (count == 0) return {};
  const double held_s = held_s_;
  revise(count);
  settled_ = first;
  held_s_ = held_s;
  out_.clear();
  return shown_;
}

std::vector<InkSample> SteadyLine::smoothed() const {
  std::vector<InkSample> samples = raw_.to_vector();
  if (samples.empty()) return samples;
  std::vector<Vec> positions;
  positions.reserve(samples.size());
  for (const InkSample& sample : samples) {
    positions.push_back(to_axes(sample.position - samples[0].position));
  }
  const double swing = amplitude_mm_ / std::numbers::sqrt2;
  const LineShaking found =
      find_line_shaking(positions, steps_s_.to_vector(), {hz_, {swing, kAcross * swing}});
  double squared = 0.0;
  for (const Vec& v : found.shaking_mm) squared += norm_squared(v);
  const double share =
      share_of(squared / static_cast<double>(samples.size())) * share_of_slow(found.jerk_mm_per_s3);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].position =
        without_shaking(samples[i].position, positions[i] - found.shaking_mm[i], share);
  }
  return samples;
}

SampleFaults steady_samples(SteadyLine& line, std::vector<InkSample>& samples) {
  SampleFaults before;
  before.has_no_clock = drop_bad_times(samples);
  before.needs_times = true;
  line.begin();
  for (const InkSample& sample : samples) line.push(sample);
  samples = line.smoothed();
  return before;
}

}  // namespace felt
