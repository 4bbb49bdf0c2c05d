#include "felt/devices/simulated/stylus_presets.h"

#include <array>

#include "felt/driver/device_models.h"

namespace felt {
namespace {

constexpr std::array<SimulatedHand, 4> kHands{{
    {.name = "light", .mass_kg = 0.0, .stiffness_n_per_m = 30.0, .damping_n_s_per_m = 0.3},
    {.name = "soft", .mass_kg = 0.02, .stiffness_n_per_m = 100.0, .damping_n_s_per_m = 1.0},
    {.name = "typical", .mass_kg = 0.03, .stiffness_n_per_m = 300.0, .damping_n_s_per_m = 3.0},
    {.name = "firm", .mass_kg = 0.05, .stiffness_n_per_m = 800.0, .damping_n_s_per_m = 8.0},
}};

constexpr double kOverlapMm = 10.0;

// Returns `device` with a workspace of this size, at the position that stylus_presets() describes.
constexpr Capabilities with_workspace(Vec3 size_mm, Capabilities device) {
  device.workspace_min = {-kOverlapMm, -kOverlapMm, -0.5 * size_mm.z};
  device.workspace_max = device.workspace_min + size_mm;
  return device;
}

// These convert a workspace from the axes of a model. In both cases the page is upright in front of
// the user.
constexpr Vec3 as_axes_are(const Vec3& size) {
  return size;
}
constexpr Vec3 depth_first(const Vec3& size) {
  return {size.y, size.z, size.x};
}

// Returns the capabilities of a model of device_models().
Capabilities of_model(std::string_view id, Vec3 (*turn)(const Vec3&) = as_axes_are) noexcept {
  const Capabilities& device = find_device_model(id)->capabilities;
  return with_workspace(turn(device.workspace_max - device.workspace_min), device);
}

// Returns `rest`, with the mass and friction of a model of device_models().
StylusMechanics mechanics_of(std::string_view id, StylusMechanics rest = {}) noexcept {
  const Capabilities& device = find_device_model(id)->capabilities;
  rest.mass_kg = device.mass_kg;
  rest.friction_n = device.friction_n;
  return rest;
}

// Returns the capabilities of an invented device that is as weak as the Touch and harder to keep
// stable than any real device. Its advised force, limits and step are chosen so that a light pen
// without friction is exposed to every force that the safety chain lets pass.
Capabilities of_worst() noexcept {
  Capabilities device = of_model("touch");
  device.advised_force_n = 3.0;
  device.max_stiffness_n_per_m = 1000.0;
  device.max_damping_n_s_per_m = 5.0;
  device.position_step_mm = 0.03;
  device.friction_n = 0.0;
  return device;
}

// Returns the capabilities of a joystick as its driver reports them (evdev): the lever or the
// button on its grip is its pressure, and the height of its pen follows from the pressure.
Capabilities of_joystick() noexcept {
  Capabilities device = find_device_model("ff-stick")->capabilities;
  const Vec3 shift{-kOverlapMm - device.workspace_min.x, -kOverlapMm - device.workspace_min.y, 0.0};
  device.workspace_min += shift;
  device.workspace_max += shift;
  device.position_step_mm = 0.09;  // 10 bits over 90 mm
  device.senses_pressure = true;
  return device;
}

constexpr Vec3 kBigPageMm{2000.0, 2000.0, 200.0};
constexpr Capabilities kMouse = with_workspace(kBigPageMm, {.sensed_axes = 2, .actuated_axes = 0});

// The devices of the paper beside the PHANToM.
StylusPreset delta() noexcept {
  return {.name = "delta",
          .label = "Force Dimension delta.3",
          .source = "forces, workspace: CHAI3D's table; steps, mass, friction: estimate",
          .mechanics = mechanics_of("delta.3"),
          .capabilities = of_model("delta.3", depth_first)};
}

StylusPreset hapticmaster() noexcept {
  return {.name = "hapticmaster",
          .label = "Moog HapticMASTER",
          .source =
              "virtual mass, its friction, 4 ms: docs/devices/hapticmaster.md; force, stiffness: "
              "public programs; steps, workspace: estimate",
          .mechanics = mechanics_of("hapticmaster"),
          .capabilities = of_model("hapticmaster"),
          .force_hold_ns = find_device_model("hapticmaster")->capabilities.period_ns};
}

StylusPreset joystick() noexcept {
  return {
      .name = "joystick",
      .label = "Joystick with force feedback",
      .source = "axes, delay: docs/devices/joysticks.md; forces, steps, mass, friction: estimate",
      .mechanics = {.mass_kg = 0.15, .friction_n = 0.2, .viscous_n_s_per_m = 0.5},
      .capabilities = of_joystick(),
      .has_trigger = true};
}

StylusPreset vibrating_mouse() noexcept {
  return {.name = "vibrating-mouse",
          .label = "Mouse that vibrates (Logitech iFeel MouseMan)",
          .source = "docs/devices/haptic-pens.md; no figures needed",
          .mechanics = {},
          .capabilities = kMouse,
          .plays_cues = true};
}

const std::array<StylusPreset, 13>& presets() noexcept {
  static const std::array<StylusPreset, 13> kPresets{{
      {.name = "worst",
       .label = "Worst case: light, frictionless, coarse",
       .source = "docs/design/simulation.md#devices; forces as the touch",
       .mechanics = {.mass_kg = 0.045, .weight_n = 0.1},
       .capabilities = of_worst()},
      {.name = "touch",
       .label = "3D Systems Touch (Phantom Omni)",
       .source =
           "forces: CHAI3D's table, maker's data sheet; mass, friction, steps, workspace: estimate",
       .mechanics = mechanics_of("touch", {.weight_n = 0.1}),
       .capabilities = of_model("touch")},
      {.name = "touch-x",
       .label = "3D Systems Touch X (Phantom Desktop)",
       .source = "forces: CHAI3D's table; the rest: estimate",
       .mechanics = mechanics_of("touch-x", {.weight_n = 0.1}),
       .capabilities = of_model("touch-x")},
      {.name = "premium",
       .label = "Phantom Premium 1.5",
       .source = "forces: CHAI3D's table; steps: the 2002 paper; mass, friction: estimate",
       .mechanics = mechanics_of("premium-1.5", {.weight_n = 0.05}),
       .capabilities = of_model("premium-1.5")},
      {.name = "falcon",
       .label = "Novint Falcon",
       .source = "forces, workspace: CHAI3D's table; mass, friction, steps, continuous: estimate",
       .mechanics = mechanics_of("falcon", {.viscous_n_s_per_m = 0.5, .weight_n = 0.3}),
       .capabilities = of_model("falcon")},
      {.name = "omega",
       .label = "Force Dimension omega.3",
       .source = "forces: CHAI3D's table; steps, workspace, mass, friction: estimate",
       .mechanics = mechanics_of("omega.3"),
       .capabilities = of_model("omega.3", depth_first)},
      {.name = "inverse3",
       .label = "Haply Inverse3",
       .source = "stiffness: the maker's tutorials; the rest: estimate",
       .mechanics = mechanics_of("inverse3", {.weight_n = 0.1}),
       .capabilities = of_model("inverse3")},
      delta(),
      hapticmaster(),
      joystick(),
      {.name = "mouse",
       .label = "Mouse: no force, no pressure",
       .source = "no figures needed",
       .mechanics = {},
       .capabilities = kMouse},
      vibrating_mouse(),
      {.name = "tablet",
       .label = "Tablet: pressure, no force",
       .source = "no figures needed",
       .mechanics = {},
       .capabilities = with_workspace(
           kBigPageMm, {.sensed_axes = 2, .actuated_axes = 0, .senses_pressure = true})},
  }};
  return kPresets;
}

}  // namespace

std::span<const StylusPreset> stylus_presets() noexcept {
  return presets();
}

const StylusPreset* find_stylus_preset(std::string_view name) noexcept {
  for (const StylusPreset& preset : presets()) {
    if (preset.name == name) return &preset;
  }
  return nullptr;
}

void center_workspace(Capabilities& device, Point middle_mm) noexcept {
  const Vec3 middle = 0.5 * (device.workspace_min + device.workspace_max);
  const Vec3 shift{middle_mm.x - middle.x, middle_mm.y - middle.y, 0.0};
  device.workspace_min += shift;
  device.workspace_max += shift;
}

std::span<const SimulatedHand> simulated_hands() noexcept {
  return kHands;
}

const SimulatedHand* find_hand(std::string_view name) noexcept {
  for (const SimulatedHand& hand : kHands) {
    if (hand.name == name) return &hand;
  }
  return nullptr;
}

const SimulatedHand& typical_hand() noexcept {
  return kHands[2];
}

}  // namespace felt
