#include "desktop/materials/force_probe.h"

#include <algorithm>
#include <cmath>

#include "felt/devices/simulated/stroke_forces.h"
#include "felt/haptics/bricks/drawing_feel.h"

namespace felt::desktop {
namespace {

constexpr auto kStandIn = "touch";
constexpr double kRunUpMm = 20.0;  // distance after which the pen moves evenly
constexpr double kRestS = 0.3;
constexpr std::size_t kPoints = 400;

/// Returns the drag along the last kLengthMm in kPoints steps. Each step has the maximum of its
/// range, so that every peak is included.
std::vector<double> drag_of(const StrokeForces& forces) {
  const double mm_per_tick = ProbeFigures::kSpeedMmPerS * forces.period_s;
  const auto wanted = static_cast<std::size_t>(ProbeFigures::kLengthMm / mm_per_tick);
  const std::size_t count = std::min(wanted, forces.along_x.size());
  const std::size_t first = forces.along_x.size() - count;
  std::vector<double> drag;
  for (std::size_t point = 0; point < std::min(kPoints, count); ++point) {
    const std::size_t points = std::min(kPoints, count);
    const std::size_t from = first + point * count / points;
    const std::size_t until = first + (point + 1) * count / points;
    double largest = 0.0;
    for (std::size_t i = from; i < until; ++i) largest = std::max(largest, -forces.along_x[i].x);
    drag.push_back(largest);
  }
  return drag;
}

/// Returns the share of the relief's height that the texture can render. A low relief is rendered
/// completely.
double grain_share_of(const ProbeRequest& request, const Capabilities& device,
                      const HeightField* grain) {
  if (!grain || !(request.medium.grain > 0.0)) return 1.0;
  const FrictionOptions friction = friction_for(request.medium, request.surface, device);
  const auto stiffness = [&](double height_share) {
    const HeightField field =
        grain->scaled(request.surface.grain_mm, height_share * request.surface.grain_um);
    return Texture(&field, {.strength = request.medium.grain,
                            .friction = friction.coefficient,
                            .bristle_n_per_m = friction.stiffness_n_per_m,
                            .period_s = 1e-9 * static_cast<double>(device.period_ns)})
        .stiffness_n_per_m();
  };
  // With this share of the height no limit applies, and the stiffness is proportional to the
  // height.
  constexpr double kLow = 1e-3;
  const double free = stiffness(kLow) / kLow;
  return free > 0.0 ? std::clamp(stiffness(1.0) / free, 0.0, 1.0) : 1.0;
}

}  // namespace

Capabilities probe_device(const Capabilities& device) {
  return device.has_force() ? device : find_stylus_preset(kStandIn)->capabilities;
}

/// Stiffness and budget come from the force model itself. Drag and tremble come from a stroke of
/// the simulated hand, which consists of a run-up, then kLengthMm at constant speed, and a rest.
ProbeFigures probe_figures(const ProbeRequest& request) {
  StylusPreset device = *find_stylus_preset(kStandIn);
  device.capabilities = probe_device(request.device);
  // Uses the device's own workspace, because the figures do not depend on its position on the
  // page.
  const Capabilities& can = device.capabilities;
  const HeightField* grain = surface_grain(request.surface);
  const Slopes slopes = make_surface_force(request.surface, request.medium, can, grain).slopes();
  ProbeFigures figures;
  figures.stiffness_n_per_m = plane_for(request.surface, can).stiffness_n_per_m;
  figures.budget_share =
      std::max(slopes.normal_n_per_m, slopes.friction_n_per_m + slopes.lateral_n_per_m) /
      stiffness_budget_n_per_m(can);
  figures.grain_share = grain_share_of(request, can, grain);
  const StrokeForces forces = draw_stroke({.device = &device,
                                           .hand = &typical_hand(),
                                           .period_ns = can.period_ns,
                                           .surface = &request.surface,
                                           .tool = &request.medium,
                                           .speed_mm_per_s = ProbeFigures::kSpeedMmPerS,
                                           .press_n = ProbeFigures::kPressN,
                                           .leg_mm = kRunUpMm + ProbeFigures::kLengthMm,
                                           .rest_s = kRestS});
  figures.rest_n = force_above_30_hz_n(forces.resting, forces.period_s);
  figures.is_sound = forces.is_sound;
  figures.drag_n = drag_of(forces);
  for (double& newton : figures.drag_n) newton *= request.strength;
  return figures;
}

ForceProbe::ForceProbe(QObject* parent) : QObject(parent) {
  worker_.setMaxThreadCount(1);
}

ForceProbe::~ForceProbe() = default;

void ForceProbe::ask(const ProbeRequest& request) {
  if (has_asked_ && request == wanted_) return;
  wanted_ = request;
  has_asked_ = true;
  if (is_busy_) {
    is_stale_ = true;
  } else {
    start();
  }
}

void ForceProbe::start() {
  is_busy_ = true;
  is_stale_ = false;
  worker_.start([this, request = wanted_] {
    const ProbeFigures figures = probe_figures(request);
    QMetaObject::invokeMethod(
        this,
        [this, figures] {
          is_busy_ = false;
          const bool is_old = is_stale_;
          if (is_old) start();
          // While the user drags a slider, slightly outdated figures are better than no figures.
          Q_EMIT figured(figures);
        },
        Qt::QueuedConnection);
  });
}

}  // namespace felt::desktop
