#include "felt/studies/measured_trial.h"

#include <algorithm>

#include "felt/base/hash.h"
#include "felt/base/random.h"
#include "felt/document/visible_strokes.h"
#include "felt/geometry/rect.h"
#include "felt/session/event.h"
#include "felt/stroke/outline/outline.h"
#include "felt/studies/erased_page.h"
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

constexpr double kInkToleranceMm = 1e-3;

/// Returns a stroke as a polyline with a point at each knot of its width.
InkLine ink_line(const Stroke& stroke) {
  std::vector<double> us = {0.0};
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const int steps = flatten_steps(stroke.segment(i), 1.0, kInkToleranceMm);
    for (int k = 1; k <= steps; ++k) us.push_back(i + static_cast<double>(k) / steps);
  }
  for (const WidthKnot& knot : stroke.widths()) us.push_back(knot.u);
  std::sort(us.begin(), us.end());
  us.erase(std::unique(us.begin(), us.end()), us.end());
  InkLine line;
  line.is_closed = stroke.closed();
  for (const double u : us) {
    line.points.push_back(stroke.position(u));
    line.widths_mm.push_back(stroke.width_mm(u));
  }
  return line;
}

/// Moves samples in contact from the pen to the nib behind the stabiliser of a recording. Only the
/// pencil has a stabiliser.
class NibTrack {
 public:
  void set_tool(const std::string& tool) { is_pencil_ = tool == "pencil"; }
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
      nib_ = Stabiliser(is_pencil_ ? options_ : StabiliserOptions{});
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
  bool is_pencil_ = true;
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
      const auto* tool = std::get_if<SelectTool>(&recording.events[next].event.what);
      if (tool) nib.set_tool(tool->id);
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

ErasedPage erased_page_of(const StudyFiles& files, const PlannedTrial& trial) {
  Fnv1a parts;
  parts.add_value(files.study.seed);
  parts.add_value(trial.session);
  for (const int part : {trial.block, static_cast<int>(trial.shape), trial.repetition}) {
    parts.add_value(part);
  }
  Random random(parts.value());
  const std::vector<Point>& line = files.paths[trial.shape].points;
  const Vec whole = line.back() - line.front();
  return erased_page(lerp(line.front(), line.back(), 0.5), normalized(whole), norm(whole), random);
}

TrialMetrics measure_recorded_trial(const StudyFiles& files, const PlannedTrial& trial,
                                    std::span<const TrialSample> samples) {
  if (files.study.shapes[trial.shape].task == StudyTask::kErase) return measure_trial(samples, {});
  return measure_trial(samples, compared_path(files, trial, samples).points,
                       geometry_of(files, trial));
}

TrialMetrics measure_recorded_trial(const StudyFiles& files, const PlannedTrial& trial,
                                    std::span<const TrialSample> samples, const Document& page) {
  TrialMetrics metrics = measure_recorded_trial(files, trial, samples);
  std::vector<InkLine> ink;
  for (const StrokePtr& stroke : visible_strokes(page)) ink.push_back(ink_line(*stroke));
  const StudyShape& shape = files.study.shapes[trial.shape];
  if (shape.task == StudyTask::kClose) measure_closing(ink, metrics);
  if (shape.task == StudyTask::kWidth) measure_width(ink, shape.width_mm, metrics);
  if (shape.task == StudyTask::kErase) {
    measure_erasing(erased_page_of(files, trial), ink, metrics);
  }
  return metrics;
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
