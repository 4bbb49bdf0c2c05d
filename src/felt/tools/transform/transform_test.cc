#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "felt/document/copy_limit.h"
#include "felt/document/edit_builder.h"
#include "felt/stroke/edit/point_marks.h"
#include "felt/tools/testing/tool_fixture.h"
#include "felt/tools/transform/transform_tool.h"

namespace felt::transform_test {
namespace {

using testing::arc;
using testing::Fixture;
using testing::Pen;
using testing::random_stroke;
using testing::straight_stroke;
using testing::way;
using testing::operator+;

struct Transform {
  Fixture fixture;
  TransformTool tool;
  Pen pen{tool, fixture};
  ToolResult last;

  void set(std::string_view id, const OptionValue& value) {
    const auto ok = tool.set_option(id, value);
    ASSERT_TRUE(ok) << ok.error().message;
  }
  void choose(std::string_view id, const char* value) { set(id, std::string(value)); }
  void down(Point p, std::uint32_t buttons = 0) {
    last = pen.give({.time_ns = pen.now_ns += 1'000'000,
                     .position = {p.x, p.y, -1.0},
                     .velocity = {},
                     .pressure = {},
                     .buttons = buttons});
  }
  void drag(const std::vector<Point>& line, std::uint32_t buttons = 0) {
    pen.up(line.front());
    for (const Point p : line) down(p, buttons);
    pen.up(line.back());
  }
  StrokeId add(Stroke stroke, bool selected = true) {
    const std::size_t points = stroke.data().points.size();
    const StrokeId id = fixture.add(std::move(stroke));
    if (selected) fixture.selection.set_whole(id, points);
    return id;
  }
  void select(StrokeId id, Selection::Marks marks) {
    close_marks(*fixture.document.find(id), marks);
    fixture.selection.set(id, std::move(marks));
  }
  [[nodiscard]] Point start_of(StrokeId id) const {
    return fixture.document.find(id)->position(0.0);
  }
  [[nodiscard]] Overlay overlay() const {
    Overlay o;
    tool.draw(o);
    return o;
  }
};

bool has_label(const Overlay& overlay, std::string_view text) {
  return std::any_of(overlay.labels.begin(), overlay.labels.end(),
                     [&](const Overlay::Label& l) { return l.text == text; });
}

// Adds a square with the box 0..40. The frame is 3 mm larger.
StrokeId add_square(Transform& t) {
  StrokeData d;
  const Point corner[] = {{0, 0}, {40, 0}, {40, 40}, {0, 40}, {0, 0}};
  d.points.push_back(corner[0]);
  for (int i = 0; i < 4; ++i) {
    const Cubic c = straight(corner[i], corner[i + 1]);
    d.points.insert(d.points.end(), {c.p[1], c.p[2], c.p[3]});
  }
  d.closed = true;
  d.joints.assign(4, JointKind::kCorner);
  d.widths = {{0.0, 1.0}, {4.0, 1.0}};
  return t.add(Stroke::create(std::move(d)).value());
}

TEST(Transform, MovesFromInsideTheFrame) {
  Transform t;
  const StrokeId id = add_square(t);
  const Document before = t.fixture.document;
  t.drag(way({10, 30}, {25, 20}));
  EXPECT_EQ(t.pen.commits, 1);
  EXPECT_EQ(t.start_of(id), (Point{15, -10}));
  EXPECT_TRUE(t.fixture.selection.is_whole(id));
  t.fixture.undo();
  EXPECT_EQ(t.fixture.document, before) << "R52: undo restores the bytes";
}

TEST(Transform, TheHandlesTurnScaleAndStretch) {
  struct Case {
    const char* what;
    Point from, to;
    Affine map;
    std::uint32_t buttons = 0;
  };
  const Point c{20, 20};
  const Case cases[] = {
      {"corner", {43, 43}, {86, 86}, scaling(2.0, Point{0, 0})},
      {"corner, smaller", {-3, 43}, {18.5, 21.5}, scaling(0.5, Point{40, 0})},
      {"right edge", {43, 20}, {86, 33}, scaling(2.0, 1.0, {0, 20})},
      {"left edge", {-3, 20}, {-46, 33}, scaling(2.0, 1.0, {40, 20})},
      {"top edge", {20, -3}, {33, 18.5}, scaling(1.0, 0.5, {20, 40})},
      {"corner, both axes", {43, -3}, {86, 18.5}, scaling(2.0, 0.5, {0, 40}), kFirstModifier},
      {"corner, centre", {43, 43}, {66, 66}, scaling(2.0, c), kThirdModifier},
      {"corner, centre, smaller", {-3, 43}, {8.5, 31.5}, scaling(0.5, c), kThirdModifier},
      {"right edge, centre", {43, 20}, {66, 33}, scaling(2.0, 1.0, c), kThirdModifier},
      {"top edge, centre", {20, -3}, {33, 8.5}, scaling(1.0, 0.5, c), kThirdModifier},
      {"above", {20, -12}, {52, 20}, rotation(std::numbers::pi / 2, c)},
      {"beside a corner", {48, 48}, {-8, 48}, rotation(std::numbers::pi / 2, c)},
  };
  for (const Case& k : cases) {
    Transform t;
    const StrokeId id = add_square(t);
    const Stroke before = *t.fixture.document.find(id);
    t.drag(way(k.from, k.to), k.buttons);
    ASSERT_EQ(t.pen.commits, 1) << k.what;
    for (std::size_t i = 0; i < before.data().points.size(); ++i) {
      EXPECT_LE(distance(t.fixture.document.find(id)->data().points[i],
                         apply(k.map, before.data().points[i])),
                1e-9)
          << k.what;
    }
  }
}

TEST(Transform, TheThirdButtonMayChangeDuringTheDrag) {
  Transform t;
  const StrokeId id = add_square(t);
  t.pen.up({43, 43});
  t.down({43, 43});
  t.down({86, 86});
  t.down({66, 66}, kThirdModifier);
  t.pen.up({66, 66});
  EXPECT_LE(distance(t.start_of(id), Point{-20, -20}), 1e-9);
}

TEST(Transform, AnOptionScalesAboutTheCentreToo) {
  Transform t;
  const StrokeId id = add_square(t);
  t.set("about_centre", true);
  t.drag(way({43, 43}, {66, 66}));
  EXPECT_LE(distance(t.start_of(id), Point{-20, -20}), 1e-9);
}

/// The side opposite the handle stays, whatever is selected and however it is scaled.
RC_GTEST_PROP(TransformProperty, TheOppositeSideStays, ()) {
  Transform t;
  const auto seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
  const StrokeId id = t.add(random_stroke(seed));
  t.pen.up({500, 500});
  const Overlay shown = t.overlay();
  RC_PRE(!shown.outlines.empty());
  const std::vector<Point> corners = shown.outlines.front().points;
  RC_ASSERT(corners.size() == 4U);
  const auto at = *rc::gen::inRange<std::size_t>(0, 4);
  const Point grabbed = corners[at], across = corners[(at + 2) % 4];
  const Vec inward = TransformFrame::kMarginMm *
                     Vec{grabbed.x > across.x ? 1.0 : -1.0, grabbed.y > across.y ? 1.0 : -1.0};
  const Point fixed = across + inward;
  const double factor = 0.01 * *rc::gen::inRange(50, 300);
  const Stroke before = *t.fixture.document.find(id);
  const Point target = fixed + factor * (grabbed - fixed);
  t.drag(way(grabbed, target));
  const Stroke& after = *t.fixture.document.find(id);
  const double click_mm = TransformTool::kClickMm + 1e-9;  // a shorter drag is a click
  RC_ASSERT(t.pen.commits == 1 || distance(grabbed, target) < click_mm);
  for (std::size_t i = 0; t.pen.commits == 1 && i < before.data().points.size(); ++i) {
    const Point expected = fixed + factor * (before.data().points[i] - fixed);
    RC_ASSERT(distance(after.data().points[i], expected) < 1e-6);
  }
}

TEST(Transform, ModesDoTheSameEverywhere) {
  for (const char* mode : {"move", "rotate", "scale", "stretch"}) {
    Transform t;
    const StrokeId id = add_square(t);
    t.choose("mode", mode);
    t.drag(way({70, 20}, {120, 20}));
    ASSERT_EQ(t.pen.commits, std::string_view(mode) == "rotate" ? 0 : 1) << mode;
    if (std::string_view(mode) == "scale") {
      EXPECT_LE(distance(t.start_of(id), Point{-20, -20}), 1e-9);
    }
    if (std::string_view(mode) == "stretch") {
      EXPECT_LE(distance(t.start_of(id), Point{-20, 0}), 1e-9);
    }
    if (std::string_view(mode) == "move") {
      EXPECT_EQ(t.start_of(id), (Point{50, 0}));
    }
  }
}

/// Returns a random stroke in a square of its own, so that no two of them share a point.
Stroke random_stroke_apart(std::uint64_t seed, std::uint64_t number) {
  StrokeData data = random_stroke(seed).data();
  for (Point& p : data.points) p.x += 60.0 * static_cast<double>(number);
  return Stroke::create(std::move(data)).value();
}

TEST(Transform, R33_ThereAndBackAgainWithinANanometre) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Transform t;
    testing::RandomStroke random(seed);
    std::vector<StrokeId> ids;
    for (std::uint64_t i = 0; i < 5; ++i) {
      const StrokeId id = t.add(random_stroke_apart(5 * seed + i, i), false);
      Selection::Marks marks(t.fixture.document.find(id)->data().points.size());
      for (auto& m : marks) m = random.chance(0.5) ? 1 : 0;
      t.select(id, std::move(marks));
      ids.push_back(id);
    }
    if (t.fixture.selection.empty()) continue;
    const Document before = t.fixture.document;
    const char* mode = seed % 3 == 0 ? "move" : (seed % 3 == 1 ? "rotate" : "scale");
    t.choose("mode", mode);
    // The centre follows the box of the moved strokes, so the test drags it to a fixed point.
    const Rect box = t.fixture.selection.bounds(before);
    const Point c = lerp(Point{box.x0, box.y0}, Point{box.x1, box.y1}, 0.5);
    const Point from = c + Vec{25, 3},
                to = c + Vec{random.uniform(15, 40), random.uniform(-20, 20)};
    t.drag(way(from, to));
    for (const StrokeId id : ids) {
      const Selection::Marks* marks = t.fixture.selection.find(id);
      const auto& was = before.find(id)->data().points;
      const auto& is = t.fixture.document.find(id)->data().points;
      for (std::size_t i = 0; i < was.size(); i += 3) {
        if (!marks || !(*marks)[i]) {
          EXPECT_EQ(is[i], was[i]) << "unselected joints stay bit for bit";
        }
      }
    }
    // Moves back by the inverse map around the same centre.
    TransformDrag drag(seed % 3 == 0   ? TransformKind::kMove
                       : seed % 3 == 1 ? TransformKind::kRotate
                                       : TransformKind::kScale,
                       c, from);
    for (const Point p : way(from, to)) drag.update(p, false);
    if (t.pen.commits == 0) continue;
    const MovedStrokes back(t.fixture.document, t.fixture.index, t.fixture.selection, false);
    const Edit edit = back.finished(*inverse(drag.map()), 1.0, "Back");
    if (edit.empty()) continue;  // the tool kept an earlier factor
    t.fixture.apply(edit);
    for (const StrokeId id : ids) {
      const auto& was = before.find(id)->data().points;
      const auto& is = t.fixture.document.find(id)->data().points;
      for (std::size_t i = 0; i < was.size(); ++i) {
        EXPECT_LE(distance(is[i], was[i]), 1e-9) << "seed " << seed << ", " << mode;
      }
    }
  }
}

