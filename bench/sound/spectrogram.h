#pragma once

#include <vector>

#include "felt/render/image.h"

namespace felt::bench {

/// Draws what a sound is made of over time into a picture: 60 Hz at the bottom to 20 kHz at the
/// top, by octaves; black is 70 dB below the loudest that is shown anywhere, a full scale of -20
/// dB.
void draw_spectrogram(const std::vector<float>& sound, Pixels into, PixelRect where);

/// Where a frequency is in `where`, in pixels from the top of the picture.
double spectrogram_y(double hz, PixelRect where) noexcept;

}  // namespace felt::bench
