#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "felt/devices/pantograph/five_bar.h"
#include "felt/geometry/vec3.h"

namespace felt::pantograph {

/// One motor with its encoder, and its wiring.
struct MotorWiring {
  std::uint8_t port = 1;    ///< 1..4 on the board
  bool turns_ccw = false;   ///< true if positive torque turns counter-clockwise
  bool counts_ccw = false;  ///< true if the angle counts counter-clockwise
  float rest_deg = 0.0F;    ///< angle of the arm when the encoder starts to count
  float counts_per_turn = 0.0F;
};

/// A version of the 2DIY. All versions use the same protocol, but they differ in arms, motors and
/// wiring.
struct BoardModel {
  std::string_view id;     ///< "v2", in device ids and FELT_PANTOGRAPH_PORT
  std::string_view label;  ///< for the user; contains the arm lengths that identify the version
  FiveBarSize size;
  std::array<MotorWiring, 2> motors;  ///< motors 1 and 2 of FiveBar
  double gain = 1.0;                  ///< the board's torque value for 1 N m
  Vec3 reach_min, reach_max;          ///< the area in which the full force is available, mm
};

/// Returns the versions, with values from public code of Haply and of its users
/// (docs/design/devices.md#pantograph-board): the C++ example for v1, the Processing and Python
/// examples for v2 and v3. These values have not been tested on hardware.
std::span<const BoardModel> board_models() noexcept;
/// Returns the version with this id, or null.
const BoardModel* find_board_model(std::string_view id) noexcept;

/// A frame of the serial protocol is [type][device id][bytes...][float32, little-endian...].
inline constexpr std::uint8_t kDeviceId = 5;
inline constexpr std::size_t kReplyBytes = 1 + 2 * 4;  ///< [device id][two angles in degrees]

using ResetFrame = std::array<std::byte, 2>;
using SetupFrame = std::array<std::byte, 2 + 8 + 16>;
using TorqueFrame = std::array<std::byte, 2 + 8>;

/// Returns a frame of type 0, which restarts the board with its motors off.
ResetFrame reset_frame() noexcept;
/// Returns a frame of type 1, which sets up the motors and encoders, and no sensors or PWM outputs.
/// The encoders start to count when the board receives it.
SetupFrame setup_frame(const BoardModel& model) noexcept;
/// Returns a frame of type 2, which sets the torques of motors 1 and 2. `torques_nm` does not
/// include the gain, which this function applies. The board answers this frame with a reply.
TorqueFrame torque_frame(const BoardModel& model, const std::array<double, 2>& torques_nm) noexcept;
/// Reads the angles of arms 1 and 2, in rad, from a reply. Returns false if the angles are not
/// finite or not plausible.
bool read_angles(const BoardModel& model, std::span<const std::byte, kReplyBytes> reply,
                 std::array<double, 2>& angles_rad) noexcept;

}  // namespace felt::pantograph
