#include "felt/devices/pantograph/board.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace felt::pantograph {
namespace {

constexpr std::uint8_t kReset = 0, kSetup = 1, kTorques = 2;
constexpr double kRadPerDeg = 0.017453292519943295;
constexpr double kMaxDeg = 1080.0;  // three turns; an arm cannot turn so far

constexpr std::array<BoardModel, 3> kModels{{
    {.id = "v1",
     .label = "Haply 2DIY, first make (arms 50 mm, forearms 70 mm, motors 20 mm apart)",
     .size = {50.0, 70.0, 20.0},
     .motors = {{{1, false, false, 180.0F, 13824.0F}, {2, false, false, 0.0F, 13824.0F}}},
     .gain = 0.1,
     .reach_min = {-35.0, 45.0, 0.0},
     .reach_max = {55.0, 100.0, 0.0}},
    {.id = "v2",
     .label = "Haply 2DIY v2 (arms 70 mm, forearms 90 mm, motors one above the other)",
     .size = {70.0, 90.0, 0.0},
     .motors = {{{2, true, true, 241.0F, 10752.0F}, {1, false, false, -61.0F, 10752.0F}}},
     .gain = 1.0,
     .reach_min = {-60.0, 50.0, 0.0},
     .reach_max = {60.0, 125.0, 0.0}},
    {.id = "v3",
     .label = "Haply 2DIY v3 (arms 70 mm, forearms 90 mm, motors 38 mm apart)",
     .size = {70.0, 90.0, 38.0},
     .motors = {{{2, true, true, 168.0F, 4880.0F}, {1, true, true, 12.0F, 4880.0F}}},
     .gain = 1.0,
     .reach_min = {-41.0, 50.0, 0.0},
     .reach_max = {79.0, 125.0, 0.0}},
}};

template <std::size_t Size>
void put_float(std::array<std::byte, Size>& frame, std::size_t at, float value) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (std::size_t i = 0; i < 4; ++i) frame[at + i] = static_cast<std::byte>(bits >> (8 * i));
}

float get_float(std::span<const std::byte> bytes) noexcept {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) bits |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * i);
  return std::bit_cast<float>(bits);
}

// Returns the motors' indices in the order of their ports, in which the board expects their values.
std::array<std::size_t, 2> by_port(const BoardModel& model) noexcept {
  const bool in_order = model.motors[0].port < model.motors[1].port;
  return in_order ? std::array<std::size_t, 2>{0, 1} : std::array<std::size_t, 2>{1, 0};
}

std::byte mask_of(const BoardModel& model) noexcept {
  unsigned mask = 0;
  for (const MotorWiring& motor : model.motors) mask |= 1u << (motor.port - 1);
  return static_cast<std::byte>(mask);
}

}  // namespace

std::span<const BoardModel> board_models() noexcept {
  return kModels;
}

const BoardModel* find_board_model(std::string_view id) noexcept {
  const auto found = std::find_if(kModels.begin(), kModels.end(),
                                  [id](const BoardModel& model) { return model.id == id; });
  return found != kModels.end() ? &*found : nullptr;
}

ResetFrame reset_frame() noexcept {
  return {static_cast<std::byte>(kReset), std::byte{0}};
}

SetupFrame setup_frame(const BoardModel& model) noexcept {
  SetupFrame frame{static_cast<std::byte>(kSetup), static_cast<std::byte>(kDeviceId)};
  const auto order = by_port(model);
  std::size_t at = 2;
  frame[at++] = mask_of(model);
  for (const std::size_t k : order) frame[at++] = std::byte{model.motors[k].turns_ccw};
  frame[at++] = mask_of(model);
  for (const std::size_t k : order) frame[at++] = std::byte{model.motors[k].counts_ccw};
  frame[at++] = std::byte{0};  // sensors
  frame[at++] = std::byte{0};  // pwm
  for (const std::size_t k : order) {
    put_float(frame, at, model.motors[k].rest_deg);
    put_float(frame, at + 4, model.motors[k].counts_per_turn);
    at += 8;
  }
  return frame;
}

TorqueFrame torque_frame(const BoardModel& model,
                         const std::array<double, 2>& torques_nm) noexcept {
  TorqueFrame frame{static_cast<std::byte>(kTorques), static_cast<std::byte>(kDeviceId)};
  std::size_t at = 2;
  for (const std::size_t k : by_port(model)) {
    put_float(frame, at, static_cast<float>(model.gain * torques_nm[k]));
    at += 4;
  }
  return frame;
}

bool read_angles(const BoardModel& model, std::span<const std::byte, kReplyBytes> reply,
                 std::array<double, 2>& angles_rad) noexcept {
  std::size_t at = 1;
  for (const std::size_t k : by_port(model)) {
    const auto degrees = static_cast<double>(get_float(reply.subspan(at, 4)));
    if (!(std::abs(degrees) <= kMaxDeg)) return false;
    angles_rad[k] = kRadPerDeg * degrees;
    at += 4;
  }
  return true;
}

}  // namespace felt::pantograph
