#include "replay_settings.h"

#include <cmath>

namespace felt::cli {
namespace {

/// Half of it, in mm; beyond the largest place that a script can name.
constexpr double kEndlessMm = 1e10;

}  // namespace

ReplaySettings replay_settings(const StylusPreset& device, const SimulatedHand& hand, bool force,
                               std::optional<double> rate_hz, std::optional<int> delay_ticks) {
  ReplaySettings settings{.device = device, .hand = hand, .force = force, .script = {}};
  Capabilities& can = settings.device.capabilities;
  can.workspace_min.x = can.workspace_min.y = -kEndlessMm;
  can.workspace_max.x = can.workspace_max.y = kEndlessMm;
  if (rate_hz) can.period_ns = std::llround(1e9 / *rate_hz);
  if (delay_ticks) can.delay_ticks = *delay_ticks;
  settings.script = script_options_for(settings.device, hand);
  if (!force) {
    settings.script.contact = ContactBy::kPressure;
    can.senses_pressure = true;
  }
  return settings;
}

}  // namespace felt::cli
