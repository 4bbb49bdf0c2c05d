#include "felt/studies/trial_setup.h"

#include <span>
#include <string>
#include <utility>

#include "felt/session/session.h"
#include "felt/stroke/color_text.h"
#include "felt/studies/erased_page.h"
#include "felt/studies/measured_trial.h"
#include "felt/tools/guide_line.h"

namespace felt {
namespace {

constexpr const char* kPlaneOnly = "surface.plane_only";

SetOption option_of(const StudySetting& setting) {
  return {setting.id,
          std::visit([](const auto& value) { return OptionValue(value); }, setting.value)};
}

Result<void> check_settings(const StudyCondition& condition, const Materials& materials,
                            const Capabilities& device, const std::string& name) {
  Session probe(make_tools(), {.device = device, .materials = materials});
  for (const StudySetting& setting : condition.settings) {
    if (setting.id == kPlaneOnly) {
      return fail(ErrorCode::kInvalidArgument,
                  name + ":" + std::to_string(setting.line) + ": condition.settings: " +
                      setting.id + ": condition.forces decides it: \"plane\" or \"all\"");
    }
    const Result<void> set = probe.apply({0, option_of(setting)});
    if (set) continue;
    return tl::unexpected(with_context(set.error(), name + ":" + std::to_string(setting.line) +
                                                        ": condition.settings: " + setting.id));
  }
  return {};
}

/// Adds the pen of the teacher while it touched the surface: at most kMaxGuidePoints points, each
/// later than the one before.
void add_teacher(std::span<const TrialSample> teacher, GuideLine& line) {
  std::vector<TrialSample> touching;
  for (const TrialSample& sample : teacher) {
    const bool is_later = touching.empty() || sample.time_ns > touching.back().time_ns;
    if (sample.contact && is_later) touching.push_back(sample);
  }
  const std::size_t step = touching.size() / kMaxGuidePoints + 1;
  for (std::size_t i = 0; i < touching.size(); i += step) {
    line.points.push_back(touching[i].position);
    line.times_ms.push_back(1e-6 * static_cast<double>(touching[i].time_ns - touching[0].time_ns));
  }
}

/// The line of the task `retrace` is as broad and almost as light as the lines that the program
/// shows for other tasks, so that the ink of the participant can be told from it.
constexpr double kRetracedMm = 0.8;
constexpr const char* kRetracedColor = "#c0c2c6";
constexpr const char* kInkColor = "ink.color";

/// Adds the ink at the start of a trial. New ink has the colour of the condition afterwards.
void add_start_ink(const StudyFiles& files, const PlannedTrial& trial, Rgba ink,
                   std::vector<Event>& events) {
  const bool is_retraced = files.study.shapes[trial.shape].task == StudyTask::kRetrace;
  if (is_retraced) events.push_back({0, SetOption{kInkColor, std::string(kRetracedColor)}});
  for (AddLine& line : ink_at_start(files, trial)) events.push_back({0, std::move(line)});
  if (!is_retraced) return;
  SetOption color{kInkColor, color_to_text(ink)};
  for (const StudySetting& setting : files.study.conditions[trial.condition].settings) {
    if (setting.id == kInkColor) color = option_of(setting);
  }
  events.push_back({0, std::move(color)});
}

GuideLine guide_of(const StudyFiles& files, const PlannedTrial& trial) {
  const StudyCondition& condition = files.study.conditions[trial.condition];
  const StudyPath& path = files.paths[trial.shape];
  GuideLine line{.strength = condition.strength};
  switch (condition.guidance) {
    case StudyGuidance::kNone:
      return {};
    case StudyGuidance::kReplayedTeacher:
      line.kind = GuideKind::kTeacher;
      add_teacher(files.teachers[trial.condition], line);
      return line;
    case StudyGuidance::kGroove:
      line.kind = GuideKind::kGroove;
      break;
    case StudyGuidance::kAsNeeded:
      line.kind = GuideKind::kAsNeeded;
      break;
    case StudyGuidance::kErrorAmplifying:
      line.kind = GuideKind::kErrorAmplifying;
      break;
  }
  line.points = path.points;
  line.is_closed = path.ends == TrialPathEnds::kClosed;
  return line;
}

}  // namespace

Result<void> check_conditions(const StudyFiles& files, const Materials& materials,
                              const Capabilities& device, const std::string& name) {
  for (std::size_t i = 0; i < files.study.conditions.size(); ++i) {
    const StudyCondition& condition = files.study.conditions[i];
    const std::string place = name + ":" + std::to_string(condition.line) + ": ";
    if (condition.guidance != StudyGuidance::kNone && !device.has_force()) {
      return fail(ErrorCode::kUnsupported,
                  place + "condition.guidance is \"" +
                      std::string(kStudyGuidances[static_cast<std::size_t>(condition.guidance)]) +
                      "\", but the device has no forces");
    }
    if (condition.needs == DeviceNeed::kForce && !device.has_force()) {
      return fail(ErrorCode::kUnsupported,
                  place + "condition.needs is \"force\", but the device has no forces");
    }
    Result<void> set = check_settings(condition, materials, device, name);
    if (!set) return set;
    for (std::size_t shape = 0; shape < files.paths.size(); ++shape) {
      const PlannedTrial trial{.condition = i, .shape = shape};
      const Result<void> guided = check_guide(guide_of(files, trial));
      if (guided) continue;
      return tl::unexpected(with_context(
          guided.error(),
          place + "condition.guidance of the shape \"" + files.study.shapes[shape].name + "\""));
    }
  }
  return {};
}

std::vector<AddLine> ink_at_start(const StudyFiles& files, const PlannedTrial& trial) {
  const StudyPath& path = files.paths[trial.shape];
  switch (files.study.shapes[trial.shape].task) {
    case StudyTask::kRetrace:
      return {{path.points, path.ends == TrialPathEnds::kClosed, kRetracedMm}};
    case StudyTask::kErase: {
      ErasedPage page = erased_page_of(files, trial);
      std::vector<AddLine> lines = {{std::move(page.line), false, kErasedInkMm}};
      for (std::vector<Point>& line : page.others) {
        lines.push_back({std::move(line), false, kErasedInkMm});
      }
      return lines;
    }
    default:
      return {};
  }
}

std::vector<Event> setup_events(const StudyFiles& files, const PlannedTrial& trial,
                                const Capabilities& device, Rgba ink) {
  const StudyCondition& condition = files.study.conditions[trial.condition];
  std::vector<Event> events = {{0, UseDevice{device}}};
  for (const StudySetting& setting : condition.settings) {
    events.push_back({0, option_of(setting)});
  }
  if (condition.forces == StudyForces::kPlane) {
    events.push_back({0, SetOption{kPlaneOnly, OptionValue(true)}});
  }
  GuideLine guide = guide_of(files, trial);
  if (guide.kind != GuideKind::kNone) events.push_back({0, UseGuide{std::move(guide)}});
  add_start_ink(files, trial, ink, events);
  if (files.study.shapes[trial.shape].task == StudyTask::kErase) {
    events.push_back({0, SelectTool{"eraser"}});
  }
  return events;
}

}  // namespace felt
