#pragma once

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

/// Adds random changes of guides and symmetry groups that fit a document, for property tests. New
/// objects get ids from `first_id` on.
class RandomGuides {
 public:
  explicit RandomGuides(std::uint64_t seed) : random_(seed) {}

  void add_changes(const Document& document, std::uint64_t first_id, Edit& edit) {
    const auto guide = [this] {
      return std::make_shared<const DrawingGuide>(random_guide(random_));
    };
    const auto group = [this] {
      return std::make_shared<const SymmetryGroup>(random_symmetry(random_));
    };
    if (random_.chance(0.4)) edit.guides.push_back({{first_id++}, nullptr, guide()});
    if (random_.chance(0.4)) edit.symmetries.push_back({{first_id++}, nullptr, group()});
    change(document.guides(), edit.guides, guide);
    change(document.symmetries(), edit.symmetries, group);
    edit.toggles_guides = random_.chance(0.2);
  }

 private:
  template <class Table, class Change, class Make>
  void change(const Table& table, std::vector<Change>& changes, Make make) {
    for (const auto& [id, object] : table) {
      if (random_.chance(0.15)) {
        changes.push_back({id, object, nullptr});
      } else if (random_.chance(0.15)) {
        changes.push_back({id, object, make()});
      }
    }
  }

  RandomStroke random_;
};

}  // namespace felt::testing
