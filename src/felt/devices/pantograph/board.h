#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "felt/devices/pantograph/five_bar.h"
#include "felt/geometry/vec3.h"

namespace felt::pantograph {

/// One motor with its encoder, as it is wired.
struct MotorWiring {
  std::uint8_t port = 1;    ///< 1..4 on the board
  bool turns_ccw = false;   ///< positive torque
  bool counts_ccw = false;  ///< positive angle
  float rest_deg = 0.0F;    ///< angle of the arm where the encoder begins to count
  float counts_per_turn = 0.0F;
};

/// A make of the 2DIY: they speak alike, but have other arms, motors and wires.
struct BoardModel {
  std::string_view id;     ///< "v2", in ids of devices and FELT_PANTOGRAPH_PORT
  std::string_view label;  ///< for people, with what they can measure
  FiveBarSize size;
  std::array<MotorWiring, 2> motors;  ///< motor 1, 2 of FiveBar
  double gain = 1.0;                  ///< the board's torque for one of N m
  Vec3 reach_min, reach_max;          ///< where there is authority everywhere, mm
};

/// From Haply's public code and that of its users (devices.md 6): the C++ example for v1, the
/// Processing and Python examples for v2 and v3. None was tried.
std::span<const BoardModel> board_models() noexcept;
/// By id, or null.
const BoardModel* find_board_model(std::string_view id) noexcept;

/// Frames of the serial protocol: [type][device id][bytes...][float32, little-endian...].
inline constexpr std::uint8_t kDeviceId = 5;
inline constexpr std::size_t kReplyBytes = 1 + 2 * 4;  ///< [device id][two angles in degrees]

using ResetFrame = std::array<std::byte, 2>;
using SetupFrame = std::array<std::byte, 2 + 8 + 16>;
using TorqueFrame = std::array<std::byte, 2 + 8>;

/// Type 0: the board begins anew, motors off.
ResetFrame reset_frame() noexcept;
/// Type 1: motors, encoders, no sensors, no pwm; encoders begin to count here.
SetupFrame setup_frame(const BoardModel& model) noexcept;
/// Type 2: torques of motor 1 and 2, N m before the gain; answered by a reply.
TorqueFrame torque_frame(const BoardModel& model, const std::array<double, 2>& torques_nm) noexcept;
/// Angles of arm 1 and 2, rad; false: they are no numbers, or no angles.
bool read_angles(const BoardModel& model, std::span<const std::byte, kReplyBytes> reply,
                 std::array<double, 2>& angles_rad) noexcept;

}  // namespace felt::pantograph
