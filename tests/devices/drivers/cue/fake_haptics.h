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

/// The report descriptor of a pen of our own making, with what real ones have: a digitizer before
/// it, ordinals in a feature report, intensity, repeat count, cut-off in steps of 10 ms, retrigger
/// period in the output report; its number is `report`.
std::vector<std::uint8_t> pen_descriptor(std::uint8_t report, bool is_touchpad = false);
/// Of a HID++ device: reports 0x10 and 0x11 of the maker's own page.
std::vector<std::uint8_t> hidpp_descriptor();

/// A haptic pen as hidraw shows it. Its rules: output reports have the number and length of its
/// descriptor, the ordinal is one of its list or stop, nothing but the manual trigger is written;
/// too many of them a second stop it from writing (as a Slim Pen 2, whose motor is then used too
/// heavily: what stops it does not count, and must never be held back).
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
  std::function<int()> fault;  ///< asked at each call: errno, or 0
  /// What it answers to any feature report, over and over; empty: the truth.
  std::vector<std::uint8_t> lies;
  std::string broken_rule;

  std::unique_ptr<HidrawPort> open();
  /// Does it play something that goes on?
  [[nodiscard]] bool hums() const;
  /// The most that were asked for within any second, without the stops.
  [[nodiscard]] std::size_t most_in_a_second() const;
};

/// A haptic mouse at a receiver, of the number 2, among other programs that talk to it.
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
  int foreign = 3;  ///< reports of others before each answer

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

/// A machine with a node of hidraw or of input, and what sysfs says of it.
void add_hidraw(FakeSystem& system, int number, const std::string& kernel, const std::string& name,
                const std::string& unique, const std::vector<std::uint8_t>& descriptor);
void add_input(FakeSystem& system, int number, const std::string& kernel, const std::string& name,
               const std::string& vendor, const std::string& product, const std::string& effects);

}  // namespace felt
