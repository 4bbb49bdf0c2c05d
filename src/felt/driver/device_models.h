#pragma once

#include <span>
#include <string_view>

#include "felt/haptics/capabilities.h"

namespace felt {

/// A kind of force device that people own, and what may be asked of it: the one place where the
/// figures of devices stand. The simulated styluses take theirs from here.
struct DeviceModel {
  std::string_view id;     ///< "omega.3": DeviceDescriptor::model, and what settings keep
  std::string_view label;  ///< for people, with the maker: "Force Dimension omega.3"
  std::string_view maker;  ///< "Force Dimension"
  /// The device's own axes, the workspace around its own origin as a driver reports it: as the
  /// table of the maker's axes in the room's README says. period_ns is its nominal rate.
  Capabilities capabilities;
  /// Where the figures are from. What nobody could check on a data sheet is called an estimate; a
  /// driver that learns better from the device itself only ever lowers forces.
  std::string_view source;
  /// Some driver of ours opens it. The others are listed for those who ask.
  bool is_driven = true;
};

/// All of them, in the order of makers. Constant.
std::span<const DeviceModel> device_models() noexcept;
/// By id, or null.
const DeviceModel* find_device_model(std::string_view id) noexcept;
/// What is assumed of a force device that nobody knows: "generic-3dof", the least of everything.
const DeviceModel& generic_device_model() noexcept;

}  // namespace felt
