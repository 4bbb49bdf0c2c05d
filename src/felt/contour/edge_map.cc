#include "felt/contour/edge_map.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace felt::contour {
namespace {

constexpr double kRootTau = 2.5066282746310002;
// A weak pixel belongs to a contour if it is connected with a strong one.
constexpr double kWeakShare = 0.4;
// What noise alone gives is at most this many times its median.
constexpr double kNoiseFactor = 6.0;
constexpr double kFirstScale = 1.0 / 8.0, kSecondScale = 1.0 / 4.0;  // of Sobel's sums, per pixel
constexpr double kFixed = 64.0;  // of the whole numbers that cv::Canny() needs

/// Returns the middle of all values. At least half of a picture has neither edge nor line, so this
/// is what its noise gives.
double median_of(const cv::Mat1f& values) {
  std::vector<float> sorted(values.begin(), values.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  return static_cast<double>(*middle);
}

EdgeMap map_like(const cv::Mat1f& grey) {
  return {cv::Mat1b(grey.size(), EdgeMap::kNone), cv::Mat2f(grey.size(), cv::Vec2f(0, 0)),
          cv::Mat1f(grey.size(), 0.0F)};
}

cv::Mat1f blurred(const cv::Mat1f& grey, double sigma_px) {
  cv::Mat1f out;
  cv::GaussianBlur(grey, out, cv::Size(), sigma_px, sigma_px, cv::BORDER_REPLICATE);
  return out;
}

cv::Mat1f derivative(const cv::Mat1f& grey, int dx, int dy) {
  cv::Mat1f out;
  cv::Sobel(grey, out, CV_32F, dx, dy, 3, dx + dy == 1 ? kFirstScale : kSecondScale, 0.0,
            cv::BORDER_REPLICATE);
  return out;
}

/// The derivatives of a picture at a pixel.
struct Derivatives {
  explicit Derivatives(const cv::Mat1f& grey)
      : x(derivative(grey, 1, 0)),
        y(derivative(grey, 0, 1)),
        xx(derivative(grey, 2, 0)),
        xy(derivative(grey, 1, 1)),
        yy(derivative(grey, 0, 2)) {}

  cv::Mat1f x, y, xx, xy, yy;
};

/// The largest curvature of the grey values at a pixel, and the unit vector along it.
struct Curvature {
  float size = 0.0F;
  cv::Vec2f along;
};

/// Returns the eigenvalue of the Hessian with the largest size, and its eigenvector.
Curvature curvature_at(const Derivatives& d, int row, int column) {
  const float xx = d.xx(row, column), xy = d.xy(row, column), yy = d.yy(row, column);
  const float half = 0.5F * (xx - yy), mean = 0.5F * (xx + yy);
  const float size = mean + std::copysign(std::hypot(half, xy), mean);
  const cv::Vec2f a(xy, size - xx), b(size - yy, xy);
  const cv::Vec2f along = a.dot(a) > b.dot(b) ? a : b;
  const float length = std::sqrt(along.dot(along));
  if (!(length > 0.0F)) return {size, cv::Vec2f(1.0F, 0.0F)};
  return {size, along / length};
}

float interpolated(const cv::Mat1f& values, float x, float y) {
  const int column = std::clamp(static_cast<int>(std::floor(x)), 0, values.cols - 2);
  const int row = std::clamp(static_cast<int>(std::floor(y)), 0, values.rows - 2);
  const float u = std::clamp(x - static_cast<float>(column), 0.0F, 1.0F);
  const float v = std::clamp(y - static_cast<float>(row), 0.0F, 1.0F);
  return (1.0F - v) * ((1.0F - u) * values(row, column) + u * values(row, column + 1)) +
         v * ((1.0F - u) * values(row + 1, column) + u * values(row + 1, column + 1));
}

/// Returns where the largest value is, from a pixel along a unit vector: the top of the parabola
/// through three values.
float offset_of_top(const cv::Mat1f& values, int row, int column, cv::Vec2f across) {
  const auto x = static_cast<float>(column), y = static_cast<float>(row);
  const float before = interpolated(values, x - across[0], y - across[1]);
  const float after = interpolated(values, x + across[0], y + across[1]);
  const float bend = before - 2.0F * values(row, column) + after;
  return bend < 0.0F ? std::clamp(0.5F * (before - after) / bend, -1.0F, 1.0F) : 0.0F;
}

}  // namespace

EdgeMap lines_of(const cv::Mat1f& grey, const EdgeSearch& search) {
  // Half of the widest line that is found (Steger 1998, sections 2.1 and 2.2), and the curvature of
  // a line of a fifth of that width.
  const double sigma = search.line_sigma_px, half_px = 0.2 * std::sqrt(3.0) * sigma;
  const double thin = 2.0 * search.contrast * half_px / (kRootTau * sigma * sigma * sigma);
  const Derivatives d(blurred(grey, sigma));
  EdgeMap map = map_like(grey);
  cv::Mat1f sizes(grey.size(), 0.0F);
  for (int row = 0; row < grey.rows; ++row) {
    for (int column = 0; column < grey.cols; ++column) {
      const Curvature c = curvature_at(d, row, column);
      sizes(row, column) = std::fabs(c.size);
      map.across(row, column) = c.along;
      if (c.size == 0.0F) continue;
      const float slope = d.x(row, column) * c.along[0] + d.y(row, column) * c.along[1];
      map.offset(row, column) = -slope / c.size;
    }
  }
  const double strong = std::max(thin, kNoiseFactor * median_of(sizes));
  for (int row = 0; row < grey.rows; ++row) {
    for (int column = 0; column < grey.cols; ++column) {
      const cv::Vec2f off = map.offset(row, column) * map.across(row, column);
      // The top of the ridge is in this pixel, or on its border.
      if (std::max(std::fabs(off[0]), std::fabs(off[1])) > 0.55F) continue;
      const double size = static_cast<double>(sizes(row, column));
      if (size > kWeakShare * strong) map.level(row, column) = EdgeMap::kWeak;
      if (size > strong) map.level(row, column) = EdgeMap::kStrong;
    }
  }
  return map;
}

EdgeMap edges_of(const cv::Mat1f& grey, const EdgeSearch& search) {
  const cv::Mat1f smooth = blurred(grey, search.edge_sigma_px);
  const cv::Mat1f x = derivative(smooth, 1, 0), y = derivative(smooth, 0, 1);
  cv::Mat1f slope;
  cv::magnitude(x, y, slope);
  // The slope in the middle of a step that is as high as the contrast.
  const double strong = std::max(search.contrast / (kRootTau * search.edge_sigma_px),
                                 kNoiseFactor * median_of(slope));
  cv::Mat1s x_fixed, y_fixed;
  x.convertTo(x_fixed, CV_16S, kFixed);
  y.convertTo(y_fixed, CV_16S, kFixed);
  cv::Mat1b found;
  cv::Canny(x_fixed, y_fixed, found, kFixed * kWeakShare * strong, kFixed * strong, true);
  EdgeMap map = map_like(grey);
  for (int row = 0; row < grey.rows; ++row) {
    for (int column = 0; column < grey.cols; ++column) {
      if (found(row, column) == 0 || slope(row, column) == 0.0F) continue;
      const cv::Vec2f across = cv::Vec2f(x(row, column), y(row, column)) / slope(row, column);
      map.level(row, column) = EdgeMap::kStrong;
      map.across(row, column) = across;
      map.offset(row, column) = offset_of_top(slope, row, column, across);
    }
  }
  return map;
}

}  // namespace felt::contour
