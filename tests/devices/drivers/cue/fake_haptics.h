#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "felt/driver/evdev_port.h"
#include "felt/driver/hidraw_port.h"
#include "felt/driver/testing/fake_system.h"

namespace felt {

/// Returns the report descriptor of an invented pen with the features of real pens: a digitizer
/// before the haptic part, ordinals in a feature report, and in the output report intensity, repeat
/// count, cut-off in steps of 10 ms and retrigger period. The output report has the number
/// `report`.
std::vector<std::uint8_t> pen_descriptor(std::uint8_t report, bool is_touchpad = false);
/// Returns the report descriptor of a HID++ device: reports 0x10 and 0x11 of the vendor's own page.
std::vector<std::uint8_t> hidpp_descriptor();

/// A haptic pen as hidraw shows it. Its rules: output reports have the number and length of its
/// descriptor; the ordinal is in its list or is the stop; only the manual trigger is written. Too
/// many output reports per second make it stop writing (as with a Slim Pen 2, because its motor is
/// then used too heavily). Stop reports do not count and must never be held back.
struct FakePen {
  struct Played {
    std::int64_t now_ns = 0;
    std::uint8_t ordinal = 0, intensity = 0, repeat = 0, cutoff = 0;
  };

  std::uint8_t report = 65;
  std::vector<std::uint16_t> waveforms{0x1003, 0x100B, 0x100C, 0x100D, 0x1010, 0x1009};
  std::vector<Played> played;
  std::int64_t now_ns = 0;
  int error = 0;
  std::function<int()> fault;  ///< called at each call; returns an errno, or 0
  /// The wrong answer to every feature report. If empty, the pen answers correctly.
  std::vector<std::uint8_t> lies;
  std::string broken_rule;

  std::unique_ptr<HidrawPort> open();
  /// Returns true if it plays a continuous waveform.
  [[nodiscard]] bool hums() const;
  /// Returns the largest number of output reports within any second, without the stops.
  [[nodiscard]] std::size_t max_in_a_second() const;
};

/// A haptic mouse with the number 2 at a receiver, which other programs use as well.
struct FakeMouse {
  std::uint8_t number = 2;
  bool is_direct = false;
  std::uint32_t waveforms = 0x08007FFF;
  bool is_asleep = false;
  std::vector<std::uint8_t> played;
  std::deque<std::vector<std::uint8_t>> answers;
  int error = 0;
  std::function<int()> fault;
  std::string broken_rule;
  int foreign = 3;  ///< reports of other programs before each answer

  std::unique_ptr<HidrawPort> open();
};

/// A touchpad with FF_HAPTIC, or a controller with FF_RUMBLE.
struct FakePad {
  bool is_haptic = true;
  std::vector<std::uint16_t> waveforms{0x1003, 0x1006, 0x1007};
  int slots = 2;
  int error = 0;
  std::function<int()> fault;
  std::map<std::int16_t, EvdevEffect> effects;
  std::set<std::int16_t> playing;
  std::vector<EvdevEffect> played;
  int stopped = 0;
  std::string broken_rule;

  std::unique_ptr<EvdevPort> open();
};

/// Adds a hidraw or input node and its entries in sysfs to a machine.
void add_hidraw(FakeSystem& system, int number, const std::string& kernel, const std::string& name,
                const std::string& unique, const std::vector<std::uint8_t>& descriptor);
void add_input(FakeSystem& system, int number, const std::string& kernel, const std::string& name,
               const std::string& vendor, const std::string& product, const std::string& effects);

}  // namespace felt
