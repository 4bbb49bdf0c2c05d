#include "felt/studies/trial_setup.h"

#include <string>

#include "felt/session/session.h"

namespace felt {
namespace {

SetOption option_of(const StudySetting& setting) {
  return {setting.id,
          std::visit([](const auto& value) { return OptionValue(value); }, setting.value)};
}

Result<void> check_settings(const StudyCondition& condition, const Materials& materials,
                            const Capabilities& device, const std::string& name) {
  Session probe(make_tools(), {.device = device, .materials = materials});
  for (const StudySetting& setting : condition.settings) {
    const Result<void> set = probe.apply({0, option_of(setting)});
    if (set) continue;
    return tl::unexpected(with_context(set.error(), name + ":" + std::to_string(setting.line) +
                                                        ": condition.settings: " + setting.id));
  }
  return {};
}

}  // namespace

Result<void> check_conditions(const Study& study, const Materials& materials,
                              const Capabilities& device, const std::string& name) {
  for (const StudyCondition& condition : study.conditions) {
    const std::string place = name + ":" + std::to_string(condition.line) + ": ";
    if (condition.guidance != StudyGuidance::kNone) {
      return fail(ErrorCode::kUnsupported,
                  place + "condition.guidance: this version cannot guide the pen yet");
    }
    if (condition.needs == DeviceNeed::kForce && !device.has_force()) {
      return fail(ErrorCode::kUnsupported,
                  place + "condition.needs is \"force\", but the device has no forces");
    }
    Result<void> set = check_settings(condition, materials, device, name);
    if (!set) return set;
  }
  return {};
}

std::vector<Event> setup_events(const StudyFiles& files, const PlannedTrial& trial,
                                const Capabilities& device) {
  std::vector<Event> events = {{0, UseDevice{device}}};
  for (const StudySetting& setting : files.study.conditions[trial.condition].settings) {
    events.push_back({0, option_of(setting)});
  }
  return events;
}

}  // namespace felt
