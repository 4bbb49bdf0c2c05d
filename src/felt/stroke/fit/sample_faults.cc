#include "felt/stroke/fit/sample_faults.h"

#include <algorithm>
#include <cmath>

namespace felt {

void SampleCheck::Range::extend(double value) noexcept {
  low = is_empty ? value : std::min(low, value);
  high = is_empty ? value : std::max(high, value);
  is_empty = false;
}

void SampleCheck::add(const InkSample& sample) noexcept {
  ++faults_.samples;
  if (const std::optional<double> p = sample.pressure; p && !std::isnan(*p)) {
    const auto beyond = [](double v) { return std::max(-v, v - 1.0); };
    if (beyond(*p) > kPressureSlack) {
      const bool is_first = faults_.bad_pressures++ == 0;
      if (is_first || beyond(*p) > beyond(faults_.farthest_pressure)) {
        faults_.farthest_pressure = *p;
      }
    }
    pressures_.extend(std::clamp(*p, 0.0, 1.0));
  }
  if (sample.tilt_deg && !std::isnan(*sample.tilt_deg)) tilts_.extend(*sample.tilt_deg);
  if (sample.time_ns) add_time(*sample.time_ns);
}

void SampleCheck::add_time(std::int64_t time_ns) noexcept {
  if (last_time_ns_) {
    // In double, because the difference of two arbitrary times may not fit into 64 bits.
    const double step_ns = static_cast<double>(time_ns) - static_cast<double>(*last_time_ns_);
    ++steps_;
    if (step_ns < 0.0) ++faults_.backward_times;
    forward_ms_ += std::max(0.0, step_ns) * 1e-6;
  }
  last_time_ns_ = time_ns;
}

SampleFaults SampleCheck::faults() const noexcept {
  SampleFaults result = faults_;
  const bool is_too_fast = forward_ms_ < kMinIntervalMs * static_cast<double>(steps_);
  result.has_no_clock = steps_ > 0 && (is_too_fast || 4 * result.backward_times >= steps_);
  result.needs_times = pressures_.low < pressures_.high || tilts_.low < tilts_.high;
  return result;
}

InkSample with_valid_pressure(InkSample sample) noexcept {
  if (!sample.pressure) return sample;
  if (std::isnan(*sample.pressure)) {
    sample.pressure.reset();
  } else {
    sample.pressure = std::clamp(*sample.pressure, 0.0, 1.0);
  }
  return sample;
}

bool drop_bad_times(std::span<InkSample> samples) noexcept {
  SampleCheck check;
  for (const InkSample& sample : samples) check.add(sample);
  if (!check.faults().has_no_clock) return false;
  for (InkSample& sample : samples) sample.time_ns.reset();
  return true;
}

SampleFaults combined_faults(SampleFaults of_fit, const SampleFaults& before) noexcept {
  of_fit.has_no_clock = of_fit.has_no_clock || before.has_no_clock;
  of_fit.needs_times = of_fit.needs_times || before.needs_times;
  return of_fit;
}

bool times_matter(const SampleFaults& faults) noexcept {
  constexpr std::size_t kMinTimed = 4;
  return faults.needs_times && faults.samples >= kMinTimed;
}

std::vector<std::string> fault_clauses(const SampleFaults& faults) {
  std::vector<std::string> clauses;
  if (faults.bad_pressures > 0) {
    clauses.emplace_back(
        "has pressures outside 0 to 1, which count as 0 or 1; divide them by the largest pressure "
        "of the pen");
  }
  if (!times_matter(faults)) return clauses;
  if (faults.has_no_clock) {
    clauses.emplace_back(
        "has times that are not milliseconds: they stand still, run backwards or hardly advance; "
        "they were ignored");
  } else if (faults.backward_times > 0) {
    clauses.emplace_back("has times that run backwards in places");
  }
  return clauses;
}

std::string name_with_faults(std::string name, const SampleFaults& faults) {
  if (faults.bad_pressures == 0) return name;
  // Pressures can be any double, but a whole number is enough to see the mistake.
  constexpr double kShown = 1e15;
  const double shown = std::clamp(faults.farthest_pressure, -kShown, kShown);
  std::string number = std::to_string(shown);
  number.erase(number.find_last_not_of('0') + 1);
  if (number.back() == '.') number.pop_back();
  return name + " (" + std::to_string(faults.bad_pressures) + " of " +
         std::to_string(faults.samples) + " pressures, for example " + number + ")";
}

}  // namespace felt
