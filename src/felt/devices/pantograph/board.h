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
  bool turns_ccw = false;   ///< direction of positive torque
  bool counts_ccw = false;  ///< direction of positive angle
  float rest_deg = 0.0F;    ///< angle of the arm where the encoder starts to count
  float counts_per_turn = 0.0F;
};

/// A version of the 2DIY. All use the same protocol, but differ in arms, motors and wires.
struct BoardModel {
  std::string_view id;     ///< "v2", in device ids and FELT_PANTOGRAPH_PORT
  std::string_view label;  ///< for the user, with lengths by which to tell the versions apart
  FiveBarSize size;
  std::array<MotorWiring, 2> motors;  ///< motor 1, 2 of FiveBar
  double gain = 1.0;                  ///< the board's torque value for 1 N m
  Vec3 reach_min, reach_max;          ///< the area in which the full force is available, mm
};

/// Returns the versions, with values from public code of Haply and of its users
/// (docs/design/devices.md#pantograph-board): the C++ example for v1, the Processing and Python
/// examples for v2 and v3. None was tested on hardware.
std::span<const BoardModel> board_models() noexcept;
/// Returns the version with this id, or null.
const BoardModel* find_board_model(std::string_view id) noexcept;

/// Frames of the serial protocol: [type][device id][bytes...][float32, little-endian...].
inline constexpr std::uint8_t kDeviceId = 5;
inline constexpr std::size_t kReplyBytes = 1 + 2 * 4;  ///< [device id][two angles in degrees]

using ResetFrame = std::array<std::byte, 2>;
using SetupFrame = std::array<std::byte, 2 + 8 + 16>;
using TorqueFrame = std::array<std::byte, 2 + 8>;

/// Returns a frame of type 0: the board restarts, motors off.
ResetFrame reset_frame() noexcept;
/// Returns a frame of type 1: motors, encoders, no sensors, no pwm; encoders start to count here.
SetupFrame setup_frame(const BoardModel& model) noexcept;
/// Returns a frame of type 2: torques of motor 1 and 2, N m before the gain; answered by a reply.
TorqueFrame torque_frame(const BoardModel& model, const std::array<double, 2>& torques_nm) noexcept;
/// Reads the angles of arm 1 and 2, rad. Returns false if they are not finite or not plausible.
bool read_angles(const BoardModel& model, std::span<const std::byte, kReplyBytes> reply,
                 std::array<double, 2>& angles_rad) noexcept;

}  // namespace felt::pantograph
