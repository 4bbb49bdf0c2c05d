#include "felt/session/symmetry_edit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "felt/session/layered_edit.h"
#include "felt/stroke/edit/mend_joints.h"

namespace felt {
namespace {

/// Two strokes whose control points differ by less are the same stroke.
constexpr double kSameStrokeMm = 1e-6;

bool are_near(Point a, Point b) noexcept {
  return std::abs(a.x - b.x) < kSameStrokeMm && std::abs(a.y - b.y) < kSameStrokeMm;
}

/// Returns true if both strokes have the same curve, in the same or in the opposite direction.
bool coincide(const Stroke& a, const Stroke& b) {
  const std::vector<Point>&p = a.data().points, &q = b.data().points;
  if (p.size() != q.size()) return false;
  return std::equal(p.begin(), p.end(), q.begin(), are_near) ||
         std::equal(p.begin(), p.end(), q.rbegin(), are_near);
}

/// Returns true if the change adds a stroke, or lengthens one as drawing on from its end does.
bool adds_ink(const StrokeChange& c) {
  if (!c.after) return false;
  if (!c.before) return true;
  constexpr double kLongerMm = 1.0;
  const auto length_mm = [](const Stroke& stroke) {
    double sum_mm = 0.0;
    const std::vector<Point>& p = stroke.data().points;
    for (std::size_t i = 1; i < p.size(); ++i) sum_mm += distance(p[i - 1], p[i]);
    return sum_mm;
  };
  return length_mm(*c.after) > length_mm(*c.before) + kLongerMm;
}

/// Returns the strokes with new ink that are in no group, neither before the edit nor after it.
std::vector<StrokeId> strokes_without_group(const Document& document, const Edit& edit) {
  std::set<StrokeId> linked;
  for (const SymmetryChange& c : edit.symmetries) {
    if (!c.after) continue;
    for (const SymmetryImage& image : c.after->images) linked.insert(image.stroke);
  }
  std::vector<StrokeId> free;
  for (const StrokeChange& c : edit.changes) {
    if (adds_ink(c) && !linked.contains(c.id) && !document.symmetry_of(c.id)) {
      free.push_back(c.id);
    }
  }
  return free;
}

}  // namespace

StrokePtr mirrored(const Stroke& stroke, const Affine& map) {
  StrokeData data = stroke.data();
  for (Point& p : data.points) p = apply(map, p);
  // A closed stroke repeats its first point bit for bit, and equal points have equal images.
  Result<Stroke> image = Stroke::create(data);
  if (!image) {
    mend_rounding(data);  // a smooth joint with very short handles may turn by rounding
    image = Stroke::create(std::move(data));
  }
  return image ? std::make_shared<const Stroke>(*std::move(image)) : nullptr;
}

namespace {

/// Returns the images of a stroke, each with its number, without those that coincide with another
/// one; nothing if one of them would be far outside of any page.
std::vector<std::pair<int, StrokePtr>> images_of(const StrokePtr& original,
                                                 const SymmetryGroup& group) {
  std::vector<std::pair<int, StrokePtr>> images{{0, original}};
  for (int image = 1; image < 2 * group.axes; ++image) {
    StrokePtr stroke = mirrored(*original, image_map(group, image));
    if (!stroke) return {};
    if (std::none_of(images.begin(), images.end(),
                     [&](const auto& other) { return coincide(*other.second, *stroke); })) {
      images.emplace_back(image, std::move(stroke));
    }
  }
  images.erase(images.begin());
  return images;
}

}  // namespace

void add_images(const Document& document, const DrawingGuide& symmetry, Edit& edit) {
  const std::vector<StrokeId> added = strokes_without_group(document, edit);
  if (added.empty()) return;
  LayeredEdit layered(document, edit);
  for (const StrokeId id : added) {
    SymmetryGroup group{symmetry.origin, symmetry.angle_rad, symmetry.axes, {{id, 0}}};
    StrokeId below = id;
    for (auto& [image, stroke] : images_of(layered.after(id), group)) {
      below = layered.add_above(below, std::move(stroke));
      group.images.push_back({below, image});
    }
    if (group.images.size() > 1) layered.add_group(std::move(group));
  }
  layered.finish();
}

Edit unlink_edit(const Document& document, const Selection& selection) {
  std::set<SymmetryId> groups;
  for (const auto& [id, marks] : selection.strokes()) {
    if (selection.is_whole(id)) groups.insert(document.symmetry_of(id));
  }
  Edit edit{"Unlink", {}};
  for (const SymmetryId id : groups) {
    if (id) edit.symmetries.push_back({id, document.find_symmetry(id), nullptr});
  }
  return edit;
}

}  // namespace felt
