#include "tests/devices/drivers/cue/fake_haptics.h"

#include <algorithm>
#include <cerrno>
#include <utility>

namespace felt {
namespace {

constexpr std::size_t kPenBytes = 7;  // number, trigger, intensity, repeat, cut-off, retrigger (2)
constexpr std::uint8_t kList = 0x40;  // feature report of the lists
constexpr std::uint8_t kHapticsAt = 0x0B;

template <class Fake>
int error_of(const Fake& fake) {
  if (fake.error != 0) return fake.error;
  return fake.fault ? fake.fault() : 0;
}

class PenPort final : public HidrawPort {
 public:
  explicit PenPort(FakePen& pen) : pen_(pen) {}
  tl::expected<void, int> write(std::span<const std::uint8_t> report) noexcept override {
    if (const int error = error_of(pen_); error != 0) return tl::unexpected(error);
    if (report.size() != kPenBytes || report[0] != pen_.report) {
      pen_.broken_rule = "an output report that it has not got";
      return tl::unexpected(EINVAL);
    }
    const std::uint8_t ordinal = report[1];
    if (ordinal != 2 && (ordinal < 3 || ordinal >= 3 + pen_.waveforms.size())) {
      pen_.broken_rule = "an ordinal that it has not listed";
      return tl::unexpected(EPIPE);
    }
    pen_.played.push_back({pen_.now_ns, ordinal, report[2], report[3], report[4]});
    if (pen_.max_in_a_second() > 22) pen_.broken_rule = "used so heavily that it stops writing";
    return {};
  }
  tl::expected<std::size_t, int> read(std::span<std::uint8_t>, std::int64_t) noexcept override {
    return 0;
  }
  tl::expected<std::size_t, int> feature(std::span<std::uint8_t> room) noexcept override {
    if (const int error = error_of(pen_); error != 0) return tl::unexpected(error);
    if (!pen_.lies.empty()) {
      for (std::size_t i = 1; i < room.size(); ++i) room[i] = pen_.lies[i % pen_.lies.size()];
      return room.size();
    }
    if (room[0] != kList) {
      pen_.broken_rule = "a feature report that it has not got";
      return tl::unexpected(EINVAL);
    }
    // Six waveforms of 16 bits, then six durations of 8.
    for (std::size_t i = 0; i < 6; ++i) {
      const std::uint16_t waveform = i < pen_.waveforms.size() ? pen_.waveforms[i] : 0;
      room[1 + 2 * i] = static_cast<std::uint8_t>(waveform & 0xFF);
      room[2 + 2 * i] = static_cast<std::uint8_t>(waveform >> 8);
      room[13 + i] = static_cast<std::uint8_t>(10 * i);
    }
    return room.size();
  }

 private:
  FakePen& pen_;
};

class MousePort final : public HidrawPort {
 public:
  explicit MousePort(FakeMouse& mouse) : mouse_(mouse) {}
  tl::expected<void, int> write(std::span<const std::uint8_t> report) noexcept override {
    if (const int error = error_of(mouse_); error != 0) return tl::unexpected(error);
    if (report.size() != 20 || report[0] != 0x11) {
      mouse_.broken_rule = "a report that is none of HID++";
      return tl::unexpected(EINVAL);
    }
    const std::uint8_t device = report[1], feature = report[2], function = report[3];
    if ((function & 0xF) >= 0xB) mouse_.broken_rule = "another program's software number";
    const std::uint8_t own = mouse_.is_direct ? std::uint8_t{0xFF} : mouse_.number;
    if (mouse_.is_asleep) return {};
    if (device != own) {  // the receiver's answer for a device that is not connected
      answer({0x10, device, 0x8F, feature, function, 0x08, 0x00});
      return {};
    }
    if (feature == 0 && function >> 4 == 0) {
      const bool knows = report[4] == 0x19 && report[5] == 0xB0;
      reply(report, {static_cast<std::uint8_t>(knows ? kHapticsAt : 0), 0, 0});
    } else if (feature == kHapticsAt && function >> 4 == 0) {
      std::vector<std::uint8_t> payload(8, 0);
      for (int i = 0; i < 4; ++i)
        payload[static_cast<std::size_t>(4 + i)] =
            static_cast<std::uint8_t>(mouse_.waveforms >> (24 - 8 * i));
      reply(report, payload);
    } else if (feature == kHapticsAt && function >> 4 == 4) {
      mouse_.played.push_back(report[4]);
      if ((mouse_.waveforms >> report[4] & 1) == 0)
        mouse_.broken_rule = "a waveform it has not got";
      reply(report, {});
    } else {
      mouse_.broken_rule = "a function that changes settings";
      answer({0x11, device, 0xFF, feature, function, 0x02});
    }
    return {};
  }
  tl::expected<std::size_t, int> read(std::span<std::uint8_t> room,
                                      std::int64_t) noexcept override {
    if (const int error = error_of(mouse_); error != 0) return tl::unexpected(error);
    if (mouse_.answers.empty()) return 0;
    const std::vector<std::uint8_t> next = std::move(mouse_.answers.front());
    mouse_.answers.pop_front();
    const std::size_t count = std::min(next.size(), room.size());
    std::copy_n(next.begin(), count, room.begin());
    return count;
  }
  tl::expected<std::size_t, int> feature(std::span<std::uint8_t>) noexcept override {
    mouse_.broken_rule = "a feature report";
    return tl::unexpected(EINVAL);
  }

