#include "felt/devices/cue/hid_haptics.h"

#include <cerrno>

namespace felt {
namespace {

constexpr auto kHoldMs = static_cast<std::uint32_t>(kCueHoldNs / 1'000'000);

}  // namespace

tl::expected<void, DeviceFault> HidHaptics::send(const Cue& cue) noexcept {
  const auto report = reports_.play(cue, kHoldMs);
  if (report.empty()) return {};
  const auto written = port_->write(report);
  if (!written) {
    is_gone_ = written.error() == ENODEV || written.error() == ENXIO;
    return tl::unexpected(is_gone_ ? DeviceFault::kDisconnected : DeviceFault::kOther);
  }
  hums_ = is_continuous(cue.waveform);
  return {};
}

tl::expected<void, DeviceFault> HidHaptics::play(const Cue& cue, std::int64_t now_ns) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  const bool is_silence = cue.waveform == CueWaveform::kNone || !(cue.intensity > 0.0);
  if (is_silence) return hums_ ? send({}) : tl::expected<void, DeviceFault>();
  if (!plays(cue.waveform) || !pacer_.take(now_ns)) return {};
  return send(cue);
}

void HidHaptics::stop() noexcept {
  if (!is_gone_ && hums_) static_cast<void>(send({}));
}

}  // namespace felt
