#include "felt/studies/measured_trial.h"

#include <algorithm>

#include "felt/geometry/rect.h"
#include "felt/session/session.h"

namespace felt {
namespace {

/// Returns true if an event switches a stabiliser on, so that the ink is not at the pen.
bool starts_stabiliser(const RecordedEvent& recorded) {
  const auto* option = std::get_if<SetOption>(&recorded.event.what);
  return option && option->id.ends_with(".stabiliser") && option->value != OptionValue("off");
}

TrialSample trial_sample(const RecordedSample& sample) {
  const PenSample pen = sample_of(sample.time_ns, sample.pen);
  TrialSample result{.time_ns = pen.time_ns,
                     .position = on_page(pen.position),
                     .contact = in_contact(pen),
                     .pressure = pen.pressure};
  if (sample.forces) result.force_n = Vec{sample.forces->sent.x, sample.forces->sent.y};
  return result;
}

}  // namespace

std::optional<Point> stabilised_nib(const Session& session) {
  if (session.tool().info().kind != ToolKind::kDraws) return std::nullopt;
  Overlay overlay;
  session.draw(overlay);
  const auto tether =
      std::find_if(overlay.lines.begin(), overlay.lines.end(),
                   [](const Overlay::Line& line) { return line.role == Overlay::Role::kTether; });
  return tether == overlay.lines.end() ? std::nullopt : std::optional(tether->to);
}

std::vector<TrialSample> trial_samples(const FeltRecording& recording) {
  std::vector<TrialSample> samples;
  samples.reserve(recording.samples.size());
  for (const RecordedSample& sample : recording.samples) samples.push_back(trial_sample(sample));
  const bool is_stabilised =
      std::any_of(recording.events.begin(), recording.events.end(), starts_stabiliser);
  if (!is_stabilised) return samples;
  Session session(make_tools(), {});
  std::size_t at = 0;
  (void)play_recording(recording, [&](const Event& event) -> Result<void> {
    // Events that the session refuses, such as imports, do not move the nib.
    (void)session.apply(event);
    if (!std::holds_alternative<PenEvent>(event.what)) return {};
    TrialSample& sample = samples[at++];
    if (sample.contact) sample.position = stabilised_nib(session).value_or(sample.position);
    return {};
  });
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
