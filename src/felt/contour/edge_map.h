#pragma once

#include <opencv2/core.hpp>

namespace felt::contour {

/// Where a picture has an edge or a line: a set of pixels, and for each of them the direction
/// across it and how far from the middle of the pixel it is.
struct EdgeMap {
  static constexpr std::uint8_t kNone = 0, kWeak = 1, kStrong = 2;

  cv::Mat1b level;   ///< kNone, kStrong, or kWeak: part of a line if a strong pixel is
  cv::Mat2f across;  ///< unit vector
  cv::Mat1f offset;  ///< px along `across`, -1..1
};

/// Smallest contrasts, of 255, and the sizes of what is looked for, in pixels of the picture.
struct EdgeSearch {
  double contrast = 20.0;
  double line_sigma_px = 2.25;  ///< lines up to 3.4 times as wide are found
  double edge_sigma_px = 1.5;
};

/// Returns the lines of a grey picture (float, 0..255), after Steger 1998.
EdgeMap lines_of(const cv::Mat1f& grey, const EdgeSearch& search);

/// Returns the edges between areas of a grey picture (float, 0..255), after Canny 1986.
EdgeMap edges_of(const cv::Mat1f& grey, const EdgeSearch& search);

}  // namespace felt::contour
