#include "felt/devices/cue/evdev_cues.h"

#include <algorithm>
#include <cerrno>
#include <cmath>

#include "felt/devices/cue/haptic_reports.h"

namespace felt {
namespace {

constexpr auto kHumMs = static_cast<std::uint16_t>(kCueHoldNs / 1'000'000);
constexpr std::uint16_t kTickMs = 40;
constexpr double kWeakest = 0.15;  // the minimum strength at which a motor turns

/// Returns true for waveforms of the touchpad itself. Uploading one would disable the touchpad's
/// own clicks, because the kernel then leaves pressing and releasing to the program (cover letter
/// of the kernel's haptic touchpads, 2025).
constexpr bool is_the_pads_own(CueWaveform waveform) noexcept {
  return waveform == CueWaveform::kPress || waveform == CueWaveform::kRelease;
}

double clamped(double intensity) noexcept {
  return intensity > 0.0 ? std::min(intensity, 1.0) : 0.0;
}

}  // namespace

EvdevCues::~EvdevCues() {
  stop();
  for (const std::int16_t id : ids_) {
    if (id >= 0 && !is_gone_) static_cast<void>(port_->erase(id));
  }
}

bool EvdevCues::plays(CueWaveform waveform) const noexcept {
  if (!is_haptic_) return true;
  const auto nearest = nearest_waveforms(waveform);
  return std::any_of(nearest.begin(), nearest.end(), [this](CueWaveform relative) {
    return !is_the_pads_own(relative) && !refused_[static_cast<std::size_t>(relative)];
  });
}

/// For a pencil, uses only the light motor, because that motor vibrates at a higher frequency than
/// the heavy one.
EvdevEffect EvdevCues::rumble_of(const Cue& cue) const noexcept {
  EvdevEffect effect;
  effect.type = evdev::kFfRumble;
  const double level = kWeakest + (1.0 - kWeakest) * clamped(cue.intensity);
  const auto number = static_cast<std::uint16_t>(std::lround(level * 65535.0));
  const bool is_light = cue.waveform == CueWaveform::kPencil || cue.waveform == CueWaveform::kInk ||
                        cue.waveform == CueWaveform::kHover ||
                        cue.waveform == CueWaveform::kRelease;
  const bool is_heavy = cue.waveform == CueWaveform::kEraser || cue.waveform == CueWaveform::kError;
  effect.weak = is_heavy ? std::uint16_t{0} : number;
  effect.strong = is_light ? std::uint16_t{0} : number;
  return effect;
}

tl::expected<void, int> EvdevCues::start(EvdevEffect effect, Slot slot) noexcept {
  effect.id = ids_[slot];
  effect.length_ms = slot == kHum ? kHumMs : kTickMs;
  const auto id = port_->upload(effect);
  if (!id) return tl::unexpected(id.error());
  ids_[slot] = *id;
  const auto sent = port_->send({evdev::kFf, static_cast<std::uint16_t>(*id), 1});
  if (!sent) return tl::unexpected(sent.error());
  playing_[slot] = true;
  return {};
}

tl::expected<void, int> EvdevCues::play_haptic(const Cue& cue, Slot slot) noexcept {
  for (const CueWaveform waveform : nearest_waveforms(cue.waveform)) {
    const auto index = static_cast<std::size_t>(waveform);
    if (is_the_pads_own(waveform) || refused_[index]) continue;
    EvdevEffect effect;
    effect.type = evdev::kFfHaptic;
    effect.hid_usage = hid_waveform(waveform);
    effect.intensity_percent =
        static_cast<std::uint16_t>(std::lround(100.0 * clamped(cue.intensity)));
    const auto done = start(effect, slot);
    if (done || done.error() != EINVAL) return done;
    refused_[index] = true;
  }
  return {};
}

/// Ends an effect. If the kernel refuses, the effect still counts as playing, and the next call
/// tries again to end it.
void EvdevCues::end(Slot slot) noexcept {
  if (!playing_[slot] || is_gone_) return;
  const auto sent = port_->send({evdev::kFf, static_cast<std::uint16_t>(ids_[slot]), 0});
  playing_[slot] = !sent;
}

tl::expected<void, DeviceFault> EvdevCues::play(const Cue& cue, std::int64_t now_ns) noexcept {
  if (is_gone_) return tl::unexpected(DeviceFault::kDisconnected);
  if (cue.waveform == CueWaveform::kNone || !(cue.intensity > 0.0)) {
    end(kHum);
    return {};
  }
  if (!plays(cue.waveform) || !pacer_.take(now_ns)) return {};
  const Slot slot = is_continuous(cue.waveform) ? kHum : kTick;
  if (slot == kTick) end(kHum);
  const auto done = is_haptic_ ? play_haptic(cue, slot) : start(rumble_of(cue), slot);
  if (done) return {};
  is_gone_ = done.error() == ENODEV || done.error() == ENXIO;
  return tl::unexpected(is_gone_ ? DeviceFault::kDisconnected : DeviceFault::kOther);
}

void EvdevCues::stop() noexcept {
  end(kHum);
  end(kTick);
}

}  // namespace felt