 private:
  void answer(std::vector<std::uint8_t> report) {
    if (report[0] == 0x11) report.resize(20);
    // Every program receives all reports: another program's answer, an event, a mouse movement.
    const std::vector<std::vector<std::uint8_t>> noise{
        {0x11, report[1], report[2], static_cast<std::uint8_t>((report[3] & 0xF0) | 0xD), 0x77},
        {0x10, report[1], 0x04, 0x00, 0x01, 0x01, 0x01},
        {0x02, 0x00, 0x01, 0xFF}};
    for (int i = 0; i < mouse_.foreign; ++i) {
      std::vector<std::uint8_t> other = noise[static_cast<std::size_t>(i) % noise.size()];
      if (other[0] == 0x11) other.resize(20);
      mouse_.answers.push_back(std::move(other));
    }
    mouse_.answers.push_back(std::move(report));
  }
  void reply(std::span<const std::uint8_t> asked, std::vector<std::uint8_t> payload) {
    std::vector<std::uint8_t> report{0x11, asked[1], asked[2], asked[3]};
    report.insert(report.end(), payload.begin(), payload.end());
    answer(std::move(report));
  }

  FakeMouse& mouse_;
};

class PadPort final : public EvdevPort {
 public:
  explicit PadPort(FakePad& pad) : pad_(pad) {}
  ~PadPort() override {
    pad_.effects.clear();
    pad_.playing.clear();
  }
  tl::expected<bool, int> next(EvdevEvent&) noexcept override { return false; }
  tl::expected<EvdevAxis, int> axis(std::uint16_t) noexcept override {
    return tl::unexpected(EINVAL);
  }
  tl::expected<bool, int> key(std::uint16_t) noexcept override { return false; }
  tl::expected<int, int> slots() noexcept override { return pad_.slots; }
  tl::expected<std::int16_t, int> upload(const EvdevEffect& effect) noexcept override {
    if (const int error = error_of(pad_); error != 0) return tl::unexpected(error);
    const std::uint16_t kind = pad_.is_haptic ? evdev::kFfHaptic : evdev::kFfRumble;
    if (effect.type != kind) {
      pad_.broken_rule = "an effect of a kind that it has not got";
      return tl::unexpected(EINVAL);
    }
    if (effect.hid_usage == 0x1006 || effect.hid_usage == 0x1007) {
      pad_.broken_rule = "the touchpad's own clicks are taken away";
    }
    const auto& known = pad_.waveforms;
    if (pad_.is_haptic && std::find(known.begin(), known.end(), effect.hid_usage) == known.end()) {
      return tl::unexpected(EINVAL);
    }
    if (effect.length_ms == 0) pad_.broken_rule = "an effect that does not end";
    std::int16_t id = effect.id;
    if (id < 0) {
      if (pad_.effects.size() >= static_cast<std::size_t>(pad_.slots)) {
        return tl::unexpected(ENOSPC);
      }
      for (id = 0; pad_.effects.contains(id);) ++id;
    } else if (!pad_.effects.contains(id)) {
      pad_.broken_rule = "an upload for an effect that is not there";
      return tl::unexpected(EINVAL);
    }
    pad_.effects[id] = effect;
    return id;
  }
  tl::expected<void, int> erase(std::int16_t id) noexcept override {
    if (const int error = error_of(pad_); error != 0) return tl::unexpected(error);
    if (pad_.effects.erase(id) == 0) pad_.broken_rule = "erases what is not there";
    pad_.playing.erase(id);
    return {};
  }
  tl::expected<void, int> send(const EvdevEvent& event) noexcept override {
    if (const int error = error_of(pad_); error != 0) return tl::unexpected(error);
    const auto effect = pad_.effects.find(static_cast<std::int16_t>(event.code));
    if (event.type != evdev::kFf || effect == pad_.effects.end()) {
      pad_.broken_rule = "plays what is not there";
      return {};
    }
    if (event.value > 0) {
      pad_.played.push_back(effect->second);
      pad_.playing.insert(effect->first);
    } else {
      ++pad_.stopped;
      pad_.playing.erase(effect->first);
    }
    return {};
  }

