#include "felt/devices/cue/hidpp_mouse.h"

#include <cerrno>
#include <cstring>
#include <span>

#include "felt/driver/cue_device.h"

namespace felt {
namespace {

constexpr std::int64_t kWaitNs = 50'000'000;
constexpr int kMaxWaits = 5;     // waits without an answer
constexpr int kMaxForeign = 64;  // messages of other programs between request and answer
constexpr std::uint8_t kRoot = 0x00;
constexpr std::uint8_t kGetFeature = 0, kGetCapabilities = 0, kPlay = 4;
constexpr std::uint8_t kRefused = 0xFF, kRefusedByReceiver = 0x8F;

struct MouseTick {
  CueWaveform waveform;
  std::array<std::uint8_t, 3> numbers;  ///< best first
};

// The numbers of the waveforms. Solaar names them as follows: 0 is a sharp and 1 a damp change of
// state; 2 is a sharp, 3 a damp and 4 a subtle collision; 0x1B is a whisper.
constexpr std::array<MouseTick, 4> kTicks{{
    {CueWaveform::kClick, {1, 0, 3}},
    {CueWaveform::kHover, {0x1B, 4, 1}},
    {CueWaveform::kSuccess, {4, 3, 2}},
    {CueWaveform::kError, {3, 2, 0}},
}};

}  // namespace

HidppMouse::Report HidppMouse::request(std::uint8_t feature, std::uint8_t function) const noexcept {
  Report report{};
  report[0] = kLongReport;
  report[1] = device_;
  report[2] = feature;
  report[3] = static_cast<std::uint8_t>(function << 4 | kSoftware);
  return report;
}

tl::expected<HidppMouse::Report, int> HidppMouse::ask(std::uint8_t feature, std::uint8_t function,
                                                      std::uint16_t argument) noexcept {
  Report asked = request(feature, function);
  asked[4] = static_cast<std::uint8_t>(argument >> 8);
  asked[5] = static_cast<std::uint8_t>(argument & 0xFF);
  if (const auto written = port_->write(asked); !written) return tl::unexpected(written.error());
  int waits = 0;
  for (int foreign = 0; foreign < kMaxForeign && waits < kMaxWaits;) {
    std::array<std::uint8_t, 64> room{};
    const auto count = port_->read(room, kWaitNs);
    if (!count) return tl::unexpected(count.error());
    if (*count == 0) {
      ++waits;
      continue;
    }
    ++foreign;
    if (*count < 7 || room[1] != device_) continue;
    const bool is_refusal = room[2] == kRefused || room[2] == kRefusedByReceiver;
    if (is_refusal && room[3] == feature && room[4] == asked[3]) return tl::unexpected(EPROTO);
    if (*count < kBytes || room[0] != kLongReport || room[2] != feature || room[3] != asked[3])
      continue;
    Report answer{};
    std::memcpy(answer.data(), room.data(), answer.size());
    return answer;
  }
  return tl::unexpected(ETIMEDOUT);
}

tl::expected<void, int> HidppMouse::find_haptics() noexcept {
  const auto feature = ask(kRoot, kGetFeature, kHaptics);
  if (!feature) return tl::unexpected(feature.error());
  feature_ = (*feature)[4];
  if (feature_ == 0) return tl::unexpected(EPROTO);  // the device does not have the feature
  const auto capabilities = ask(feature_, kGetCapabilities, 0);
  if (!capabilities) return tl::unexpected(capabilities.error());
  for (std::size_t i = 0; i < 4; ++i) waveforms_ = waveforms_ << 8 | (*capabilities)[4 + 4 + i];
  return {};
}

Result<std::unique_ptr<CueDevice>> HidppMouse::open(std::unique_ptr<HidrawPort> port,
                                                    bool is_receiver, DeviceDescriptor descriptor) {
  const std::string label = descriptor.label;
  std::unique_ptr<HidppMouse> mouse(
      new HidppMouse(std::move(port), kDirect, std::move(descriptor)));
  int error = ETIMEDOUT;
  for (std::uint8_t number = 1; number <= (is_receiver ? kMaxPaired : 1); ++number) {
    if (is_receiver) mouse->device_ = number;
    const auto found = mouse->find_haptics();
    if (found) return mouse;
    error = found.error();
    if (error != ETIMEDOUT && error != EPROTO) break;
  }
  if (error == ETIMEDOUT || error == EPROTO) {
    return fail(ErrorCode::kNotFound,
                label + ": no mouse with haptics answers. Is it switched on, and awake?");
  }
  return fail(ErrorCode::kIo, label + " cannot be queried: " + std::strerror(error));
}

int HidppMouse::number_of(CueWaveform waveform) const noexcept {
  for (const MouseTick& tick : kTicks) {
    if (tick.waveform != waveform) continue;
    for (const std::uint8_t number : tick.numbers) {
      if ((waveforms_ >> number & 1) != 0) return number;
    }
  }
  return -1;
}

tl::expected<void, DeviceFault> HidppMouse::play(const Cue& cue, std::int64_t now_ns) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  const int number = number_of(cue.waveform);
  constexpr double kMin = 0.05;
  if (number < 0 || !(cue.intensity >= kMin) || !pacer_.take(now_ns)) return {};
  // Discards answers, including those for other programs, so that the queue does not fill.
  std::array<std::uint8_t, 64> room{};
  for (int i = 0; i < kMaxForeign; ++i) {
    const auto count = port_->read(room, 0);
    if (!count || *count == 0) break;
  }
  Report report = request(feature_, kPlay);
  report[4] = static_cast<std::uint8_t>(number);
  const auto written = port_->write(report);
  if (written) return {};
  is_gone_ = written.error() == ENODEV || written.error() == ENXIO;
  return tl::unexpected(is_gone_ ? DeviceFault::kDisconnected : DeviceFault::kOther);
}

}  // namespace felt