TEST(Transform, GoingBackIsNothing) {
  Transform t;
  add_square(t);
  const Document before = t.fixture.document;
  t.drag(way({10, 30}, {60, 9}) + way({60, 9}, {10, 30}));
  t.drag(way({43, 43}, {70, 60}) + way({70, 60}, {43, 43}));
  t.drag({{10, 30}});
  t.drag(way({10, 30}, {10.2, 30.1}));
  EXPECT_EQ(t.pen.commits, 0);
  EXPECT_EQ(t.fixture.document, before);
}

TEST(Transform, TheRateOfSamplesDoesNotMatter) {
  for (const Point from : {Point{10, 30}, Point{43, 43}, Point{20, -12}, Point{43, 20}}) {
    Point ends[2];
    for (const double step : {0.1, 6.0}) {
      Transform t;
      const StrokeId id = add_square(t);
      t.drag(way(from, {60, -30}, step) + way({60, -30}, {80, 70}, step));
      ends[step > 1.0] = t.start_of(id);
    }
    EXPECT_LE(distance(ends[0], ends[1]), 1e-9);
  }
}

TEST(Transform, ThePreviewIsWhatIsCommitted) {
  Transform t;
  const StrokeId id = add_square(t);
  t.pen.up({10, 30});
  for (const Point p : way({10, 30}, {25, 20})) {
    t.down(p);
  }
  ASSERT_TRUE(t.last.preview);
  const Stroke shown = *t.last.preview->changes.at(0).after;
  t.pen.up({25, 20});
  EXPECT_EQ(*t.fixture.document.find(id), shown);
}

