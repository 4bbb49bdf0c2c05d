#include "felt/studies/measured_trial.h"

#include <algorithm>

#include "felt/geometry/rect.h"
#include "felt/session/event.h"
#include "felt/tools/line_stabiliser.h"

namespace felt {
namespace {

TrialSample trial_sample(const RecordedSample& sample) {
  const PenSample pen = sample_of(sample.time_ns, sample.pen);
  TrialSample result{.time_ns = pen.time_ns,
                     .position = on_page(pen.position),
                     .contact = in_contact(pen),
                     .pressure = pen.pressure};
  if (!sample.forces) return result;  // a tablet or a mouse does not measure the height
  result.force_n = Vec{sample.forces->sent.x, sample.forces->sent.y};
  // A pen that presses sinks into a surface that yields; its ink does not.
  const double z = pen.position.z;
  result.height_mm = sample.forces->sent.z > 0.0 ? std::max(0.0, z) : z;
  return result;
}

/// Moves samples in contact from the pen to the nib behind the stabiliser of a recording.
class NibTrack {
 public:
  void set(const SetOption& option) {
    if (option.id == "pencil.stabiliser") {
      options_.kind = option.value == OptionValue("towed")     ? StabiliserKind::kTowed
                      : option.value == OptionValue("inertia") ? StabiliserKind::kInertia
                                                               : StabiliserKind::kOff;
    } else if (option.id == "pencil.stabiliser_length_mm") {
      options_.length_mm = std::get<double>(option.value);
    } else if (option.id == "pencil.stabiliser_mass_g") {
      options_.mass_g = std::get<double>(option.value);
    }
  }

  /// Appends a sample to `samples`; before the first sample out of contact, also the ink that is
  /// completed when the pen lifts.
  void add(TrialSample sample, std::vector<TrialSample>& samples) {
    const bool lands = sample.contact && (samples.empty() || !samples.back().contact);
    if (lands) {
      nib_ = Stabiliser(options_);
      nib_.begin(sample.position, sample.time_ns);
    } else if (sample.contact) {
      sample.position = nib_.update(sample.position, sample.time_ns);
    } else if (!samples.empty() && samples.back().contact) {
      nib_.finish(rest_);
      TrialSample last = samples.back();
      for (const Stabiliser::Step& step : rest_) {
        last.position = step.nib;
        last.time_ns = step.time_ns;
        samples.push_back(last);
      }
    }
    samples.push_back(sample);
  }

 private:
  StabiliserOptions options_;
  Stabiliser nib_;
  std::vector<Stabiliser::Step> rest_;
};

}  // namespace

std::vector<TrialSample> trial_samples(const FeltRecording& recording) {
  std::vector<TrialSample> samples;
  samples.reserve(recording.samples.size());
  NibTrack nib;
  std::size_t next = 0;  // event
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    for (; next < recording.events.size() && recording.events[next].before_sample <= i; ++next) {
      const auto* option = std::get_if<SetOption>(&recording.events[next].event.what);
      if (option) nib.set(*option);
    }
    nib.add(trial_sample(recording.samples[i]), samples);
  }
  return samples;
}

StudyPath compared_path(const StudyFiles& files, const PlannedTrial& trial,
                        std::span<const TrialSample> samples) {
  StudyPath path = files.paths[trial.shape];
  if (files.study.shapes[trial.shape].task != StudyTask::kCopy) return path;
  Rect ink, box;
  for (const TrialSample& sample : samples) {
    if (sample.contact) ink.extend(sample.position);
  }
  if (ink.empty()) return path;
  for (const Point p : path.points) box.extend(p);
  const Vec shift = middle_of(ink) - middle_of(box);
  for (Point& p : path.points) p = p + shift;
  return path;
}

TrialGeometry geometry_of(const StudyFiles& files, const PlannedTrial& trial) {
  const StudyShape& shape = files.study.shapes[trial.shape];
  TrialGeometry geometry{.ends = files.paths[trial.shape].ends};
  if (shape.task == StudyTask::kTunnel) geometry.tunnel_width_mm = shape.tunnel_mm;
  if (shape.task == StudyTask::kConnect) geometry.target_width_mm = kConnectTargetMm;
  return geometry;
}

TrialMetrics measure_recorded_trial(const StudyFiles& files, const PlannedTrial& trial,
                                    std::span<const TrialSample> samples) {
  return measure_trial(samples, compared_path(files, trial, samples).points,
                       geometry_of(files, trial));
}

std::string broken_rule(const CatchRules& rules, const TrialMetrics& metrics, double path_length_mm,
                        bool had_device_fault) {
  if (rules.device_fault && had_device_fault) return "device_fault";
  if (metrics.ink_length_mm.value_or(0.0) < rules.min_length_share * path_length_mm) {
    return "min_length_share";
  }
  if (rules.max_lifts && metrics.lifts.value_or(0.0) > *rules.max_lifts) return "max_lifts";
  if (rules.max_mm_per_s && metrics.speed_mean_mm_per_s.value_or(0.0) > *rules.max_mm_per_s) {
    return "max_mm_per_s";
  }
  if (rules.left_tunnel && metrics.out_of_tunnel_share.value_or(0.0) > 0.0) return "left_tunnel";
  return "";
}

}  // namespace felt
