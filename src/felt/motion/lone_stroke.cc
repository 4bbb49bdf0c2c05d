#include "felt/motion/lone_stroke.h"

#include <cmath>
#include <utility>

#include "felt/motion/line_features.h"
#include "felt/motion/mend_blend.h"
#include "felt/stroke/edit/split.h"

namespace felt {

std::optional<Stroke> lone_stroke_at(const LoneMotion& lone, const Similarity& motion, double t,
                                     LoneStroke how) {
  const double share = lone.appears ? t : 1.0 - t;
  StrokeData data = lone.stroke->data();
  for (Point& p : data.points) {
    p = lone.appears ? moved(motion, moved_back(motion, p - lone.shift), t) + t * lone.shift
                     : moved(motion, p, t) + t * lone.shift;
  }
  if (data.closed) data.points.back() = data.points.front();
  if (how == LoneStroke::kFade) {
    data.color.a = static_cast<std::uint8_t>(std::lround(share * data.color.a));
    if (data.color.a == 0) return std::nullopt;
  }
  Result<Stroke> stroke = mended_blend(std::move(data));
  if (!stroke) return std::nullopt;
  if (how == LoneStroke::kFade) return *std::move(stroke);
  const StepLengths lengths(*stroke);
  Result<Stroke> part = sub_stroke(*stroke, 0.0, lengths.u_at(share * lengths.length_mm()));
  if (!part) return std::nullopt;
  return *std::move(part);
}

Vec shift_near(std::span<const LocalMotion> motions, Point p, double near_mm) noexcept {
  Vec sum{};
  double weights = 0.0;
  for (const LocalMotion& motion : motions) {
    const double weight = 1.0 / (distance_squared(motion.place, p) + near_mm * near_mm);
    sum += weight * motion.shift;
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : Vec{};
}

}  // namespace felt
