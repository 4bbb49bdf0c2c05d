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

std::vector<FillPtr> fills_in(const Document& document, const Rect& area) {
  std::vector<FillPtr> seen;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const FillId id : layer.fills) {
      FillPtr fill = document.find_fill(id);
      if (area.intersects(fill_bounds(*fill))) seen.push_back(std::move(fill));
    }
  }
  return seen;
}

std::vector<FillPtr> fills_found(const InkScene& scene, const Rect& area) {
  std::vector<SceneInk> found;
  scene.find_ink(area, found);
  std::vector<FillPtr> fills;
  for (const SceneInk& ink : found) {
    if (ink.fill) fills.push_back(ink.fill->fill);
  }
  return fills;
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
      EXPECT_EQ(fills_found(scene, area), fills_in(shown, area));
      EXPECT_EQ(scene.has_fill(area), !fills_in(shown, area).empty());
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
    EXPECT_EQ(fills_found(scene, all), fills_in(document, all));
  }
}

TEST(InkScene, AChangedFillIsDamageAndComesBeforeTheStrokesOfItsLayer) {
  Document document;
  testing::RandomStroke random(5);
  EditBuilder builder(document);
  builder.add({1}, std::make_shared<const Stroke>(testing::random_stroke(1)));
  const auto fill = std::make_shared<const Fill>(testing::random_fill(random));
  const FillId id = builder.add_fill({1}, fill);
  const Edit edit = std::move(builder).build("Fill");
  InkScene scene(document);
  InkDamage damage;
  ASSERT_TRUE(document.apply(edit));
  ASSERT_TRUE(scene.apply(edit, damage));
  std::vector<SceneInk> found;
  scene.find_ink({-1e9, -1e9, 1e9, 1e9}, found);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE(found[0].fill) << "below the stroke, though added later";
  EXPECT_TRUE(found[1].stroke);
  damage.clear();
  EditBuilder removal(document);
  removal.remove_fill(id);
  const Edit remove = std::move(removal).build("Remove");
  ASSERT_TRUE(scene.show(remove, damage));
  EXPECT_EQ(damage, InkDamage{fill_bounds(*fill)});
  damage.clear();
  ASSERT_TRUE(scene.apply(remove, damage));
  EXPECT_TRUE(damage.empty()) << "it was shown before";
  EXPECT_FALSE(scene.has_fill({-1e9, -1e9, 1e9, 1e9}));
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

/// If one segment of a stroke with a style changes, dashes move on the whole stroke.
TEST(InkScene, AStyleIsRepaintedAsAWhole) {
  const auto damage_of = [](const std::string& medium) {
    StrokeData data;
    for (int i = 0; i <= 30; ++i) data.points.push_back({4.0 * i, 0.1 * (i % 3)});
    data.joints.assign(9, JointKind::kCorner);
    data.widths = {{0.0, 1.0}, {10.0, 1.0}};
    data.medium = medium;
    Document document;
    EditBuilder builder(document);
    const StrokeId id = builder.add(document.layers()[0].id,
                                    std::make_shared<const Stroke>(Stroke::create(data).value()));
    EXPECT_TRUE(document.apply(std::move(builder).build("Add")));
    InkScene scene(document);
    InkDamage damage;
    data.points.back().x += 1.0;
    EditBuilder change(document);
    change.replace(id, std::make_shared<const Stroke>(Stroke::create(data).value()));
    EXPECT_TRUE(scene.apply(std::move(change).build("Move"), damage));
    const Rect whole = document.find(id)->bounds();
    return std::any_of(damage.begin(), damage.end(), [&](const Rect& area) {
      return area.x0 <= whole.x0 && area.y0 <= whole.y0 && area.x1 >= whole.x1 &&
             area.y1 >= whole.y1;
    });
  };
  EXPECT_FALSE(damage_of("pencil"));
  EXPECT_TRUE(damage_of("dashed-pen"));
}

}  // namespace
}  // namespace felt::ink_scene_test
