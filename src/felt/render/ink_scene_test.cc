#include "felt/render/ink_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "felt/document/edit_builder.h"
#include "felt/document/testing/random_document.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::ink_scene_test {
namespace {

/// Returns the strokes that a part of the page shows, by checking every stroke.
std::vector<StrokePtr> seen_in(const Document& document, const Rect& area) {
  std::vector<StrokePtr> seen;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) {
      StrokePtr stroke = document.find(id);
      if (area.intersects(stroke->bounds())) seen.push_back(std::move(stroke));
    }
  }
  return seen;
}

std::vector<StrokePtr> found_in(const InkScene& scene, const Rect& area) {
  std::vector<const SceneStroke*> found;
  scene.find(area, found);
  std::vector<StrokePtr> strokes;
  for (const SceneStroke* s : found) strokes.push_back(s->stroke);
  return strokes;
}

Rect random_area(testing::RandomStroke& random) {
  const Point at{random.uniform(-10, 30), random.uniform(-10, 30)};
  const double size = random.chance(0.1) ? 1e9 : random.uniform(0.0, 20.0);
  return {at.x, at.y, at.x + size, at.y + size};
}

TEST(InkScene, FindsWhatTheDocumentShowsInItsOrder) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    testing::RandomEdits edits(seed);
    testing::RandomStroke random(seed);
    Document document;
    InkScene scene(document);
    for (int step = 0; step < 40; ++step) {
      InkDamage damage;
      const Edit edit = edits.next(document);
      Document shown = document;
      ASSERT_TRUE(shown.apply(edit));
      const bool is_preview = random.chance(0.5);
      if (is_preview) {
        ASSERT_TRUE(scene.show(edit, damage));
      } else {
        ASSERT_TRUE(scene.apply(edit, damage));
        document = shown;
      }
      const Rect area = random_area(random);
      EXPECT_EQ(found_in(scene, area), seen_in(shown, area));
      // Areas without damage look the same as before.
      for (const Rect& r : damage) EXPECT_FALSE(r.empty());
    }
    InkDamage damage;
    ASSERT_TRUE(scene.show(std::nullopt, damage));
    EXPECT_EQ(found_in(scene, {-1e9, -1e9, 1e9, 1e9}), seen_in(document, {-1e9, -1e9, 1e9, 1e9}));
  }
}

TEST(InkScene, AnEditThatDoesNotFitChangesNothing) {
  testing::RandomEdits edits(7);
  Document document;
  InkScene scene(document);
  for (int step = 0; step < 30; ++step) {
    InkDamage damage;
    const Edit edit = edits.next(document);
    ASSERT_TRUE(document.apply(edit));
    ASSERT_TRUE(scene.apply(edit, damage));
    if (edit.changes.empty()) continue;
    EXPECT_FALSE(scene.apply(edit, damage)) << edit.label;
    EXPECT_FALSE(scene.show(edit, damage)) << edit.label;
    const Rect all{-1e9, -1e9, 1e9, 1e9};
    EXPECT_EQ(found_in(scene, all), seen_in(document, all));
  }
}

TEST(InkScene, AnEditThatWasShownBeforeIsNoDamage) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    testing::RandomEdits edits(seed);
    Document document;
    InkScene scene(document);
    for (int step = 0; step < 20; ++step) {
      Edit edit = edits.next(document);
      if (!edit.layers.empty()) continue;
      InkDamage damage;
      ASSERT_TRUE(scene.show(edit, damage));
      damage.clear();
      ASSERT_TRUE(scene.show(edit, damage));
      EXPECT_TRUE(damage.empty());
      ASSERT_TRUE(scene.apply(edit, damage));
      EXPECT_TRUE(damage.empty());
      ASSERT_TRUE(document.apply(edit));
    }
  }
}

TEST(InkScene, APullInOnePlaceIsDamageThere) {
  StrokeData data;
  data.points.push_back({0, 0});
  for (int i = 0; i < 50; ++i) {
    for (int k = 1; k <= 3; ++k) data.points.push_back({i + k / 3.0, 0.0});
    if (i > 0) data.joints.push_back(JointKind::kCorner);
  }
  data.widths = {{0, 1.0}, {50, 1.0}};
  const auto before = std::make_shared<const Stroke>(Stroke::create(data).value());
  for (std::size_t k = 74; k <= 76; ++k) data.points[k].y += 2.0;
  // An additional width breakpoint, as after a division, moves none of the others.
  data.widths = {{0, 1.0}, {25, 1.0}, {50, 1.0}};
  const auto after = std::make_shared<const Stroke>(Stroke::create(data).value());
  InkDamage damage;
  add_difference(*before, *after, damage);
  Rect all;
  for (const Rect& r : damage) all.extend(r);
  EXPECT_TRUE(all.contains({25.0, 2.5}));
  EXPECT_TRUE(all.contains({25.0, -0.5}));
  data.widths = {{0, 1.0}, {50, 1.0}};
  damage.clear();
  add_difference(*before, Stroke::create(data).value(), damage);
  all = {};
  for (const Rect& r : damage) all.extend(r);
  EXPECT_TRUE(all.contains({25.0, 2.5}));
}

TEST(StrokeOrder, KeepsPlacesAsAListDoes) {
  testing::RandomStroke random(3);
  std::vector<SceneStroke> strokes(3000);
  std::vector<SceneStroke*> list;
  StrokeOrder order;
  for (SceneStroke& stroke : strokes) {
    const auto at = static_cast<std::size_t>(random.pick(0, static_cast<int>(list.size())));
    list.insert(list.begin() + static_cast<std::ptrdiff_t>(at), &stroke);
    order.insert(at, stroke);
    if (!random.chance(0.3)) continue;
    const auto gone = static_cast<std::size_t>(random.pick(0, static_cast<int>(list.size()) - 1));
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(gone));
    order.erase(gone);
  }
  order.number();
  ASSERT_EQ(order.size(), list.size());
  for (std::size_t i = 0; i < list.size(); ++i) EXPECT_EQ(list[i]->rank(), i);
}

}  // namespace
}  // namespace felt::ink_scene_test
