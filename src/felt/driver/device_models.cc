#include "felt/driver/device_models.h"

#include <array>

namespace felt {
namespace {

// Returns `device` with a workspace of this size around its origin.
constexpr Capabilities in_box(Vec3 size_mm, Capabilities device) {
  device.workspace_min = -0.5 * size_mm;
  device.workspace_max = 0.5 * size_mm;
  return device;
}

// Returns `device` with the largest cube in this sphere as its workspace. The workspaces in
// CHAI3D's table are spheres, but ours is a box; every position in this cube can be reached.
constexpr Capabilities in_sphere(double radius_mm, const Capabilities& device) {
  const double side_mm = 2.0 * radius_mm / 1.7320508075688772;
  return in_box({side_mm, side_mm, side_mm}, device);
}

constexpr std::string_view k3DSystems = "3D Systems";
constexpr std::string_view kForceDimension = "Force Dimension";
constexpr std::string_view kHaply = "Haply";

constexpr Capabilities kOmni{.max_force_n = 3.3,
                             .continuous_force_n = 0.88,
                             .advised_force_n = 2.5,
                             .max_stiffness_n_per_m = 700.0,
                             .max_damping_n_s_per_m = 5.0,
                             .position_step_mm = 0.055,
                             .friction_n = 0.26,
                             .mass_kg = 0.045};
constexpr Capabilities kDesktop{.max_force_n = 7.9,
                                .continuous_force_n = 1.75,
                                .advised_force_n = 5.0,
                                .max_stiffness_n_per_m = 1000.0,
                                .max_damping_n_s_per_m = 5.0,
                                .position_step_mm = 0.023,
                                .friction_n = 0.06,
                                .mass_kg = 0.045};
constexpr Capabilities kOmega{.max_force_n = 12.0,
                              .continuous_force_n = 12.0,
                              .advised_force_n = 6.0,
                              .max_stiffness_n_per_m = 5000.0,
                              .max_damping_n_s_per_m = 30.0,
                              .position_step_mm = 0.01,
                              .friction_n = 0.05,
                              .mass_kg = 0.3,
                              .period_ns = 250'000};
// The continuous force of these devices is unknown; half of the peak is assumed.
constexpr Capabilities kSigma{.max_force_n = 12.0,
                              .continuous_force_n = 6.0,
                              .advised_force_n = 6.0,
                              .max_stiffness_n_per_m = 4000.0,
                              .max_damping_n_s_per_m = 30.0,
                              .position_step_mm = 0.01,
                              .period_ns = 250'000};
constexpr Capabilities kLambda{.max_force_n = 12.0,
                               .continuous_force_n = 6.0,
                               .advised_force_n = 6.0,
                               .max_stiffness_n_per_m = 8000.0,
                               .max_damping_n_s_per_m = 30.0,
                               .position_step_mm = 0.01,
                               .period_ns = 250'000};

constexpr Capabilities touch() {
  Capabilities device = kOmni;
  device.max_stiffness_n_per_m = 400.0;
  device.max_damping_n_s_per_m = 4.0;
  return in_box({160, 120, 70}, device);
}

constexpr Vec3 kOmegaBoxMm{110, 160, 160};  // depth, width, height

constexpr std::string_view kTouchSource =
    "peak, stiffness, damping: CHAI3D's table; continuous 0.88 N: read from a device with "
    "OpenHaptics; workspace, step, friction, mass: estimate";
constexpr std::string_view kDesktopSource =
    "peak, stiffness, damping: CHAI3D's table; continuous, workspace, step, friction, mass: "
    "estimate";
constexpr std::string_view kOmegaSource =
    "peak, stiffness, damping: CHAI3D's table; continuous, workspace, step, friction, mass: "
    "estimate";
constexpr std::string_view kSigmaSource =
    "peak, stiffness, damping, workspace: CHAI3D's table for the sigma.7; continuous, step: "
    "estimate";
constexpr std::string_view kLambdaSource =
    "peak, stiffness, damping, workspace: CHAI3D's table for the lambda.7; continuous, step: "
    "estimate";

constexpr std::array<DeviceModel, 23> kModels{{
    {.id = "touch",
     .label = "3D Systems Touch",
     .maker = k3DSystems,
     .capabilities = touch(),
     .source = kTouchSource},
    {.id = "touch-x",
     .label = "3D Systems Touch X",
     .maker = k3DSystems,
     .capabilities = in_box({160, 120, 120}, kDesktop),
     .source = kDesktopSource},
    {.id = "omni",
     .label = "SensAble PHANToM Omni",
     .maker = k3DSystems,
     .capabilities = in_box({160, 120, 70}, kOmni),
     .source = kTouchSource},
    {.id = "desktop",
     .label = "SensAble PHANToM Desktop",
     .maker = k3DSystems,
     .capabilities = in_box({160, 120, 120}, kDesktop),
     .source = kDesktopSource},
    {.id = "premium-1.5",
     .label = "SensAble PHANToM Premium 1.5",
     .maker = k3DSystems,
     .capabilities = in_box({381, 267, 191}, {.max_force_n = 8.5,
                                              .continuous_force_n = 1.4,
                                              .advised_force_n = 5.0,
                                              .max_stiffness_n_per_m = 800.0,
                                              .max_damping_n_s_per_m = 5.0,
                                              .position_step_mm = 0.03,
                                              .friction_n = 0.04,
                                              .mass_kg = 0.075}),
     .source = "peak, stiffness, damping: CHAI3D's table; continuous: a public mock of it; step: "
               "the 2002 paper; workspace: estimate"},
    {.id = "premium-3.0",
     .label = "SensAble PHANToM Premium 3.0",
     .maker = k3DSystems,
     .capabilities = in_sphere(250.0, {.max_force_n = 22.0,
                                       .continuous_force_n = 3.0,
                                       .advised_force_n = 8.0,
                                       .max_stiffness_n_per_m = 1000.0,
                                       .max_damping_n_s_per_m = 5.0,
                                       .position_step_mm = 0.02}),
     .source = "peak, stiffness, damping, workspace: CHAI3D's table; continuous, step: estimate"},
    {.id = "falcon",
     .label = "Novint Falcon",
     .maker = "Novint",
     .capabilities = in_box({80, 80, 80}, {.max_force_n = 8.0,
                                           .continuous_force_n = 2.5,
                                           .advised_force_n = 6.0,
                                           .max_stiffness_n_per_m = 3000.0,
                                           .max_damping_n_s_per_m = 20.0,
                                           .position_step_mm = 0.06,
                                           .friction_n = 0.4,
                                           .mass_kg = 0.15}),
     .source = "peak, stiffness, damping, workspace: CHAI3D's table; continuous, step: estimate"},
    {.id = "omega.3",
     .label = "Force Dimension omega.3",
     .maker = kForceDimension,
     .capabilities = in_box(kOmegaBoxMm, kOmega),
     .source = kOmegaSource},
    {.id = "omega.6",
     .label = "Force Dimension omega.6",
     .maker = kForceDimension,
     .capabilities = in_box(kOmegaBoxMm, kOmega),
     .source = kOmegaSource},
    {.id = "omega.7",
     .label = "Force Dimension omega.7",
     .maker = kForceDimension,
     .capabilities = in_box(kOmegaBoxMm, kOmega),
     .source = kOmegaSource},
    {.id = "delta.3",
     .label = "Force Dimension delta.3",
     .maker = kForceDimension,
     .capabilities = in_sphere(150.0, {.max_force_n = 20.0,
                                       .continuous_force_n = 20.0,
                                       .advised_force_n = 8.0,
                                       .max_stiffness_n_per_m = 5000.0,
                                       .max_damping_n_s_per_m = 30.0,
                                       .position_step_mm = 0.02,
                                       .friction_n = 0.1,
                                       .mass_kg = 0.4,
                                       .period_ns = 250'000}),
     .source = "peak, stiffness, damping, workspace: CHAI3D's table; continuous: hapticore's "
               "limit; step, friction, mass: estimate"},
    {.id = "sigma.3",
     .label = "Force Dimension sigma.3",
     .maker = kForceDimension,
     .capabilities = in_sphere(75.0, kSigma),
     .source = kSigmaSource},
    {.id = "sigma.7",
     .label = "Force Dimension sigma.7",
     .maker = kForceDimension,
     .capabilities = in_sphere(75.0, kSigma),
     .source = kSigmaSource},
    {.id = "lambda.3",
     .label = "Force Dimension lambda.3",
     .maker = kForceDimension,
     .capabilities = in_sphere(112.5, kLambda),
     .source = kLambdaSource},
    {.id = "lambda.6",
     .label = "Force Dimension lambda.6",
     .maker = kForceDimension,
     .capabilities = in_sphere(112.5, kLambda),
     .source = kLambdaSource},
    {.id = "lambda.7",
     .label = "Force Dimension lambda.7",
     .maker = kForceDimension,
     .capabilities = in_sphere(112.5, kLambda),
     .source = kLambdaSource},
    {.id = "inverse3",
     .label = "Haply Inverse3",
     .maker = kHaply,
     .capabilities = in_box({115, 115, 115}, {.max_force_n = 10.0,
                                              .continuous_force_n = 3.0,
                                              .advised_force_n = 3.0,
                                              .max_stiffness_n_per_m = 1000.0,
                                              .max_damping_n_s_per_m = 5.0,
                                              .position_step_mm = 0.02,
                                              .friction_n = 0.05,
                                              .mass_kg = 0.12}),
     .source = "stiffness: the maker's tutorials, workspace: the cube in their sphere of 0.1 m; "
               "the rest: estimate"},
    {.id = "minverse",
     .label = "Haply Minverse",
     .maker = kHaply,
     .capabilities = in_sphere(40.0, {.max_force_n = 3.0,
                                      .continuous_force_n = 1.0,
                                      .advised_force_n = 2.0,
                                      .max_stiffness_n_per_m = 1000.0,
                                      .max_damping_n_s_per_m = 5.0,
                                      .position_step_mm = 0.02}),
     .source = "stiffness, workspace: the maker's tutorials; the rest: estimate, low on purpose"},
    {.id = "2diy",
     .label = "Haply 2DIY",
     .maker = kHaply,
     // The workspace is the range of its two arms of 50 and 70 mm, in front of the motors.
     .capabilities = {.sensed_axes = 2,
                      .actuated_axes = 2,
                      .max_force_n = 2.0,
                      .continuous_force_n = 1.0,
                      .advised_force_n = 1.5,
                      .max_stiffness_n_per_m = 400.0,
                      .max_damping_n_s_per_m = 1.0,
                      .workspace_min = {-45.0, 45.0, 0.0},
                      .workspace_max = {45.0, 100.0, 0.0},
                      .position_step_mm = 0.04},
     .source = "arms, encoders: Haply's public code; forces, caps, step: estimate"},
    {.id = "ff-stick",
     .label = "Joystick with force feedback",
     .maker = "",
     .capabilities = {.sensed_axes = 2,
                      .actuated_axes = 2,
                      .max_force_n = 10.0,
                      .continuous_force_n = 1.0,
                      .advised_force_n = 1.5,
                      .max_stiffness_n_per_m = 200.0,
                      .max_damping_n_s_per_m = 1.0,
                      .workspace_min = {-45.0, -45.0, -2.0},
                      .workspace_max = {45.0, 45.0, 0.8},
                      .delay_ticks = 7},
     .source = "of a strong one, at the grip; all of it estimates, asked for is little"},
    {.id = "ff-wheel",
     .label = "Wheel with force feedback",
     .maker = "",
     .capabilities = {.sensed_axes = 1,
                      .actuated_axes = 1,
                      .max_force_n = 60.0,
                      .continuous_force_n = 1.0,
                      .advised_force_n = 1.5,
                      .max_stiffness_n_per_m = 200.0,
                      .max_damping_n_s_per_m = 1.0,
                      .workspace_min = {-120.0, -1.0, -2.0},
                      .workspace_max = {120.0, 1.0, 0.8},
                      .delay_ticks = 7},
     .source = "8 N m at a rim of 0.14 m, the strongest that are sold; an estimate"},
    {.id = "generic-3dof",
     .label = "Force device with three axes",
     .maker = "",
     .capabilities = in_box({80, 80, 80}, {.max_force_n = 3.0,
                                           .continuous_force_n = 0.88,
                                           .advised_force_n = 2.0,
                                           .max_stiffness_n_per_m = 400.0,
                                           .max_damping_n_s_per_m = 4.0}),
     .source = "the smallest limits of the other models; an estimate"},
    {.id = "hapticmaster",
     .label = "Moog HapticMASTER",
     .maker = "Moog",
     // A tick is two round trips over a network, so the loop has its longest period.
     .capabilities = in_box({360, 360, 360}, {.max_force_n = 100.0,
                                              .continuous_force_n = 100.0,
                                              .advised_force_n = 3.0,
                                              .max_stiffness_n_per_m = 4000.0,
                                              .max_damping_n_s_per_m = 20.0,
                                              .position_step_mm = 0.012,
                                              .friction_n = 0.5,
                                              .mass_kg = 3.0,
                                              .period_ns = 4'000'000}),
     .source = "force, stiffness: as public programs use it; virtual mass and its friction: as the "
               "driver sets them; the rest: estimate"},
}};

constexpr std::size_t kGeneric = kModels.size() - 2;
static_assert(kModels[kGeneric].id == "generic-3dof");

}  // namespace

std::span<const DeviceModel> device_models() noexcept {
  return kModels;
}

const DeviceModel* find_device_model(std::string_view id) noexcept {
  for (const DeviceModel& model : kModels) {
    if (model.id == id) return &model;
  }
  return nullptr;
}

const DeviceModel& generic_device_model() noexcept {
  return kModels[kGeneric];
}

}  // namespace felt
