#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/material/materials.h"

namespace felt {

/// A device with motors, and the rate of its loop.
struct DeviceLoop {
  const StylusPreset* device = nullptr;
  std::int64_t period_ns = 1'000'000;
};
/// Returns every simulated device with motors, at 1 kHz and at 5 kHz.
std::vector<DeviceLoop> device_loops();
/// Returns for example "touch, 1 kHz".
std::string name_of(const DeviceLoop& loop);

/// Figures of a medium on a surface, on a device with its loop period (R47, R48).
struct PairFigures {
  double budget_share = 0.0;   ///< largest sum of stiffnesses along an axis / budget of the device
  double texture_n_per_m = 0;  ///< largest stiffness of the texture
  double texture_limit_n_per_m = 0;
  double rest_n = 0.0;             ///< rms force above 30 Hz on a resting pen: worst of four hands
  std::array<double, 3> band_n{};  ///< peak of the texture at 50, 100 and 150 mm/s, along x or y
  bool is_sound = true;            ///< the safety chain reported no fault
};

inline constexpr std::array<double, 3> kBandSpeeds{50.0, 100.0, 150.0};
inline constexpr double kFeltForceN = 0.04;  ///< smallest force that a person feels

/// Returns the figures that the force models claim, without a simulation: all but rest_n and
/// band_n.
PairFigures claimed_figures(const StylusPreset& device, std::int64_t period_ns,
                            const SurfaceMaterial& surface, const Medium& tool);
/// Returns all figures. The simulated hand presses with 0.8 N.
PairFigures measured_figures(const StylusPreset& device, std::int64_t period_ns,
                             const SurfaceMaterial& surface, const Medium& tool);

/// Returns true if the texture is felt at each of the speeds.
bool is_felt(const PairFigures& figures) noexcept;

/// Returns the figures of every medium on this surface.
std::vector<PairFigures> measured_figures(const DeviceLoop& loop, const SurfaceMaterial& surface);

/// Returns for example "pencil on rough-paper".
std::string name_of_pair(const Medium& tool, const SurfaceMaterial& surface);

/// Returns the lines of all fenced blocks of `report` that have the name `block`.
std::vector<std::string> listed(const std::string& report, std::string_view block);

}  // namespace felt
