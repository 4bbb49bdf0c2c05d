#include "felt/tools/transform/transform_frame.h"

#include <algorithm>

namespace felt {

TransformFrame::TransformFrame(const Rect& ink, const Rect& box,
                               std::optional<Point> centre) noexcept
    : frame_(ink.inflated(kMarginMm)),
      centre_(centre.value_or(lerp(Point{box.x0, box.y0}, Point{box.x1, box.y1}, 0.5))),
      has_centre_(centre.has_value()) {}

std::array<Point, 4> TransformFrame::corners() const noexcept {
  return {{{frame_.x0, frame_.y0},
           {frame_.x1, frame_.y0},
           {frame_.x1, frame_.y1},
           {frame_.x0, frame_.y1}}};
}

TransformFrame::Handles TransformFrame::handles() const noexcept {
  Handles handles;
  const auto add = [&](Point at, TransformKind kind) { handles.all[handles.count++] = {at, kind}; };
  const auto corner = corners();
  for (const Point p : corner) add(p, TransformKind::kScale);
  const Point top = lerp(corner[0], corner[1], 0.5);
  if (frame_.width() >= 4.0 * kGripMm) {
    add(top, TransformKind::kStretchY);
    add(lerp(corner[2], corner[3], 0.5), TransformKind::kStretchY);
  }
  if (frame_.height() >= 4.0 * kGripMm) {
    add(lerp(corner[1], corner[2], 0.5), TransformKind::kStretchX);
    add(lerp(corner[3], corner[0], 0.5), TransformKind::kStretchX);
  }
  add(top - Vec{0.0, kTurnMm}, TransformKind::kRotate);
  return handles;
}

std::optional<Point> TransformFrame::opposite(const Handle& handle) const noexcept {
  if (has_centre_ || handle.kind == TransformKind::kRotate) return std::nullopt;
  const Point middle = lerp(corners()[0], corners()[2], 0.5);
  const auto other_side = [](double at, double middle_of_axis, double low, double high) {
    return at > middle_of_axis ? low + kMarginMm : high - kMarginMm;
  };
  Point fixed = middle;
  if (handle.kind != TransformKind::kStretchY) {
    fixed.x = other_side(handle.at.x, middle.x, frame_.x0, frame_.x1);
  }
  if (handle.kind != TransformKind::kStretchX) {
    fixed.y = other_side(handle.at.y, middle.y, frame_.y0, frame_.y1);
  }
  return fixed;
}

bool TransformFrame::is_centre(Point p) const noexcept {
  if (empty() || distance(p, centre_) > kGripMm) return false;
  // In a small frame the user cannot grab the default centre, because moving is more important.
  const bool is_roomy = std::min(frame_.width(), frame_.height()) >= 6.0 * kGripMm;
  return is_roomy || has_centre_ || !frame_.contains(p);
}

TransformFrame::Grip TransformFrame::grip_at(Point p) const noexcept {
  if (empty()) return {};
  if (is_centre(p)) return {Part::kCentre, TransformKind::kMove, centre_};
  const Handles all = handles();
  const Handle* nearest = nullptr;
  for (std::size_t i = 0; i < all.count; ++i) {
    const Handle& h = all.all[i];
    if (distance(h.at, p) <= kGripMm &&
        (!nearest || distance(h.at, p) < distance(nearest->at, p))) {
      nearest = &h;
    }
  }
  if (nearest) return {Part::kHandle, nearest->kind, nearest->at, opposite(*nearest)};
  if (frame_.contains(p)) return {Part::kInside, TransformKind::kMove, p};
  for (const Point corner : corners()) {
    if (distance(corner, p) <= kTurnMm) return {Part::kHandle, TransformKind::kRotate, p};
  }
  return {};
}

void TransformFrame::draw(Overlay& overlay) const {
  if (empty()) return;
  const auto corner = corners();
  overlay.outlines.push_back({{corner.begin(), corner.end()}, true, Overlay::Role::kSelected});
  const Handles all = handles();
  for (std::size_t i = 0; i < all.count; ++i) {
    overlay.dots.push_back({all.all[i].at, Overlay::Role::kHandle});
  }
  const Point turn = all.all[all.count - 1].at;
  overlay.lines.push_back({turn + Vec{0.0, kTurnMm}, turn, Overlay::Role::kGuide});
  overlay.rings.push_back({turn, 1.5, Overlay::Role::kHandle});
  overlay.dots.push_back({centre_, Overlay::Role::kGuide});
}

}  // namespace felt
