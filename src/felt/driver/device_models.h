#pragma once

#include <span>
#include <string_view>

#include "felt/haptics/capabilities.h"

namespace felt {

/// A model of force device, and its limits. The table of device_models() holds the figures of all
/// devices, and the simulated styluses use the same table.
struct DeviceModel {
  std::string_view id;     ///< "omega.3": DeviceDescriptor::model, and the key in settings
  std::string_view label;  ///< for the user, with the maker: "Force Dimension omega.3"
  std::string_view maker;  ///< "Force Dimension"
  /// The capabilities in the device's own axes (see the README of the driver's folder). The
  /// workspace is around the device's own origin, as the driver reports it; period_ns is the
  /// nominal period.
  Capabilities capabilities;
  /// The source of the figures. It says "estimate" if a figure could not be checked on a data
  /// sheet. If the device itself reports other figures, a driver may use these to lower the force
  /// limits, but not to raise them.
  std::string_view source;
};

/// Returns all models, ordered by maker; the table never changes.
std::span<const DeviceModel> device_models() noexcept;
/// Returns the model with this id, or null.
const DeviceModel* find_device_model(std::string_view id) noexcept;
/// Returns the limits assumed for an unknown force device: "generic-3dof", the lowest of all.
const DeviceModel& generic_device_model() noexcept;

}  // namespace felt
