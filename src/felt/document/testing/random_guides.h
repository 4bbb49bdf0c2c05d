#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "felt/document/document.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::testing {

/// Makes a valid guide of any kind.
inline DrawingGuide random_guide(RandomStroke& random) {
  using G = DrawingGuide;
  DrawingGuide guide;
  guide.kind = static_cast<DrawingGuideKind>(random.pick(0, int{kDrawingGuideKinds} - 1));
  guide.origin = {random.uniform(-50.0, 300.0), random.uniform(-50.0, 300.0)};
  guide.angle_rad = random.uniform(-4.0, 4.0);
  guide.size_mm = random.uniform(G::kMinSizeMm, 200.0);
  guide.second_mm = random.uniform(G::kMinSizeMm, 200.0);
  guide.step_rad = random.uniform(G::kMinStepRad, G::kMaxStepRad);
  guide.axes = random.pick(G::kMinAxes, G::kMaxAxes);
  guide.strength = random.uniform(0.0, 1.0);
  int points = 0;
  if (guide.kind == DrawingGuideKind::kPerspective) points = random.pick(1, 3);
  if (guide.kind == DrawingGuideKind::kTeacher) points = random.pick(2, 40);
  if (guide.kind == DrawingGuideKind::kTrace) {
    guide.stroke = {static_cast<std::uint64_t>(random.pick(1, 99))};
  }
  for (int i = 0; i < points; ++i) {
    guide.points.push_back({random.uniform(0.0, 200.0), random.uniform(0.0, 200.0)});
    if (guide.kind == DrawingGuideKind::kTeacher) guide.times_ms.push_back(8.0 * i);
  }
  return guide;
}

/// Makes a valid symmetry group. Its strokes need not exist.
inline SymmetryGroup random_symmetry(RandomStroke& random) {
  SymmetryGroup group{{random.uniform(0.0, 99.0), 5.5}, random.uniform(-3.0, 3.0), 1, {}};
  group.axes = random.pick(1, 16);
  auto stroke = static_cast<std::uint64_t>(random.pick(1, 1000));
  for (int image = 0; image < 2 * group.axes; ++image) {
    if (image < 2 || random.chance(0.6)) group.images.push_back({{stroke++}, image});
  }
  return group;
}

/// Makes a valid edit of the body of any kind.
inline BodyEdit random_body_edit(RandomStroke& random) {
  const auto path = [&random](int points) {
    std::vector<Vec3> made;
    for (int i = 0; i < points; ++i) {
      made.push_back(
          {random.uniform(0.0, 200.0), random.uniform(-300.0, 0.0), random.uniform(-20.0, 20.0)});
    }
    return made;
  };
  const auto byte = [&random] { return static_cast<std::uint8_t>(random.pick(0, 255)); };
  BodyEdit edit;
  edit.kind = static_cast<BodyEditKind>(random.pick(0, int{kBodyEditKindNames.size()} - 1));
  edit.path_mm = path(random.pick(2, 30));
  if (edit.kind == BodyEditKind::kExtrude) edit.profile_mm = path(random.pick(2, 30));
  const double angle = random.uniform(-3.0, 3.0);
  edit.view = {std::cos(angle), 0.0, std::sin(angle)};
  edit.width_mm = random.uniform(0.0, BodyEdit::kMaxWidthMm);
  edit.color = {byte(), byte(), byte(), byte()};
  edit.amount = random.uniform(0.0, 1.0);
  return edit;
}

/// Makes a valid timing of a key drawing. Its strokes need not exist.
inline KeyTiming random_timing(RandomStroke& random) {
  KeyTiming timing;
  timing.between = random.pick(0, KeyTiming::kMaxBetween);
  timing.hold = random.pick(1, KeyTiming::kMaxHold);
  const auto number = [&random] { return random.uniform(0.0, 1.0); };
  timing.ease = {number(), number(), number(), number()};
  auto from = static_cast<std::uint64_t>(random.pick(1, 1000)), to = from;
  for (int i = random.pick(0, 9); i > 0; --i) {
    const bool appears = random.chance(0.2), disappears = !appears && random.chance(0.2);
    timing.pairs.push_back(
        {{appears ? 0 : from++},
         {disappears ? 0 : to += static_cast<std::uint64_t>(random.pick(1, 5))}});
  }
  return timing;
}

/// Adds random changes of guides, symmetry groups and edits of the body that fit a document, for
/// property tests. New
/// objects get ids from `first_id` on.
class RandomGuides {
 public:
  explicit RandomGuides(std::uint64_t seed) : random_(seed), body_random_(seed + 1) {}

  void add_changes(const Document& document, std::uint64_t first_id, Edit& edit) {
    const auto guide = [this] {
      return std::make_shared<const DrawingGuide>(random_guide(random_));
    };
    const auto group = [this] {
      return std::make_shared<const SymmetryGroup>(random_symmetry(random_));
    };
    if (random_.chance(0.4)) edit.guides.push_back({{first_id++}, nullptr, guide()});
    if (random_.chance(0.4)) edit.symmetries.push_back({{first_id++}, nullptr, group()});
    change(random_, document.guides(), edit.guides, guide);
    change(random_, document.symmetries(), edit.symmetries, group);
    edit.toggles_guides = random_.chance(0.2);
    const auto body_edit = [this] {
      return std::make_shared<const BodyEdit>(random_body_edit(body_random_));
    };
    if (body_random_.chance(0.3)) edit.body_edits.push_back({{first_id++}, nullptr, body_edit()});
    change(body_random_, document.body_edits(), edit.body_edits, body_edit);
  }

 private:
  template <class Table, class Change, class Make>
  static void change(RandomStroke& random, const Table& table, std::vector<Change>& changes,
                     Make make) {
    for (const auto& [id, object] : table) {
      if (random.chance(0.15)) {
        changes.push_back({id, object, nullptr});
      } else if (random.chance(0.15)) {
        changes.push_back({id, object, make()});
      }
    }
  }

  RandomStroke random_;
  RandomStroke body_random_;  // apart, so that the guides of a seed stay the same
};

}  // namespace felt::testing