TEST(Transform, CancelLeavesNothing) {
  for (const Point from : {Point{10, 30}, Point{43, 43}, Point{20, 20}}) {
    Transform t;
    add_square(t);
    const Document before = t.fixture.document;
    const Selection selection = t.fixture.selection;
    t.pen.up(from);
    t.pen.along(way(from, {80, 80}));
    t.tool.cancel();
    t.pen.up({80, 80});
    EXPECT_EQ(t.fixture.document, before);
    EXPECT_EQ(t.fixture.selection, selection);
    EXPECT_EQ(t.pen.commits, 0);
    // The centre is restored, too.
    t.drag(way({43, 43}, {66, 66}), kThirdModifier);
    EXPECT_LE(distance(t.fixture.strokes()[0]->position(0.0), Point{-20, -20}), 1e-9);
  }
}

TEST(Transform, FinishEndsTheGestureAsALiftDoes) {
  Transform t;
  add_square(t);
  t.pen.up({10, 30});
  t.pen.along(way({10, 30}, {20, 30}));
  const ToolResult result = t.tool.finish(t.fixture.scene());
  ASSERT_TRUE(result.commit);
  EXPECT_EQ(result.commit->label, "Move");
}

TEST(Transform, LockedLayersAreLeftAlone) {
  Transform t;
  const StrokeId id = add_square(t);
  const Layer layer = t.fixture.document.layers()[0];
  LayerState locked = layer.state();
  locked.locked = true;
  t.fixture.apply({"Lock", {}, {{layer.id, layer.state(), locked, 0, 0}}});
  t.drag(way({10, 30}, {60, 9}));
  t.choose("mode", "rotate");
  t.drag(way({10, 30}, {60, 9}));
  EXPECT_EQ(t.pen.commits, 0);
  EXPECT_EQ(t.start_of(id), (Point{0, 0}));
}

