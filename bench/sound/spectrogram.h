#pragma once

#include <vector>

#include "felt/render/image.h"

namespace felt::bench {

/// Draws the spectrogram of a sound into a picture. The frequency axis is logarithmic, from 60 Hz
/// at the bottom to 20 kHz at the top. The colours show levels from -90 dB (black) to -25 dB
/// (nearly white) of a full-scale sine, and are the same for every sound.
void draw_spectrogram(const std::vector<float>& sound, Pixels into, PixelRect where);

/// Returns the position of a frequency in `where`, in pixels from the top of the picture.
double spectrogram_y(double hz, PixelRect where) noexcept;

}  // namespace felt::bench
