#include "felt/tools/medium_line.h"

#include <algorithm>

namespace felt {
namespace {

/// Returns true if the width alone determines the pressure: at pressure p, tone_of_width() of the
/// width is p. This holds for the default range without gamma or tilt.
bool says_it_all(const WidthMapOptions& widths) {
  const WidthMapOptions usual;
  return widths.gamma == 1.0 && widths.tilt_width == 1.0 && widths.min_mm == usual.min_mm &&
         widths.max_mm == usual.max_mm;
}

}  // namespace

InkFitOptions drawn_with(const Medium& medium, InkFitOptions ink) {
  const MediumLine& line = medium.line;
  ink.medium = medium.id;
  WidthMapOptions& widths = ink.width_map;
  widths.tilt_width = std::max(line.tilt_width, 1.0);
  ink.width.max_mm *= widths.tilt_width;
  const ToneMapOptions tone{line.tone_light, line.tone_heavy, line.tone_gamma, line.tilt_tone};
  if (tone != ToneMapOptions{} || !says_it_all(widths)) widths.tone = tone;
  return ink;
}

}  // namespace felt