TEST(Transform, WithNothingSelectedATouchTakesTheLineAndMovesIt) {
  Transform t;
  const StrokeId id = t.add(straight_stroke({0, 0}, {30, 0}, 1, 1), false);
  t.pen.up({15, 2});
  EXPECT_EQ(t.overlay().spans.size(), 1u) << "seen before the touch";
  t.drag(way({15, 2}, {15, 22}));
  EXPECT_EQ(t.start_of(id), (Point{0, 20}));
  EXPECT_TRUE(t.fixture.selection.is_whole(id));
  t.fixture.selection.clear();
  t.drag(way({15, 40}, {15, 60}));
  EXPECT_EQ(t.pen.commits, 1) << "nothing there";
  EXPECT_TRUE(t.fixture.selection.empty());
  t.pen.up({15, 21});
  t.pen.along(way({15, 21}, {15, 30}));
  t.tool.cancel();
  t.pen.up({15, 30});
  EXPECT_TRUE(t.fixture.selection.empty()) << "cancelled: not even selected";
}

TEST(Transform, AClickBesideTheFrameSelectsAnotherLineOrNone) {
  Transform t;
  add_square(t);
  const StrokeId other = t.add(straight_stroke({90, 0}, {90, 50}, 1, 1), false);
  t.drag(way({88, 10}, {120, 10}));
  EXPECT_EQ(t.fixture.selection.strokes().size(), 1u);
  EXPECT_EQ(t.start_of(other), (Point{90, 0})) << "a longer way does nothing";
  t.drag({{91, 25}});
  EXPECT_TRUE(t.fixture.selection.is_whole(other));
  EXPECT_EQ(t.fixture.selection.strokes().size(), 1u);
  t.drag({{20, 90}});
  EXPECT_TRUE(t.fixture.selection.empty());
  EXPECT_EQ(t.pen.commits, 0);
}