 private:
  FakePad& pad_;
};

}  // namespace

std::vector<std::uint8_t> pen_descriptor(std::uint8_t report, bool is_touchpad) {
  std::vector<std::uint8_t> d;
  const auto add = [&d](std::initializer_list<std::uint8_t> bytes) { d.insert(d.end(), bytes); };
  const std::uint8_t application = is_touchpad ? 0x05 : 0x02;
  add({0x05, 0x0D, 0x09, application, 0xA1, 0x01, 0x85, 0x01});  // the pen itself: pressure
  add({0x09, 0x30, 0x15, 0x00, 0x26, 0xFF, 0x0F, 0x75, 0x10, 0x95, 0x01, 0x81, 0x02});
  add({0x05, 0x0E, 0x09, 0x01, 0xA1, 0x02, 0x85, kList});  // the controller
  add({0x09, 0x10, 0xA1, 0x02, 0x05, 0x0A});               // waveforms by ordinal 3..8
  add({0x19, 0x03, 0x29, 0x08, 0x15, 0x00, 0x26, 0xFF, 0x2F, 0x75, 0x10, 0x95, 0x06});
  add({0xB1, 0x02, 0xC0});
  add({0x05, 0x0E, 0x09, 0x11, 0xA1, 0x02, 0x05, 0x0A});  // durations
  add({0x19, 0x03, 0x29, 0x08, 0x26, 0xFF, 0x00, 0x75, 0x08, 0x95, 0x06, 0xB1, 0x02, 0xC0});
  add({0x05, 0x0E, 0x85, report, 0x95, 0x01, 0x25, 0x08, 0x09, 0x21, 0x91, 0x02});  // trigger
  add({0x25, 0x64, 0x09, 0x23, 0x91, 0x02});                                        // 0..100
  add({0x25, 0x05, 0x09, 0x24, 0x91, 0x02});                                        // repeats
  add({0x26, 0xFE, 0x00, 0x66, 0x01, 0x10, 0x55, 0xFD, 0x35, 0x00, 0x46, 0xEC, 0x09});
  add({0x09, 0x28, 0x91, 0x02});  // cut-off: 0..254 for 0..2540 ms
  add({0x75, 0x10, 0x26, 0xD0, 0x07, 0x46, 0xD0, 0x07, 0x09, 0x25, 0x91, 0x02});
  add({0xC0, 0xC0});
  return d;
}

std::vector<std::uint8_t> hidpp_descriptor() {
  return {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01, 0x85, 0x10, 0x75, 0x08, 0x95, 0x06, 0x15,
          0x00, 0x26, 0xFF, 0x00, 0x09, 0x01, 0x81, 0x00, 0x09, 0x01, 0x91, 0x00, 0xC0, 0x06,
          0x00, 0xFF, 0x09, 0x02, 0xA1, 0x01, 0x85, 0x11, 0x75, 0x08, 0x95, 0x13, 0x15, 0x00,
          0x26, 0xFF, 0x00, 0x09, 0x02, 0x81, 0x00, 0x09, 0x02, 0x91, 0x00, 0xC0};
}

std::unique_ptr<HidrawPort> FakePen::open() {
  return std::make_unique<PenPort>(*this);
}

bool FakePen::hums() const {
  if (played.empty() || played.back().ordinal < 3) return false;
  const std::uint16_t waveform = waveforms.at(std::size_t{played.back().ordinal} - 3);
  return waveform == 0x1004 || (waveform >= 0x100B && waveform <= 0x1010);
}

std::size_t FakePen::max_in_a_second() const {
  std::size_t largest = 0;
  std::deque<std::int64_t> turns;
  for (const Played& p : played) {
    if (p.ordinal == 2) continue;
    turns.push_back(p.now_ns);
    while (p.now_ns - turns.front() >= 1'000'000'000) turns.pop_front();
    largest = std::max(largest, turns.size());
  }
  return largest;
}

std::unique_ptr<HidrawPort> FakeMouse::open() {
  return std::make_unique<MousePort>(*this);
}

std::unique_ptr<EvdevPort> FakePad::open() {
  return std::make_unique<PadPort>(*this);
}

void add_hidraw(FakeSystem& system, int number, const std::string& kernel, const std::string& name,
                const std::string& unique, const std::vector<std::uint8_t>& descriptor) {
  const std::string node = "hidraw" + std::to_string(number), hid = "/sys/devices/" + kernel;
  system.add_link("/sys/class/hidraw/" + node, hid + "/hidraw/" + node)
      .add_link(hid + "/hidraw/" + node + "/device", hid)
      .add_file(hid + "/uevent", "HID_ID=" + kernel.substr(0, 4) + ":0000" + kernel.substr(5, 4) +
                                     ":0000" + kernel.substr(10, 4) + "\nHID_NAME=" + name +
                                     "\nHID_UNIQ=" + unique + "\n")
      .add_file(hid + "/report_descriptor", std::string(descriptor.begin(), descriptor.end()))
      .add_file("/dev/" + node);
}

void add_input(FakeSystem& system, int number, const std::string& kernel, const std::string& name,
               const std::string& vendor, const std::string& product, const std::string& effects) {
  const std::string node = "event" + std::to_string(number), hid = "/sys/devices/" + kernel;
  const std::string input = hid + "/input/input9";
  system.add_link("/sys/class/input/" + node, input + "/" + node)
      .add_link(input + "/" + node + "/device", input)
      .add_link(input + "/device", hid)
      .add_file(input + "/name", name)
      .add_file(input + "/id/vendor", vendor)
      .add_file(input + "/id/product", product)
      .add_file(input + "/capabilities/ff", effects)
      .add_file("/dev/input/" + node);
}

}  // namespace felt
