#pragma once

#include <span>

#include "felt/base/result.h"
#include "felt/stroke/fit/ink_fit.h"
#include "felt/stroke/steady/shake.h"

namespace felt {

/// Shortest drawing from which a Shake is measured, s, and its lowest rate of samples, Hz: more
/// than twice the highest frequency.
inline constexpr double kMinSpiralS = 4.0, kMinSpiralHz = 30.0;

/// Returns how many seconds of lines find_shake() uses.
double spiral_s(std::span<const InkSample> samples);

/// Measures how a hand shakes from a spiral, or any other smooth line, of about 10 s. Several lines
/// may follow each other in `samples`: a gap of more than 0.1 s, or a time that does not increase,
/// starts a new one, and lines of less than 2 s are not used.
///
/// The lines are resampled at 128 Hz and cut into windows of 2 s that overlap by half. In each
/// window, a parabola is removed, and a Hann window gives the spectra of x and y (Welch, IEEE
/// Trans. Audio Electroacoust. 15(2):70, 1967, DOI 10.1109/TAU.1967.1161901). The spectrum of the
/// acceleration is flat for a usual hand, so shaking is a peak of it: the frequency is the middle
/// of the highest peak from 3 to 12 Hz of the median of the windows, which a jerk in one window
/// does not change. The amplitude and the axis are those of the motion within 1 Hz of it.
///
/// Fails with a sentence for the user if there are not enough samples, if samples have no times, or
/// if no peak stands out: the hand does not shake, or less than Shake::kMinAmplitudeMm.
Result<Shake> find_shake(std::span<const InkSample> samples);

}  // namespace felt
