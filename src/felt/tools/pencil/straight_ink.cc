#include "felt/tools/pencil/straight_ink.h"

#include <algorithm>
#include <utility>

#include "felt/stroke/fit/width_fitter.h"
#include "felt/tools/direction_steps.h"

namespace felt {
namespace {

Cubic straight_piece(Point from, Point to) {
  return {{from, lerp(from, to, 1.0 / 3.0), lerp(from, to, 2.0 / 3.0), to}};
}

}  // namespace

void StraightInk::begin(Point start, const WidthMapOptions& widths) {
  start_ = pen_ = start;
  widths_ = WidthMap(widths);
  places_.clear();
}

void StraightInk::push(const InkSample& sample) {
  pen_ = sample.position;
  const InkWidth ink = widths_.push(sample);
  const double distance_mm = distance(start_, pen_);
  while (places_.size() > 1 && places_.back().distance_mm > distance_mm) places_.pop_back();
  // At the start, the pressure still grows, so the first place has the latest width.
  if (places_.size() <= 1) places_.assign(1, {0.0, ink});
  if (distance_mm >= places_.back().distance_mm + kPlaceMm) places_.push_back({distance_mm, ink});
}

Point StraightInk::pen_in_steps() const noexcept {
  return start_ + in_direction_steps(pen_ - start_);
}

double StraightInk::share(const Place& place) const noexcept {
  const double length_mm = distance(start_, pen_);
  return length_mm > 0.0 ? std::min(place.distance_mm / length_mm, 1.0) : 0.0;
}

std::optional<Stroke> StraightInk::stroke(Point from, Point to,
                                          const InkFitOptions& options) const {
  if (places_.empty() || distance(from, to) < kMinSegmentMm) return std::nullopt;
  WidthFitter width(options.width);
  width.begin();
  const auto add = [&](double u, const InkWidth& ink) {
    if (options.width_map.tone) {
      width.push(u, ink.width_mm, ink.tone);
    } else {
      width.push(u, ink.width_mm);
    }
  };
  for (const Place& place : places_) add(share(place), place.ink);
  add(1.0, places_.back().ink);
  width.finish(1.0);
  StrokeData data;
  const Cubic line = straight_piece(from, to);
  data.points.assign(line.p.begin(), line.p.end());
  data.widths.assign(width.knots().begin(), width.knots().end());
  data.medium = options.medium;
  Result<Stroke> stroke = Stroke::create(std::move(data));
  if (!stroke) return std::nullopt;
  return *std::move(stroke);
}

void StraightInk::draw(Point from, Point to, Overlay& overlay) const {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& a = places_[i];
    const bool is_last = i + 1 == places_.size();
    const Place& b = is_last ? a : places_[i + 1];
    const Point end = is_last ? to : lerp(from, to, share(b));
    overlay.ink.push_back({straight_piece(lerp(from, to, share(a)), end), a.ink.width_mm,
                           b.ink.width_mm, a.ink.tone, b.ink.tone});
  }
}

}  // namespace felt
