#pragma once

#include <string>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt::pantograph {

inline constexpr const char* kPortVariable = "FELT_PANTOGRAPH_PORT";

/// A serial port on which a board may be.
struct Port {
  std::string path;   ///< "/dev/ttyACM0"
  std::string name;   ///< the same each time: "usb-Arduino_...-if00", or "ttyACM0"
  std::string model;  ///< BoardModel::id where a person said it; empty: not known
};

/// FELT_PANTOGRAPH_PORT, or what looks like a board in /dev/serial/by-id.
std::vector<Port> find_ports(const SystemView& system);

/// Driver::diagnose.
std::vector<Finding> examine(const SystemView& system);

}  // namespace felt::pantograph
