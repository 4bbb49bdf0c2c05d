#include "felt/devices/evdev/known_sticks.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace felt {
namespace {

struct KnownStick {
  std::uint16_t vendor, product;
  std::string_view label;
  bool is_wheel;
  double full_force_n;  ///< at the grip or rim
};

// For wheels, the torque from makers' data sheets or press tests at a rim with a radius of 0.14 m;
// for sticks, the force at the grip. All of them are estimates that are probably too high.
constexpr std::array<KnownStick, 8> kKnown{{
    {0x045E, 0x001B, "Microsoft SideWinder Force Feedback 2", false, 8.0},
    {0x046D, 0xC286, "Logitech Force 3D Pro", false, 6.0},
    {0x046D, 0xC298, "Logitech Driving Force Pro", true, 15.0},
    {0x046D, 0xC299, "Logitech G25", true, 18.0},
    {0x046D, 0xC29B, "Logitech G27", true, 18.0},
    {0x046D, 0xC24F, "Logitech G29", true, 18.0},
    {0x046D, 0xC262, "Logitech G920", true, 18.0},
    {0x046D, 0xC266, "Logitech G923", true, 18.0},
}};

constexpr double kUnknownStickN = 10.0;
constexpr double kUnknownWheelN = 60.0;
constexpr double kStickHalfWayMm = 45.0;
constexpr double kWheelHalfWayMm = 120.0;  // travel of the rim; larger turns are compressed into it

bool has_word(std::string_view text, std::string_view word) {
  const auto at =
      std::search(text.begin(), text.end(), word.begin(), word.end(),
                  [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
  return at != text.end();
}

/// Returns the first existing button of those that are under the fingers on a grip.
std::optional<std::uint16_t> contact_button(const InputNode& node) {
  for (const std::uint16_t first :
       {evdev::kButtonTrigger, evdev::kButtonSouth, evdev::kButtonGearDown}) {
    if (node.keys[first]) return first;
  }
  return std::nullopt;
}

}  // namespace

std::optional<StickKind> stick_kind(const InputNode& node) {
  const bool pushes = node.effects[evdev::kFfSpring] || node.effects[evdev::kFfConstant];
  const auto button = contact_button(node);
  if (!pushes || !button || !node.axes[evdev::kAbsX]) return std::nullopt;
  const auto known = std::find_if(kKnown.begin(), kKnown.end(), [&](const KnownStick& row) {
    return row.vendor == node.vendor && row.product == node.product;
  });
  StickKind kind;
  kind.is_known = known != kKnown.end();
  kind.is_wheel = kind.is_known
                      ? known->is_wheel
                      : node.keys[evdev::kButtonGearDown] || has_word(node.name, "wheel") ||
                            has_word(node.name, "racing") || !node.axes[evdev::kAbsY];
  kind.label = kind.is_known ? std::string(known->label)
               : node.name.empty()
                   ? std::string("Force feedback ") + (kind.is_wheel ? "wheel" : "joystick")
                   : node.name;
  kind.layout.contact = *button;
  if (kind.is_wheel) {
    kind.layout.y.reset();
    if (node.axes[evdev::kAbsGas]) kind.layout.pressure = evdev::kAbsGas;
  } else if (node.axes[evdev::kAbsThrottle]) {
    kind.layout.pressure = evdev::kAbsThrottle;
  }
  kind.layout.half_way_mm = kind.is_wheel ? kWheelHalfWayMm : kStickHalfWayMm;
  kind.forces.effects = node.effects;
  kind.forces.full_force_n = kind.is_known   ? known->full_force_n
                             : kind.is_wheel ? kUnknownWheelN
                                             : kUnknownStickN;
  kind.forces.half_way_mm = kind.layout.half_way_mm;
  kind.forces.has_y = kind.layout.y.has_value();
  return kind;
}

}  // namespace felt
