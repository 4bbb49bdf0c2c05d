#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "felt/base/result.h"
#include "felt/geometry/point.h"

namespace felt {

/// A grey picture: `width_px * height_px` values row by row, 0 black to 255 white.
struct GreyPicture {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> grey;
};

/// Settings of find_contours().
struct ContourSearch {
  double mm_per_px = 0.1;  ///< size of a pixel on the page, mm, above 0
  /// Smallest contrast of an edge or a line, of 255. Noise of the picture raises it.
  double contrast = 20.0;
  double min_mm = 6.0;  ///< shorter contours are left out
  std::size_t max_contours = 1'000;
  std::size_t max_points = 20'000;  ///< of all contours; the longest contours are kept
};

/// Finds the contours of a picture that a pen can follow: the middle of each line up to 1.5 mm wide
/// (a ridge of the picture, Steger 1998, https://doi.org/10.1109/34.659930) and the edge between
/// areas (Canny 1986, https://doi.org/10.1109/TPAMI.1986.4767851). They are smooth polylines, the
/// longest first, in pixels: (0, 0) is the top left corner of the picture. The last point of a
/// closed contour is its first. Fails if the picture does not have as many values as pixels, if it
/// has none, or if a setting is out of range. Takes time linear in the pixels, and about 0.1 s for
/// a page; call it off the haptic thread. The same picture gives the same contours.
Result<std::vector<std::vector<Point>>> find_contours(const GreyPicture& picture,
                                                      const ContourSearch& search);

}  // namespace felt
