#include "felt/store/felt_recording.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "felt/document/drawing.h"
#include "felt/geometry/tilt.h"
#include "felt/store/felt_extras.h"
#include "felt/store/felt_file.h"

namespace felt {
namespace {

double on_grid(double n) noexcept {
  if (!std::isfinite(n)) return 0.0;
  const double largest = kMaxRecordedForceN / kRecordedForceStepN;
  return kRecordedForceStepN * std::round(std::clamp(n / kRecordedForceStepN, -largest, largest));
}

Force on_grid(const Force& f) noexcept {
  return {on_grid(f.x), on_grid(f.y), on_grid(f.z)};
}

bool is_place(const Vec3& p) noexcept {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

FeltRecorder::FeltRecorder(std::string device, std::int64_t period_ns) {
  recording_.device = std::move(device);
  recording_.period_ns = period_ns;
}

void FeltRecorder::event(const Event& event) {
  // An event that arrived while samples waited in the ring may have a later time than these
  // samples. The times of such samples are raised to that of the event, so that times never run
  // backwards.
  last_ns_ = std::max(last_ns_, event.time_ns);
  if (const auto* pen = std::get_if<PenEvent>(&event.what)) {
    recording_.samples.push_back({last_ns_, *pen, std::nullopt});
    return match();
  }
  recording_.events.push_back({recording_.samples.size(), event});
  recording_.events.back().event.time_ns = last_ns_;
}

void FeltRecorder::forces(std::int64_t time_ns, const Force& asked, const Force& sent) {
  ticks_.push_back({time_ns, {on_grid(asked), on_grid(sent)}});
  match();
}

/// Gives each sample the forces of the tick with the same time. Samples arrive in the order of
/// their times, and so do ticks. A tick may arrive before or after its sample.
void FeltRecorder::match() {
  while (unmatched_ < recording_.samples.size() && next_tick_ < ticks_.size()) {
    RecordedSample& sample = recording_.samples[unmatched_];
    const Tick& tick = ticks_[next_tick_];
    if (tick.time_ns == sample.time_ns) sample.forces = tick.forces;
    if (tick.time_ns <= sample.time_ns) ++next_tick_;
    if (tick.time_ns >= sample.time_ns) ++unmatched_;
  }
  if (next_tick_ == ticks_.size()) {
    ticks_.clear();
    next_tick_ = 0;
  }
}

FeltRecording FeltRecorder::take() {
  ticks_.clear();
  unmatched_ = next_tick_ = 0;
  last_ns_ = 0;
  FeltRecording fresh;
  fresh.device = recording_.device;
  fresh.period_ns = recording_.period_ns;
  return std::exchange(recording_, std::move(fresh));
}

Result<void> play_recording(const FeltRecording& recording,
                            const std::function<Result<void>(const Event&)>& report) {
  auto event = recording.events.begin();
  for (std::size_t i = 0; i <= recording.samples.size(); ++i) {
    for (; event != recording.events.end() && event->before_sample == i; ++event) {
      if (auto ok = report(event->event); !ok) return ok;
    }
    if (i == recording.samples.size()) break;
    const RecordedSample& sample = recording.samples[i];
    if (auto ok = report({sample.time_ns, sample.pen}); !ok) return ok;
  }
  return {};
}

Result<void> add_recording(Drawing& drawing, FeltRecording recording) {
  if (auto ok = check_recording(recording); !ok) return ok;
  const auto extras = std::make_shared<FeltExtras>(felt_extras(drawing));
  extras->added.push_back(std::make_shared<const FeltRecording>(std::move(recording)));
  drawing.extras = extras;
  return {};
}

Result<void> check_recording(const FeltRecording& recording) {
  const auto bad = [](const char* what, std::size_t i) {
    return fail(ErrorCode::kInvalidData, std::string(what) + " " + std::to_string(i));
  };
  std::int64_t last_ns = 0;
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    const RecordedSample& s = recording.samples[i];
    const double pressure = s.pen.pressure.value_or(0.0);
    if (s.time_ns < std::exchange(last_ns, s.time_ns))
      return bad("the time decreases at sample", i);
    const double tilt_deg = s.pen.tilt_deg.value_or(0.0);
    if (!is_place(s.pen.position) || !(pressure >= 0.0 && pressure <= 1.0) ||
        !(tilt_deg >= 0.0 && tilt_deg <= kMaxTiltDeg)) {
      return bad("invalid numbers in sample", i);
    }
  }
  std::size_t at = 0;
  for (std::size_t i = 0; i < recording.events.size(); ++i) {
    const RecordedEvent& e = recording.events[i];
    if (e.before_sample < std::exchange(at, e.before_sample) ||
        e.before_sample > recording.samples.size() ||
        std::holds_alternative<PenEvent>(e.event.what)) {
      return bad("not in order: event", i);
    }
  }
  return {};
}

}  // namespace felt