TEST(Transform, E15_TheCentreCanBeDraggedAndStaysUntilTheSelectionChanges) {
  Transform t;
  const StrokeId id = add_square(t);
  t.drag(way({20, 20}, {0, 0}));
  EXPECT_EQ(t.pen.commits, 0);
  t.drag(way({43, 43}, {86, 86}));
  EXPECT_LE(distance(t.start_of(id), Point{0, 0}), 1e-9) << "scaled about the corner";
  EXPECT_LE(distance(t.fixture.strokes()[0]->position(2.0), Point{80, 80}), 1e-9);
  t.drag(way({83, 83}, {43 / 43.0 * 41.5, 41.5}));
  EXPECT_LE(distance(t.start_of(id), Point{0, 0}), 1e-9) << "it is still there";
  // The centre moves with the selection.
  t.drag(way({30, 10}, {30, 20}));
  t.drag(way({43, 53}, {86, 96}));
  EXPECT_LE(distance(t.start_of(id), Point{0, 10}), 1e-9);
  // Another selection has its own centre.
  const StrokeId other = t.add(straight_stroke({200, 200}, {240, 240}, 1, 1));
  t.fixture.selection.remove(id);
  t.drag(way({243, 243}, {286, 286}));
  EXPECT_LE(distance(t.start_of(other), Point{200, 200}), 1e-9) << "about the opposite corner";
}

TEST(Transform, AClickOnTheCentrePutsItBack) {
  Transform t;
  const StrokeId id = add_square(t);
  t.drag(way({20, 20}, {0, 0}));
  t.drag({{0, 0}});
  t.drag(way({43, 43}, {66, 66}), kThirdModifier);
  EXPECT_LE(distance(t.start_of(id), Point{-20, -20}), 1e-9);
}

TEST(Transform, TheFirstButtonConstrains) {
  Transform t;
  const StrokeId id = add_square(t);
  t.drag(way({10, 30}, {25, 20}), kFirstModifier);
  EXPECT_EQ(t.start_of(id), (Point{15, 0}));
  t.fixture.undo();
  t.drag(way({20, -12}, {60, 0}), kFirstModifier);
  const Point turned = t.start_of(id);
  const Vec arm = turned - Point{20, 20};
  const double angle = std::atan2(arm.y, arm.x) * 180.0 / std::numbers::pi + 135.0;
  EXPECT_NEAR(std::remainder(angle, 15.0), 0.0, 1e-9);
  t.fixture.undo();
  t.set("constrain", true);
  t.drag(way({43, 43}, {66, 31.5}), kThirdModifier);
  EXPECT_LE(distance(t.start_of(id), Point{-20, 10}), 1e-9) << "both axes freely";
}

TEST(Transform, TheSecondButtonDuplicates) {
  for (const bool by_option : {false, true}) {
    Transform t;
    const StrokeId id = add_square(t);
    if (by_option) t.set("duplicate", true);
    t.drag(way({10, 30}, {70, 30}), by_option ? 0 : kSecondModifier);
    ASSERT_EQ(t.fixture.strokes().size(), 2u);
    EXPECT_EQ(t.start_of(id), (Point{0, 0}));
    EXPECT_EQ(t.fixture.strokes()[1]->position(0.0), (Point{60, 0}));
    EXPECT_EQ(t.fixture.selection.find(id), nullptr);
    EXPECT_EQ(t.fixture.selection.strokes().size(), 1u) << "the copy is the selection";
    EXPECT_EQ(t.pen.commits, 1);
    t.fixture.undo();
    EXPECT_EQ(t.fixture.strokes().size(), 1u);
  }
}

