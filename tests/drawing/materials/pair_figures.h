#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "felt/devices/simulated/stylus_presets.h"
#include "felt/material/materials.h"

namespace felt {

/// A device with motors and how fast its loop runs.
struct DeviceLoop {
  const StylusPreset* device = nullptr;
  std::int64_t period_ns = 1'000'000;
};
/// Every simulated device with motors, at 1 kHz and at 5 kHz.
std::vector<DeviceLoop> device_loops();
/// "touch, 1 kHz"
std::string name_of(const DeviceLoop& loop);

/// A tool on a surface in the hand, on a device at a loop period (R47, R48).
struct PairFigures {
  double budget_share = 0.0;   ///< largest sum of stiffnesses along an axis, of what it bears
  double texture_n_per_m = 0;  ///< stiffest place of the texture
  double texture_limit_n_per_m = 0;
  double rest_n = 0.0;             ///< rms above 30 Hz of a pen that rests: worst of four hands
  std::array<double, 3> band_n{};  ///< peak of the texture at 50, 100 and 150 mm/s, along x or y
  bool is_sound = true;            ///< the safety chain found nothing wrong
};

inline constexpr std::array<double, 3> kBandSpeeds{50.0, 100.0, 150.0};
inline constexpr double kFeltForceN = 0.04;  ///< the least that is perceived

/// What is claimed, at once: all but rest_n and band_n.
PairFigures claimed_figures(const StylusPreset& device, std::int64_t period_ns,
                            const SurfaceMaterial& surface, const Medium& tool);
/// All of it, measured with the simulated hand pressing 0.8 N.
PairFigures measured_figures(const StylusPreset& device, std::int64_t period_ns,
                             const SurfaceMaterial& surface, const Medium& tool);

/// Is the texture felt at each of the speeds?
bool is_felt(const PairFigures& figures) noexcept;

/// The same for every medium on this surface.
std::vector<PairFigures> measured_figures(const DeviceLoop& loop, const SurfaceMaterial& surface);

/// "pencil on rough-paper"
std::string name_of_pair(const Medium& tool, const SurfaceMaterial& surface);

/// What stands line by line in the fenced blocks of that name.
std::vector<std::string> listed(const std::string& report, std::string_view block);

}  // namespace felt
