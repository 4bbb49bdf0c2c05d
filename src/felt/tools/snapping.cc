#include "felt/tools/snapping.h"

#include <algorithm>

namespace felt {

WellShape well_of(const SnapOptions& options, double strength, double slope_n_per_mm) noexcept {
  const double quarter = 0.25 * options.reach_mm;
  const double core = std::clamp(options.force_n / slope_n_per_mm, quarter, 3.0 * quarter);
  WellShape shape{.radius_mm = options.reach_mm,
                  .core_mm = core,
                  .rim_mm = quarter,
                  .force_n = strength * std::min(options.force_n, slope_n_per_mm * core)};
  shape.damping_n_s_per_m *= strength;
  return shape;
}

bool is_still_there(const SnapTarget& target, const Document& document) {
  if (target.is_own_start()) return true;
  const StrokePtr stroke = document.find(target.tip.stroke);
  if (!stroke || !document.layer(document.layer_of(target.tip.stroke))->visible) return false;
  return target.on_curve ||
         (!stroke->closed() && tip_point(*stroke, target.tip.tip) == target.point);
}

void SnapFinder::reset() noexcept {
  *this = {};
}

void SnapFinder::drag(TipId tip) noexcept {
  *this = {};
  dragged_ = tip;
}

const std::optional<SnapTarget>& SnapFinder::update(Point end, const SnapOptions& options,
                                                    const Document& document,
                                                    const StrokeIndex& index) {
  if (options.mode == SnapMode::kOff) {
    target_.reset();
    return target_;
  }
  const std::span<const TipId> except =
      dragged_ ? std::span<const TipId>(&*dragged_, 1) : std::span<const TipId>();
  const double within_mm = std::max(options.reach_mm, options.radius_mm);
  const auto hit = index.nearest_tip(document, end, within_mm, except);
  const bool keep =
      target_ && hit && is_still_there(*target_, document) &&
      distance(end, target_->point) <= std::min(hit->distance_mm + kHysteresisMm, within_mm);
  if (keep) return target_;
  target_.reset();
  if (hit) target_ = SnapTarget{hit->id, hit->point};
  return target_;
}

}  // namespace felt
