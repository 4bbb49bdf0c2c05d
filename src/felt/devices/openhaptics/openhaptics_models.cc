#include "felt/devices/openhaptics/openhaptics_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "felt/base/ascii.h"
#include "felt/base/constants.h"

namespace felt {
namespace {

constexpr double kLargestMm = 2000.0;  // largest plausible coordinate of a workspace
constexpr double kSmallestMm = 10.0;   // smallest plausible side of a workspace

struct Word {
  std::string_view word;  // lower case
  std::string_view model;
};

// The first row that matches is used. "Geomagic Touch X" contains the words of two rows, so longer
// words come first.
constexpr std::array kWords{Word{"touch x", "touch-x"}, Word{"touchx", "touch-x"},
                            Word{"touch", "touch"},     Word{"omni", "omni"},
                            Word{"desktop", "desktop"}, Word{"premium 3", "premium-3.0"},
                            Word{"3.0", "premium-3.0"}, Word{"premium", "premium-1.5"}};

bool contains(std::string_view text, std::string_view lower_word) noexcept {
  return std::search(text.begin(), text.end(), lower_word.begin(), lower_word.end(),
                     [](char a, char b) { return ascii_lower(a) == b; }) != text.end();
}

// Returns the lower of two limits. Ignores a limit that is missing or invalid.
double lesser(double row, double said) noexcept {
  if (!std::isfinite(said) || said <= 0.0) return row;
  return row > 0.0 ? std::min(row, said) : said;
}

bool is_workspace(std::span<const double, 6> box) noexcept {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(std::abs(box[i]) <= kLargestMm && std::abs(box[i + 3]) <= kLargestMm)) return false;
    if (!(box[i + 3] - box[i] >= kSmallestMm)) return false;
  }
  return true;
}

}  // namespace

const DeviceModel& openhaptics_model(std::string_view model_type) noexcept {
  for (const Word& known : kWords) {
    if (!contains(model_type, known.word)) continue;
    if (const DeviceModel* model = find_device_model(known.model)) return *model;
  }
  return generic_device_model();
}

Capabilities openhaptics_capabilities(const Capabilities& row, const HdLimits& said) noexcept {
  Capabilities device = row;
  device.max_force_n = lesser(row.max_force_n, said.max_force_n);
  device.continuous_force_n = lesser(row.continuous_force_n, said.continuous_force_n);
  device.max_stiffness_n_per_m =
      lesser(row.max_stiffness_n_per_m, kMmPerM * said.max_stiffness_n_per_mm);
  device.max_damping_n_s_per_m =
      lesser(row.max_damping_n_s_per_m, kMmPerM * said.max_damping_n_s_per_mm);
  if (is_workspace(said.usable_mm)) {
    device.workspace_min = {said.usable_mm[0], said.usable_mm[1], said.usable_mm[2]};
    device.workspace_max = {said.usable_mm[3], said.usable_mm[4], said.usable_mm[5]};
  }
  if (said.update_rate_hz >= 250 && said.update_rate_hz <= 5000) {
    device.period_ns = 1'000'000'000 / said.update_rate_hz;
  }
  return device;
}

PlaneCalibration openhaptics_plane(const Capabilities& device) noexcept {
  const std::array rows{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, 1, 0}};
  const Vec3 middle = 0.5 * (device.workspace_min + device.workspace_max);
  const Vec3 offset{-dot(rows[0], middle), -dot(rows[1], middle), -dot(rows[2], middle)};
  return PlaneCalibration::from(rows, offset).value_or(PlaneCalibration{});
}

}  // namespace felt