TEST(Transform, ADragWhoseCopiesAreTooManySaysSoOnce) {
  Transform t;
  const StrokeId id = add_square(t);
  const StrokePtr dot = std::make_shared<const Stroke>(straight_stroke({0, 0}, {9, 0}, 1, 1));
  EditBuilder builder(t.fixture.document);
  for (std::size_t i = 2; i <= kMaxCopiedObjects; ++i) builder.add({1}, dot);
  ASSERT_TRUE(t.fixture.document.apply(std::move(builder).build("Add")));
  for (const bool duplicates : {true, false}) {
    int refusals = 0;
    t.pen.up({10, 30});
    for (const Point p : way({10, 30}, {70, 30})) {
      t.down(p, duplicates ? kSecondModifier : 0);
      if (t.last.refusal) ++refusals;
    }
    t.pen.up({70, 30});
    EXPECT_EQ(refusals, duplicates ? 1 : 0);
    EXPECT_EQ(t.start_of(id), duplicates ? (Point{0, 0}) : (Point{60, 0}));
  }
  t.pen.up({70, 30});
  t.down({70, 30}, kSecondModifier);
  EXPECT_FALSE(t.last.refusal) << "a click makes no copies";
}

TEST(Transform, WidthsAreScaledWhereAsked) {
  for (const bool asked : {false, true}) {
    Transform t;
    const StrokeId id = add_square(t);
    t.set("scale_widths", asked);
    t.drag(way({43, 43}, {86, 86}));
    EXPECT_NEAR(t.fixture.document.find(id)->width_mm(1.5), asked ? 2.0 : 1.0, 1e-9);
  }
}

TEST(Transform, R34_SaysHowManyLinesHoldAndShowsWhere) {
  Transform t;
  for (int i = 0; i < 3; ++i) {
    const StrokeId id = t.add(straight_stroke({0, 10.0 * i}, {60, 10.0 * i}, 1, 1), false);
    t.select(id, {1, 1, 0, 0});
  }
  t.pen.up({5, 8});
  for (const Point p : way({5, 8}, {5, 18})) t.down(p);
  const Overlay overlay = t.overlay();
  EXPECT_TRUE(has_label(overlay, "3 lines hold it"));
  EXPECT_TRUE(has_label(overlay, "0.0, 10.0 mm"));
  int tethers = 0;
  for (const Overlay::Line& line : overlay.lines) {
    if (line.role != Overlay::Role::kTether) continue;
    ++tethers;
    EXPECT_EQ(line.from.x, 60.0);
    EXPECT_LE(distance(line.to, line.from + Vec{0, 10}), 1e-12);
  }
  EXPECT_EQ(tethers, 3);
}

TEST(Transform, R35_MoreLinesHoldHarderAndWholeOnesNotAtAll) {
  const auto force_of = [](int lines, bool whole) {
    Transform t;
    for (int i = 0; i < lines; ++i) {
      const StrokeId id = t.add(straight_stroke({0, 10.0 * i}, {60, 10.0 * i}, 1, 1));
      if (!whole) t.select(id, {1, 1, 0, 0});
    }
    t.pen.up({5, 3});
    for (const Point p : way({5, 3}, {15, 3})) t.down(p);
    ForceMemory memory;
    memory.begin_tick(0.001);
    PenSample s;
    s.position = {15, 3, 1.0};  // above the surface, without friction
    return t.tool.force(t.fixture.scene())(s, memory).x;
  };
  EXPECT_EQ(force_of(4, true), 0.0);
  double last = 0.0;
  const double figures[] = {.36, .47, .60, .73, .84};
  int i = 0;
  for (const int lines : {1, 2, 4, 8, 16}) {
    const double force = -force_of(lines, false);
    EXPECT_GT(force, last);
    EXPECT_NEAR(force, figures[i++], 0.005) << "docs/design/forces.md#tether, at 10 mm";
    last = force;
  }
}

TEST(Transform, R35_AConstrainedMoveIsNotHeldAlongTheOtherAxis) {
  for (const bool constrained : {false, true}) {
    Transform t;
    t.select(t.add(straight_stroke({0, 0}, {60, 0}, 1, 1)), {1, 1, 0, 0});
    t.pen.up({5, 0});
    for (const Point p : way({5, 0}, {-5, -9})) t.down(p, constrained ? kFirstModifier : 0);
    ForceMemory memory;
    memory.begin_tick(0.001);
    PenSample s;
    s.position = {-5, -9, 1.0};  // above the surface, without friction
    const Force force = t.tool.force(t.fixture.scene())(s, memory);
    EXPECT_GT(force.x, 0.15);
    EXPECT_EQ(force.y != 0.0, !constrained) << force.y;
  }
}

