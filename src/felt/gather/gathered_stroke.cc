#include "felt/gather/gathered_stroke.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "felt/gather/bundle_path.h"
#include "felt/gather/copied_lines.h"
#include "felt/gather/percentile.h"
#include "felt/geometry/polyline.h"
#include "felt/geometry/rect.h"
#include "felt/stroke/edit/join.h"
#include "felt/stroke/fit/ink_fitter.h"

namespace felt {
namespace {

constexpr double kPointsPerSegment = 16.0, kMaxPointsPerSegment = 1024.0;

// Returns the median of the strokes' tones, where the tone of a stroke is its median along the
// stroke. Without it the line would get the default tone of its width, which is almost nothing for
// a thin line of a dry medium.
double middle_tone(std::span<const std::shared_ptr<const Stroke>> strokes) {
  constexpr int kTonesPerStroke = 16;
  std::vector<double> tones;
  for (const auto& stroke : strokes) {
    std::vector<double> along;
    for (int k = 0; k < kTonesPerStroke; ++k) {
      along.push_back(stroke->tone(stroke->segment_count() * (k + 0.5) / kTonesPerStroke));
    }
    tones.push_back(percentile(along, 0.5));
  }
  return percentile(tones, 0.5);
}

// Moves the end of a fitted curve exactly to its start, with its handle, and closes it.
Result<Stroke> as_ring(const Stroke& open) {
  StrokeData data = open.data();
  const Vec shift = data.points.front() - data.points.back();
  data.points[data.points.size() - 2] += shift;
  data.points.back() = data.points.front();
  return Stroke::create(std::move(data)).and_then([](const Stroke& met) { return closed(met); });
}

// Copies in a large bundle cost time and hardly move its middle.
std::vector<RoughLine> without_copies(std::vector<RoughLine> lines) {
  constexpr std::size_t kFewLines = 100;
  constexpr double kCopyOfDiagonal = 1e-3;
  if (lines.size() <= kFewLines) return lines;
  Rect box;
  for (const RoughLine& line : lines) {
    for (const Point p : line) box.extend(p);
  }
  const double tolerance_mm = kCopyOfDiagonal * std::hypot(box.width(), box.height());
  if (!(tolerance_mm > 0.0)) return lines;
  const std::vector<std::uint32_t> copy_of = copied_lines(lines, tolerance_mm);
  std::vector<RoughLine> different;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (copy_of[i] == i) different.push_back(std::move(lines[i]));
  }
  return different;
}

}  // namespace

double usual_width_mm(std::span<const std::shared_ptr<const Stroke>> strokes) {
  std::vector<double> widths;
  for (const auto& stroke : strokes) {
    widths.push_back(stroke->width_mm(stroke->segment_count() / 2.0));
  }
  return percentile(widths, 0.5);
}

RoughLine rough_line(const Stroke& stroke) {
  RoughLine line{stroke.position(0.0)};
  for (int i = 0; i < stroke.segment_count(); ++i) {
    const Cubic segment = stroke.segment(i);
    const double count =
        std::clamp(std::ceil(control_length(segment)), kPointsPerSegment, kMaxPointsPerSegment);
    for (double k = 1.0; k <= count; ++k) line.push_back(evaluate(segment, k / count));
  }
  return line;
}

Result<Stroke> gathered_stroke(std::span<const std::shared_ptr<const Stroke>> strokes,
                               const GatherOptions& options) {
  std::vector<RoughLine> lines;
  std::size_t longest = 0;
  double longest_mm = -1.0;
  for (const auto& stroke : strokes) {
    lines.push_back(rough_line(*stroke));
    const double length_mm = polyline_length(lines.back());
    if (length_mm <= longest_mm) continue;
    longest_mm = length_mm;
    longest = lines.size() - 1;
  }
  const Result<BundlePath> path = bundle_path(without_copies(std::move(lines)));
  if (!path) return tl::unexpected(path.error());
  InkFitOptions fit;
  fit.curve.tolerance_mm = options.tolerance_mm;
  fit.medium = strokes[longest]->medium();
  InkFitter fitter(fit);
  fitter.begin();
  for (const Point p : path->points) fitter.push({p, std::nullopt, std::nullopt});
  fitter.end();
  fitter.refine();
  Result<Stroke> stroke = fitter.stroke();
  if (!stroke) return stroke;
  if (path->closed) {
    if (Result<Stroke> ring = as_ring(*stroke)) stroke = std::move(ring);
  }
  StrokeData data = stroke->data();
  const double median_mm = usual_width_mm(strokes);
  const double width_mm =
      options.width == GatheredWidth::kStrip ? path->strip_mm + median_mm : median_mm;
  const double tone = middle_tone(strokes);
  data.widths = {{0.0, width_mm, tone},
                 {static_cast<double>(stroke->segment_count()), width_mm, tone}};
  data.color = strokes[longest]->color();
  return Stroke::create(std::move(data));
}

}  // namespace felt
