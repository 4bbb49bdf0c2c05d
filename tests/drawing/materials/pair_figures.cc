#include "tests/drawing/materials/pair_figures.h"

#include <algorithm>
#include <cmath>

#include "felt/devices/simulated/stroke_forces.h"
#include "felt/haptics/bricks/drawing_feel.h"
#include "tests/devices/stability/stability_cell.h"
#include "tests/drawing/materials/feel_features.h"

namespace felt {
namespace {

constexpr double kPressN = 0.8;  // the safety chain allows this force on a touch for a long time

// Returns the peak force of the texture alone: the difference between a stroke and the same stroke
// on the same surface without grain.
double texture_peak_n(StrokePlan plan, bool& is_sound) {
  constexpr double kShortestMm = 0.8, kLongestMm = 9.0;
  const auto peak = [&] {
    const StrokeForces forces = draw_stroke(plan);
    is_sound = is_sound && forces.is_sound;
    const auto of = [&](const std::vector<Force>& leg) {
      return texture_of(leg, forces.period_s, plan.speed_mm_per_s, kShortestMm, kLongestMm).peak_n;
    };
    return std::max(of(forces.along_x), of(forces.along_y));
  };
  const double with = peak();
  plan.has_grain = false;
  const double without = peak();
  return std::sqrt(std::max(0.0, with * with - without * without));
}

}  // namespace

PairFigures claimed_figures(const StylusPreset& device, std::int64_t period_ns,
                            const SurfaceMaterial& surface, const Medium& tool) {
  Capabilities can = device.capabilities;
  can.period_ns = period_ns;
  const HeightField* grain = surface_grain(surface);
  const Slopes slopes = make_surface_force(surface, tool, can, grain).slopes();
  const double budget = stiffness_budget_n_per_m(can);
  PairFigures figures;
  figures.budget_share =
      std::max(slopes.normal_n_per_m, slopes.friction_n_per_m + slopes.lateral_n_per_m) / budget;
  const double period_s = 1e-9 * static_cast<double>(period_ns);
  const FrictionOptions friction = friction_for(tool, surface, can);
  const Texture texture(grain, {.strength = tool.grain,
                                .friction = friction.coefficient,
                                .bristle_n_per_m = friction.stiffness_n_per_m,
                                .period_s = period_s});
  figures.texture_n_per_m = texture.stiffness_n_per_m();
  figures.texture_limit_n_per_m = texture_stiffness_limit_n_per_m(period_s);
  return figures;
}

PairFigures measured_figures(const StylusPreset& device, std::int64_t period_ns,
                             const SurfaceMaterial& surface, const Medium& tool) {
  PairFigures figures = claimed_figures(device, period_ns, surface, tool);
  for (const SimulatedHand& hand : simulated_hands()) {
    const StabilityResult rest = run_trial({.trial = Trial::kRest,
                                            .device = &device,
                                            .hand = &hand,
                                            .delay_ticks = 1,
                                            .period_ns = period_ns,
                                            .surface = &surface,
                                            .tool = &tool});
    figures.rest_n = std::max(figures.rest_n, rest.high_frequency_n);
    figures.is_sound = figures.is_sound && rest.finite && rest.fault == SafetyFault::kNone;
  }
  if (surface_grain(surface) == nullptr) return figures;
  for (std::size_t i = 0; i < kBandSpeeds.size(); ++i) {
    figures.band_n[i] = texture_peak_n({.device = &device,
                                        .hand = &typical_hand(),
                                        .period_ns = period_ns,
                                        .surface = &surface,
                                        .tool = &tool,
                                        .speed_mm_per_s = kBandSpeeds[i],
                                        .press_n = kPressN},
                                       figures.is_sound);
  }
  return figures;
}

std::vector<DeviceLoop> device_loops() {
  std::vector<DeviceLoop> loops;
  for (const StylusPreset& device : stylus_presets()) {
    // A loop of 250 Hz renders no texture; the delta is the omega with more mass and friction.
    if (!device.renders_surface() || device.force_hold_ns > 0 || device.name == "delta") continue;
    for (const std::int64_t period_ns : {1'000'000, 200'000}) loops.push_back({&device, period_ns});
  }
  return loops;
}

std::string name_of(const DeviceLoop& loop) {
  return std::string(loop.device->name) + ", " + std::to_string(1'000'000 / loop.period_ns) +
         " kHz";
}

bool is_felt(const PairFigures& figures) noexcept {
  return std::all_of(figures.band_n.begin(), figures.band_n.end(),
                     [](double band_n) { return band_n >= kFeltForceN; });
}

std::vector<PairFigures> measured_figures(const DeviceLoop& loop, const SurfaceMaterial& surface) {
  std::vector<PairFigures> figures;
  for (const Medium& tool : media()) {
    figures.push_back(measured_figures(*loop.device, loop.period_ns, surface, tool));
  }
  return figures;
}

std::string name_of_pair(const Medium& tool, const SurfaceMaterial& surface) {
  return tool.id + " on " + surface.id;
}

std::vector<std::string> listed(const std::string& report, std::string_view block) {
  const std::string begin = "```" + std::string(block) + "\n";
  constexpr std::string_view kEnd = "```";
  std::vector<std::string> lines;
  for (std::size_t at = report.find(begin); at != std::string::npos; at = report.find(begin, at)) {
    at += begin.size();
    while (at < report.size() && report.compare(at, kEnd.size(), kEnd) != 0) {
      const std::size_t end = report.find('\n', at);
      if (end == std::string::npos) return lines;
      lines.push_back(report.substr(at, end - at));
      at = end + 1;
    }
  }
  return lines;
}

}  // namespace felt
