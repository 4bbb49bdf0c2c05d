#include "felt/contour/find_contours.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>

#include "felt/contour/chains.h"
#include "felt/contour/edge_map.h"
#include "felt/geometry/polyline.h"

namespace felt {
namespace {

// The picture is searched at this resolution, or at its own if that is coarser: a fifth of the
// distance within which a pen is held.
constexpr double kSearchMm = 0.2;
constexpr double kLineSigmaMm = 0.45, kEdgeSigmaMm = 0.25;
constexpr double kMinSigmaPx = 1.0;
// Edges that are nearer to the middle of a line are the two sides of that line.
constexpr double kSideMm = 1.1;
constexpr double kSmoothMm = 0.4;
constexpr double kToleranceMm = 0.02;  // of the polylines
constexpr double kMinSidePx = 4.0;
constexpr int kMaxSidePx = 8'192;

using Contour = std::vector<Point>;

Result<void> check(const GreyPicture& picture, const ContourSearch& search) {
  const auto bad = [](const char* what) { return fail(ErrorCode::kInvalidArgument, what); };
  const int w = picture.width_px, h = picture.height_px;
  if (w < 1 || h < 1 || w > kMaxSidePx || h > kMaxSidePx) {
    return bad("picture: a side has no pixel, or more than 8192");
  }
  if (picture.grey.size() != static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {
    return bad("picture: does not have one value for each pixel");
  }
  if (!(search.mm_per_px > 0.0) || !std::isfinite(search.mm_per_px)) {
    return bad("mm_per_px: is not above 0");
  }
  if (!(search.contrast > 0.0 && search.contrast <= 255.0)) return bad("contrast: is not 0..255");
  if (!(search.min_mm >= 0.0)) return bad("min_mm: is below 0");
  return {};
}

double length_of(const Contour& line) {
  double sum = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

/// Returns the picture at the resolution of the search.
cv::Mat1f searched(const GreyPicture& picture, double factor) {
  cv::Mat1b whole(picture.height_px, picture.width_px);
  std::copy(picture.grey.begin(), picture.grey.end(), whole.begin());
  cv::Mat reduced = whole;
  if (factor < 1.0) cv::resize(whole, reduced, cv::Size(), factor, factor, cv::INTER_AREA);
  cv::Mat1f grey;
  reduced.convertTo(grey, CV_32F);
  return grey;
}

/// Returns the lines that are long enough, smooth.
std::vector<Contour> smooth_lines(std::vector<Contour> lines, double min_px, double sigma_px) {
  std::vector<Contour> kept;
  for (Contour& line : lines) {
    if (length_of(line) >= min_px) kept.push_back(contour::smoothed(line, sigma_px));
  }
  return kept;
}

/// Removes the edges beside lines, which are the sides of these lines.
void remove_sides(contour::EdgeMap& edges, const std::vector<Contour>& lines, double side_px) {
  constexpr int kShift = 4;  // positions are in sixteenths of a pixel
  for (const Contour& line : lines) {
    std::vector<cv::Point> points;
    for (const Point& p : line) {
      points.emplace_back(cvRound(std::ldexp(p.x, kShift)), cvRound(std::ldexp(p.y, kShift)));
    }
    cv::polylines(edges.level, points, false, cv::Scalar(contour::EdgeMap::kNone),
                  std::max(1, cvRound(2.0 * side_px)), cv::LINE_8, kShift);
  }
}

/// Returns a polyline with fewer points.
Contour simplified(const Contour& line, double tolerance_px) {
  std::vector<cv::Point2f> points, kept;
  for (const Point& p : line) {
    points.emplace_back(static_cast<float>(p.x), static_cast<float>(p.y));
  }
  const bool is_closed = line.size() > 3 && line.front() == line.back();
  if (is_closed) points.pop_back();
  cv::approxPolyDP(points, kept, tolerance_px, is_closed);
  if (is_closed) kept.push_back(kept.front());
  Contour out;
  for (const cv::Point2f& p : kept) {
    out.push_back({static_cast<double>(p.x), static_cast<double>(p.y)});
  }
  return out;
}

/// Keeps the longest contours, within the limits.
void limit(std::vector<Contour>& contours, const ContourSearch& search) {
  std::stable_sort(contours.begin(), contours.end(),
                   [](const Contour& a, const Contour& b) { return length_of(a) > length_of(b); });
  std::size_t points = 0, kept = 0;
  while (kept < contours.size() && kept < search.max_contours &&
         points + contours[kept].size() <= search.max_points) {
    points += contours[kept++].size();
  }
  contours.resize(kept);
}

/// Returns the contours in a picture whose settings are valid.
std::vector<Contour> contours_in(const GreyPicture& picture, const ContourSearch& search) {
  const double factor = std::min(1.0, search.mm_per_px / kSearchMm);
  if (factor * std::min(picture.width_px, picture.height_px) < kMinSidePx) return {};
  const cv::Mat1f grey = searched(picture, factor);
  const double mm = search.mm_per_px / factor;  // of a pixel that is searched
  const contour::EdgeSearch sizes{search.contrast, std::max(kMinSigmaPx, kLineSigmaMm / mm),
                                  std::max(kMinSigmaPx, kEdgeSigmaMm / mm)};
  const auto lines_in = [&](const contour::EdgeMap& map) {
    return smooth_lines(contour::chains_of(map), search.min_mm / mm, std::max(1.0, kSmoothMm / mm));
  };
  std::vector<Contour> contours = lines_in(contour::lines_of(grey, sizes));
  contour::EdgeMap edges = contour::edges_of(grey, sizes);
  remove_sides(edges, contours, kSideMm / mm);
  for (Contour& edge : lines_in(edges)) contours.push_back(std::move(edge));
  const double scale_x = static_cast<double>(picture.width_px) / grey.cols;
  const double scale_y = static_cast<double>(picture.height_px) / grey.rows;
  for (Contour& line : contours) {
    line = simplified(line, kToleranceMm / mm);
    for (Point& p : line) p = {(p.x + 0.5) * scale_x, (p.y + 0.5) * scale_y};
  }
  limit(contours, search);
  return contours;
}

}  // namespace

Result<std::vector<std::vector<Point>>> find_contours(const GreyPicture& picture,
                                                      const ContourSearch& search) {
  if (Result<void> fine = check(picture, search); !fine) return tl::unexpected(fine.error());
  try {
    return contours_in(picture, search);
  } catch (const cv::Exception& e) {  // memory, for example
    return fail(ErrorCode::kUnsupported, "picture: " + e.err);
  }
}

}  // namespace felt
