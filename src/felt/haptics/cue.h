#pragma once

#include <cstdint>

namespace felt {

/// Waveforms of consumer haptic devices, as defined on page 0x0E of the HID Usage Tables. Drivers
/// of other device families convert them to their own waveforms. Waveforms of the first group are
/// continuous; those of the second play once.
enum class CueWaveform : std::uint8_t {
  kNone,
  // Continuous waveforms: how the nib rubs on the surface.
  kInk,
  kPencil,
  kMarker,
  kChiselMarker,
  kBrush,
  kEraser,
  kBuzz,  ///< any other rubbing
  // Single waveforms: something happened.
  kClick,    ///< a tool grabbed something
  kPress,    ///< the nib touches
  kRelease,  ///< the nib lifts
  kHover,    ///< something can be grabbed here
  kSuccess,  ///< an end snapped, a curve closed
  kError,    ///< nothing can be grabbed here
};

/// Time that a continuous waveform plays if it is not repeated.
inline constexpr std::int64_t kCueHoldNs = 400'000'000;

/// Returns true for the waveforms that play until the next cue.
constexpr bool is_continuous(CueWaveform waveform) noexcept {
  return waveform >= CueWaveform::kInk && waveform <= CueWaveform::kBuzz;
}

/// A request to a cue device: a waveform and its intensity, 0..1. A continuous waveform plays until
/// the next cue of any kind, or until kCueHoldNs have passed. To play it for longer, send it again.
/// The limit ensures that a program that stops responding does not leave a device humming. kNone is
/// silence. Trivially copyable.
struct Cue {
  CueWaveform waveform = CueWaveform::kNone;
  double intensity = 0.0;

  friend constexpr bool operator==(const Cue&, const Cue&) noexcept = default;
};

}  // namespace felt