TEST(Transform, TheFrameHoldsAllInkThatIsHighlighted) {
  Transform t;
  t.select(t.add(straight_stroke({0, 0}, {60, 0}, 20, 20), false), {1, 1, 0, 0});
  t.pen.up({90, 90});
  const Overlay overlay = t.overlay();
  Rect frame;
  for (const Overlay::Outline& outline : overlay.outlines) {
    for (const Point p : outline.points) frame.extend(p);
  }
  ASSERT_FALSE(overlay.spans.empty());
  for (const Overlay::Span& span : overlay.spans) {
    const Rect ink = bounds(span.curve).inflated(0.5 * span.width_mm);
    EXPECT_TRUE(frame.contains({ink.x0, ink.y0}) && frame.contains({ink.x1, ink.y1}));
  }
}

TEST(Transform, ManyTethersAreDrawnInPart) {
  Transform t;
  for (int i = 0; i < 200; ++i) {
    const StrokeId id = t.add(straight_stroke({0, 0.2 * i}, {60, 0.2 * i}, 1, 1), false);
    t.select(id, {1, 1, 0, 0});
  }
  t.pen.up({5, 8});
  for (const Point p : way({5, 8}, {5, 18})) t.down(p);
  const Overlay overlay = t.overlay();
  EXPECT_EQ(std::count_if(overlay.lines.begin(), overlay.lines.end(),
                          [](const auto& l) { return l.role == Overlay::Role::kTether; }),
            64);
  EXPECT_TRUE(has_label(overlay, "200 lines hold it"));
}

TEST(Transform, ShowsTheFrameBeforeTheTouch) {
  Transform t;
  add_square(t);
  t.pen.up({43, 43});
  const Overlay overlay = t.overlay();
  EXPECT_EQ(overlay.outlines.size(), 1u);
  EXPECT_EQ(overlay.dots.size(), 10u) << "eight handles, the one that turns, the centre";
  EXPECT_FALSE(overlay.rings.empty());
  t.fixture.selection.clear();
  t.pen.up({43, 43});
  EXPECT_TRUE(t.overlay().outlines.empty());
}

TEST(Transform, AnyGestureKeepsTheInvariantsAndUndoTheBytes) {
  const char* modes[] = {"auto", "move", "rotate", "scale", "stretch"};
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Transform t;
    testing::RandomStroke random(seed + 9000);
    for (std::uint64_t i = 0; i < 8; ++i) {
      const StrokeId id = t.add(random_stroke(8 * seed + i), false);
      Selection::Marks marks(t.fixture.document.find(id)->data().points.size());
      const double density = random.uniform(0, 1);
      for (auto& m : marks) m = random.chance(density) ? 1 : 0;
      t.select(id, std::move(marks));
    }
    const Document start = t.fixture.document;
    for (int gesture = 0; gesture < 12; ++gesture) {
      t.choose("mode", modes[random.pick(0, 4)]);
      t.set("scale_widths", random.chance(0.5));
      const auto buttons = static_cast<std::uint32_t>(random.chance(0.7) ? 0 : random.pick(1, 3));
      std::vector<Point> line{{random.uniform(-10, 30), random.uniform(-20, 30)}};
      for (int i = random.pick(0, 5); i > 0; --i) {
        const double far = random.chance(0.1) ? 1e6 : 40.0;
        const Point to{random.uniform(-far, far), random.uniform(-far, far)};
        line = line + way(line.back(), to, distance(line.back(), to) / 50.0);
      }
      t.drag(line, buttons);
      for (const StrokePtr& s : t.fixture.strokes()) {
        ASSERT_TRUE(check_invariants(s->data())) << "seed " << seed << ", gesture " << gesture;
      }
      for (const auto& [id, marks] : t.fixture.selection.strokes()) {
        ASSERT_EQ(marks.size(), t.fixture.document.find(id)->data().points.size());
      }
    }
    const Document end = t.fixture.document;
    for (int i = 0; i < t.pen.commits; ++i) t.fixture.undo();
    EXPECT_EQ(t.fixture.document, start) << "seed " << seed;
    for (int i = 0; i < t.pen.commits; ++i) t.fixture.redo();
    EXPECT_EQ(t.fixture.document, end) << "seed " << seed;
  }
}

}  // namespace
}  // namespace felt::transform_test
