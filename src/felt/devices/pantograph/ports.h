#pragma once

#include <string>
#include <vector>

#include "felt/driver/diagnosis.h"

namespace felt::pantograph {

inline constexpr const char* kPortVariable = "FELT_PANTOGRAPH_PORT";

/// A serial port to which a board may be connected.
struct Port {
  std::string path;   ///< "/dev/ttyACM0"
  std::string name;   ///< the same after each restart: "usb-Arduino_...-if00", or "ttyACM0"
  std::string model;  ///< BoardModel::id if the user named it; empty if unknown
};

/// Returns the port that FELT_PANTOGRAPH_PORT names or, if that variable is not set, the ports in
/// /dev/serial/by-id that look like a board.
std::vector<Port> find_ports(const SystemView& system);

/// Implements Driver::diagnose: checks whether a board is connected and its port may be used.
std::vector<Finding> examine(const SystemView& system);

}  // namespace felt::pantograph
