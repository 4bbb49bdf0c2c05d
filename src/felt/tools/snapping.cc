#include "felt/tools/snapping.h"

#include <algorithm>

namespace felt {

WellShape well_of(const SnapOptions& options) noexcept {
  return {.radius_mm = options.reach_mm,
          .core_mm = 0.25 * options.reach_mm,
          .rim_mm = 0.25 * options.reach_mm,
          .force_n = options.force_n};
}

void SnapFinder::reset() noexcept {
  *this = {};
}

void SnapFinder::begin(Point start, std::optional<TipId> connected) noexcept {
  *this = {};
  start_ = start;
  path_end_ = start;
  connected_ = connected;
}

void SnapFinder::drag(TipId tip) noexcept {
  *this = {};
  connected_ = tip;
}

const std::optional<SnapTarget>& SnapFinder::update(Point pen, const SnapOptions& options,
                                                    const Document& document,
                                                    const StrokeIndex& index) {
  if (start_) travel(pen, options.reach_mm);
  if (options.mode == SnapMode::kOff) {
    target_.reset();
    return target_;
  }
  const std::span<const TipId> except =
      connected_ ? std::span<const TipId>(&*connected_, 1) : std::span<const TipId>();
  const double within_mm = std::max(options.reach_mm, options.radius_mm);
  std::optional<SnapTarget> nearest;
  double nearest_mm = within_mm;
  if (const auto hit = index.nearest_tip(document, pen, within_mm, except)) {
    nearest = SnapTarget{hit->id, hit->point};
    nearest_mm = hit->distance_mm;
  }
  if (armed_ && distance(pen, *start_) <= nearest_mm) {
    nearest = SnapTarget{{}, *start_};
    nearest_mm = distance(pen, *start_);
  }
  const bool keep =
      target_ && nearest && is_still_there(*target_, document) &&
      distance(pen, target_->point) <= std::min(nearest_mm + kHysteresisMm, within_mm);
  if (!keep) target_ = nearest;
  return target_;
}

void SnapFinder::travel(Point pen, double reach_mm) noexcept {
  const double step = distance(path_end_, pen);
  if (step >= kPathStepMm) {
    path_mm_ += step;
    path_end_ = pen;
  }
  has_left_ = has_left_ || distance(pen, *start_) > reach_mm;
  armed_ = armed_ || (has_left_ && path_mm_ > kArmingReaches * reach_mm);
}

bool SnapFinder::is_still_there(const SnapTarget& target, const Document& document) const {
  if (target.is_own_start()) return armed_ && start_ == target.point;
  const StrokePtr stroke = document.find(target.tip.stroke);
  return stroke && !stroke->closed() && tip_point(*stroke, target.tip.tip) == target.point &&
         document.layer(document.layer_of(target.tip.stroke))->visible;
}

}  // namespace felt
