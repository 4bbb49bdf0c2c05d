#include <algorithm>
#include <utility>

#include "web/page/core/picture.h"

namespace felt::page {
namespace {

/// Adds the bounds of a segment with its width.
void add_area(const Overlay::InkSegment& segment, std::span<const Affine> images,
              InkDamage& damage) {
  const auto add = [&damage](const Overlay::InkSegment& s) {
    const double width = std::max({s.start_width_mm, s.end_width_mm, kMinWidthMm});
    damage.push_back(bounds(s.curve).inflated(0.5 * width));
  };
  add(segment);
  for (const Affine& image : images) add(mapped(segment, image));
}

/// The shortest segment of a stroke is 0.05 mm long (invariant I5).
constexpr double kShortMm = 0.06;

/// Makes a stroke of segments that follow each other. Leaves out those that are too short for a
/// stroke; a dot becomes a short line.
StrokePtr stroke_of(std::span<const Overlay::InkSegment> segments, Rgba color,
                    const std::string& medium) {
  const auto width = [](double mm) { return std::max(mm, kMinWidthMm); };
  StrokeData data;
  const Overlay::InkSegment& first = segments.front();
  data.points.push_back(first.curve.p[0]);
  data.widths.push_back({0.0, width(first.start_width_mm), first.start_tone});
  for (const Overlay::InkSegment& s : segments) {
    const Point from = data.points.back();
    const bool is_last = &s == &segments.back();
    Cubic curve = s.curve;
    curve.p[0] = from;
    if (control_length(curve) < kShortMm) {
      if (!is_last || data.points.size() > 1) continue;
      curve = straight(from, from + Vec{kShortMm, 0.0});
    }
    data.points.insert(data.points.end(), curve.p.begin() + 1, curve.p.end());
    data.widths.push_back({data.widths.back().u + 1.0, width(s.end_width_mm), s.end_tone});
  }
  data.joints.assign(data.widths.size() - 2, JointKind::kCorner);
  data.color = color;
  data.medium = medium;
  Result<Stroke> stroke = Stroke::create(std::move(data));
  return stroke ? std::make_shared<const Stroke>(*std::move(stroke)) : nullptr;
}

}  // namespace

void WetInk::update(const Overlay& overlay, const std::string& medium, InkDamage& damage) {
  const bool is_same_look =
      overlay.ink_color == color_ && medium == medium_ && overlay.ink_images == images_;
  std::size_t same = 0;
  if (is_same_look) {
    const std::size_t most = std::min(segments_.size(), overlay.ink.size());
    while (same < most && segments_[same] == overlay.ink[same]) ++same;
  }
  if (same == segments_.size() && same == overlay.ink.size()) return;
  for (std::size_t i = same; i < segments_.size(); ++i) add_area(segments_[i], images_, damage);
  segments_.assign(overlay.ink.begin(), overlay.ink.end());
  images_ = overlay.ink_images;
  color_ = overlay.ink_color;
  medium_ = medium;
  for (std::size_t i = same; i < segments_.size(); ++i) add_area(segments_[i], images_, damage);
  remake();
}

void WetInk::remake() {
  strokes_.clear();
  const auto add = [this](std::span<const Overlay::InkSegment> all) {
    for (std::size_t first = 0, i = 1; i <= all.size(); ++i) {
      if (i < all.size() && all[i].curve.p[0] == all[i - 1].curve.p[3]) continue;
      if (StrokePtr stroke = stroke_of(all.subspan(first, i - first), color_, medium_)) {
        strokes_.push_back(std::move(stroke));
      }
      first = i;
    }
  };
  add(segments_);
  for (const Affine& image : images_) {
    std::vector<Overlay::InkSegment> there;
    for (const Overlay::InkSegment& s : segments_) there.push_back(mapped(s, image));
    add(there);
  }
}

}  // namespace felt::page
