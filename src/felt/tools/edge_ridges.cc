#include "felt/tools/edge_ridges.h"

#include <utility>

namespace felt {
namespace {

constexpr std::size_t kPage = 0, kBox = 1;

/// Returns the track along a rectangle, with the force of the ridge of the tool Fill.
std::optional<GuideTrack> track_along(const Rect& rect) {
  GuideLine line{.kind = GuideKind::kErrorAmplifying, .is_closed = true};
  if (!rect.empty()) {
    line.points = {{rect.x0, rect.y0}, {rect.x1, rect.y0}, {rect.x1, rect.y1}, {rect.x0, rect.y1}};
  }
  if (!check_guide(line)) return std::nullopt;
  return GuideTrack(std::move(line), 1);
}

}  // namespace

void EdgeRidges::set(const Rect& page, const Rect& box) {
  set_edge(kPage, page);
  set_edge(kBox, box);
}

void EdgeRidges::set_edge(std::size_t which, const Rect& rect) {
  Edge& edge = edges_[which];
  if (edge.rect == rect) return;
  edge = {rect, track_along(rect)};
  if (active_ == which) active_.reset();
}

void EdgeRidges::update(const PenSample& sample) {
  const Point pen = on_page(sample.position);
  std::optional<std::size_t> nearest;
  double nearest_mm = kNearMm;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    std::optional<GuideTrack>& track = edges_[i].track;
    if (!track) continue;
    track->update(sample);
    const double lead_mm = active_ == i ? kSwitchMm : 0.0;
    const double away_mm = track->guide().distance_mm(pen) - lead_mm;
    if (!(away_mm < nearest_mm)) continue;
    nearest = i;
    nearest_mm = away_mm;
  }
  const std::uint32_t hold = nearest ? edges_[*nearest].track->hold() : 0;
  if (nearest && (active_ != nearest || active_hold_ != hold)) ++hold_;
  active_ = nearest;
  active_hold_ = hold;
  if (!active_) return;
  const Guide& near = edges_[*active_].track->guide();
  GuidePiece piece = near.piece();
  piece.hold = hold_;
  guide_ = Guide(near.law(), piece);
}

}  // namespace felt
