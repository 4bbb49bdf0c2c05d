// Guides of the drawing in a session: the force of the pencil, and exact strokes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include "felt/base/constants.h"
#include "felt/document/drawing_guide.h"
#include "felt/geometry/nearest.h"
#include "felt/haptics/force_model.h"
#include "felt/session/session.h"

namespace felt::session_exact_test {
namespace {

/// A session with the real tools and one guide in its drawing.
struct Fixture {
  explicit Fixture(DrawingGuide guide)
      : session(make_tools(), {.device = Capabilities{.max_force_n = 3.3,
                                                      .max_stiffness_n_per_m = 1000.0,
                                                      .max_damping_n_s_per_m = 8.0},
                               .document = with(std::move(guide))}) {
    must(SetOption{"pencil.snap", "off"});
  }
  static Document with(DrawingGuide guide) {
    Document document;
    Edit edit;
    edit.label = "Guide";
    edit.guides.push_back({.id = document.new_guide_id(),
                           .before = nullptr,
                           .after = std::make_shared<const DrawingGuide>(std::move(guide))});
    EXPECT_TRUE(document.apply(edit));
    return document;
  }
  template <class What>
  void must(What what) {
    const Result<void> done = session.apply({now_ns, std::move(what)});
    ASSERT_TRUE(done) << done.error().message;
  }
  void pen(Point at, double z) {
    now_ns += 5 * kMs;
    must(PenEvent{{at.x, at.y, z}, {}, 0});
  }
  /// Draws through points, 0.5 mm in each sample.
  void draw(std::initializer_list<Point> points) {
    pen(*points.begin(), 5.0);
    Point at = *points.begin();
    for (const Point to : points) {
      const int steps = std::max(1, static_cast<int>(std::ceil(distance(at, to) / 0.5)));
      for (int i = 1; i <= steps; ++i) pen(lerp(at, to, double(i) / steps), -1.0);
      at = to;
    }
    for (int i = 0; i < 10; ++i) pen(at, 5.0);
  }
  /// Returns the newest stroke.
  [[nodiscard]] StrokePtr ink() const {
    return session.document().find(session.document().layers().front().strokes.back());
  }

  std::int64_t now_ns = 0;
  Session session;
};

Vec guide_force(const Session& session, Point p) {
  const ForceModel model = session.force();
  ForceMemory memory;
  PenSample sample;
  sample.position = {p.x, p.y, -1.0};
  for (int i = 0; i < 300; ++i) {
    memory.begin_tick(0.001);
    static_cast<void>(model(sample, memory));
  }
  for (const ForceTerms::Term& term : memory.terms) {
    if (std::string_view(term.name) == "guide") return {term.force.x, term.force.y};
  }
  return {};
}

const DrawingGuide kLine{.kind = DrawingGuideKind::kLine, .origin = {0.0, 50.0}};

TEST(DrawingGuides, HoldThePencilUnlessAStudyGuidesIt) {
  Fixture fixture(kLine);
  fixture.pen({20.0, 51.0}, 5.0);
  EXPECT_EQ(guide_force(fixture.session, {20.0, 51.0}), Vec{});
  fixture.pen({20.0, 51.0}, -1.0);
  EXPECT_NEAR(guide_force(fixture.session, {20.0, 51.0}).y, -0.6, 1e-6);
  fixture.must(UseGuide{{.kind = GuideKind::kGroove, .points = {{0.0, 53.0}, {50.0, 53.0}}}});
  fixture.pen({20.5, 51.0}, -1.0);
  EXPECT_NEAR(guide_force(fixture.session, {20.5, 51.0}).y, 0.6, 1e-6) << "300 N/m, 2 mm";
  fixture.must(UseGuide{});
  fixture.pen({20.5, 51.0}, -1.0);
  fixture.must(CancelEvent{});
  fixture.pen({20.5, 51.0}, -1.0);
  EXPECT_EQ(guide_force(fixture.session, {20.5, 51.0}), Vec{}) << "until the next touch";
  fixture.must(SelectTool{"eraser"});
  fixture.pen({20.5, 51.0}, 5.0);
  for (int i = 0; i < 10; ++i) fixture.pen({20.5, 51.0}, 5.0);
  fixture.pen({20.5, 51.0}, -1.0);
  EXPECT_EQ(guide_force(fixture.session, {20.5, 51.0}), Vec{}) << "only the pencil is guided";
}

/// Returns the force of the friction after a pen that touched at (20, y) has moved by 0.05 mm.
double friction_n(const DrawingGuide& guide, double y) {
  Fixture fixture(guide);
  fixture.pen({20.0, y}, 5.0);
  fixture.pen({20.0, y}, -1.0);
  const ForceModel model = fixture.session.force();
  ForceMemory memory;
  for (int i = 0; i < 100; ++i) {
    memory.begin_tick(0.001);
    PenSample sample;
    sample.position = {i < 50 ? 20.0 : 20.05, y, -1.0};
    static_cast<void>(model(sample, memory));
  }
  for (const ForceTerms::Term& term : memory.terms) {
    if (std::string_view(term.name) == "friction") return norm(term.force);
  }
  return 0.0;
}

TEST(DrawingGuides, AGuideFarAwayDoesNotSoftenTheFriction) {
  const DrawingGuide none{.kind = DrawingGuideKind::kTrace, .stroke = {99}};
  const double plain_n = friction_n(none, 90.0);
  EXPECT_GT(plain_n, 0.01);
  EXPECT_EQ(friction_n(kLine, 90.0), plain_n);
  EXPECT_LT(friction_n(kLine, 51.0), 0.5 * plain_n);
}

TEST(DrawingGuides, DoNotMoveInk) {
  Fixture with(kLine), without({.kind = DrawingGuideKind::kTrace, .stroke = {99}});
  for (Fixture* fixture : {&with, &without}) {
    fixture->draw({{20.0, 50.3}, {50.0, 49.8}, {80.0, 50.2}});
  }
  EXPECT_EQ(with.ink()->data(), without.ink()->data());
}

TEST(DrawingGuides, AStrokeThatKeptToTheLineIsOfferedAsExact) {
  Fixture fixture(kLine);
  fixture.draw({{20.0, 50.3}, {50.0, 49.8}, {80.0, 50.2}});
  const StrokePtr drawn = fixture.ink();
  const StrokePtr offer = fixture.session.exact_offer();
  ASSERT_TRUE(offer);
  Overlay overlay;
  fixture.session.draw(overlay);
  EXPECT_EQ(overlay.outlines.size(), 1U);
  EXPECT_EQ(fixture.ink(), drawn) << "an offer changes nothing";
  const std::size_t steps = fixture.session.history().undo_count();
  fixture.must(ExactEvent{});
  EXPECT_EQ(fixture.ink(), offer);
  EXPECT_EQ(fixture.session.history().undo_count(), steps + 1);
  EXPECT_EQ(offer->segment_count(), 1);
  EXPECT_NEAR(offer->position(0.0).y, 50.0, 1e-12);
  EXPECT_NEAR(offer->position(1.0).x, 80.0, 0.1);
  EXPECT_FALSE(fixture.session.exact_offer());
  fixture.must(ExactEvent{});
  EXPECT_EQ(fixture.session.history().undo_count(), steps + 1) << "no offer, no step";
  fixture.must(UndoEvent{});
  EXPECT_EQ(*fixture.ink(), *drawn);
}

TEST(DrawingGuides, TheOfferEndsWithTheNextTouchAndWhenTheStrokeChanges) {
  Fixture fixture(kLine);
  fixture.draw({{20.0, 50.0}, {80.0, 50.0}});
  ASSERT_TRUE(fixture.session.exact_offer());
  fixture.must(UndoEvent{});
  EXPECT_FALSE(fixture.session.exact_offer());
  fixture.must(ExactEvent{});
  EXPECT_EQ(fixture.session.document().stroke_count(), 0U);
  fixture.draw({{20.0, 50.0}, {80.0, 50.0}});
  ASSERT_TRUE(fixture.session.exact_offer());
  fixture.draw({{20.0, 90.0}, {80.0, 99.0}});
  EXPECT_FALSE(fixture.session.exact_offer());
  fixture.draw({{20.0, 50.0}, {50.0, 51.0}, {80.0, 50.0}});
  EXPECT_FALSE(fixture.session.exact_offer()) << "1 mm away";
}

TEST(DrawingGuides, ALockedOrHiddenLayerStaysAsItIs) {
  Fixture fixture(kLine);
  fixture.draw({{20.0, 50.3}, {80.0, 50.2}});
  const StrokePtr drawn = fixture.ink();
  ASSERT_TRUE(fixture.session.exact_offer());
  const LayerId layer = fixture.session.document().layers().front().id;
  for (const auto& [closes, opens] : {std::pair{LayerEvent::Do::kLock, LayerEvent::Do::kUnlock},
                                      std::pair{LayerEvent::Do::kHide, LayerEvent::Do::kShow}}) {
    fixture.must(LayerEvent{closes, layer});
    EXPECT_FALSE(fixture.session.exact_offer());
    fixture.must(ExactEvent{});
    EXPECT_EQ(fixture.ink(), drawn);
    fixture.must(LayerEvent{opens, layer});
    EXPECT_TRUE(fixture.session.exact_offer());
  }
}

/// Returns the smallest distance between the ends of two strokes, mm.
double gap_mm(const Stroke& a, const Stroke& b) {
  double gap = kInf;
  for (const StrokeTip i : {StrokeTip::kStart, StrokeTip::kEnd}) {
    for (const StrokeTip k : {StrokeTip::kStart, StrokeTip::kEnd}) {
      gap = std::min(gap, distance(tip_point(a, i), tip_point(b, k)));
    }
  }
  return gap;
}

/// A line through (20, 50.3) and (80, 50.2) is drawn with snapping after another one, in another
/// colour, so that they are not joined.
struct ConnectedFixture : Fixture {
  ConnectedFixture(Point from, Point to) : Fixture(kLine) {
    must(SetOption{"pencil.snap", "both"});
    draw({from, to});
    first = session.document().layers().front().strokes.front();
    must(SetOption{"ink.color", "#aa0000"});
    draw({{20.0, 50.3}, {50.0, 49.9}, {80.0, 50.2}});
  }
  [[nodiscard]] StrokePtr other() const { return session.document().find(first); }
  StrokeId first;
};

TEST(DrawingGuides, AnExactLineStaysConnectedAtItsEnds) {
  ConnectedFixture fixture({40.0, 90.0}, {20.0, 50.4});
  ASSERT_EQ(fixture.session.document().stroke_count(), 2U);
  const StrokePtr drawn = fixture.ink();
  const Document before = fixture.session.document();
  ASSERT_LT(gap_mm(*drawn, *fixture.other()), 1e-9);
  ASSERT_TRUE(fixture.session.exact_offer());
  fixture.must(ExactEvent{});
  EXPECT_NE(fixture.ink(), drawn);
  EXPECT_EQ(fixture.ink()->segment_count(), 1);
  EXPECT_EQ(fixture.ink()->position(0.0).y, 50.0);
  EXPECT_EQ(gap_mm(*fixture.ink(), *fixture.other()), 0.0) << "the other line moved along";
  EXPECT_NEAR(fixture.other()->position(0.0).y, 90.0, 0.2);
  fixture.must(UndoEvent{});
  EXPECT_EQ(fixture.session.document(), before) << "one step";
}

TEST(DrawingGuides, AnExactLineStaysConnectedToTheMiddleOfAnother) {
  ConnectedFixture fixture({5.0, 20.0}, {35.0, 80.6});
  ASSERT_EQ(fixture.session.document().stroke_count(), 2U);
  const StrokePtr other = fixture.other();
  const auto away_mm = [&](Point p) {
    double away = kInf;
    for (int i = 0; i < other->segment_count(); ++i) {
      away = std::min(away, std::sqrt(nearest(other->segment(i), p).distance_squared));
    }
    return away;
  };
  ASSERT_LT(away_mm(fixture.ink()->position(0.0)), 1e-3) << "drawn from a point of the line";
  ASSERT_TRUE(fixture.session.exact_offer());
  fixture.must(ExactEvent{});
  EXPECT_EQ(fixture.ink()->position(0.0).y, 50.0);
  EXPECT_LT(away_mm(fixture.ink()->position(0.0)), 1e-3);
  EXPECT_EQ(fixture.other(), other);
}

TEST(DrawingGuides, AConnectionToALockedLineIsNotOpened) {
  ConnectedFixture fixture({40.0, 90.0}, {20.0, 50.4});
  const LayerId below = fixture.session.document().layers().front().id;
  fixture.must(UndoEvent{});
  fixture.must(LayerEvent{LayerEvent::Do::kAdd, {}});
  fixture.must(LayerEvent{LayerEvent::Do::kLock, below});
  fixture.draw({{20.0, 50.3}, {50.0, 49.9}, {80.0, 50.2}});
  const Document before = fixture.session.document();
  const StrokePtr drawn = before.find(before.layers().back().strokes.back());
  ASSERT_LT(gap_mm(*drawn, *fixture.other()), 1e-9);
  EXPECT_FALSE(fixture.session.exact_offer());
  fixture.must(ExactEvent{});
  EXPECT_EQ(fixture.session.document(), before);
}

TEST(DrawingGuides, AnArcOfACompassBecomesExact) {
  Fixture fixture({.kind = DrawingGuideKind::kCompass, .origin = {60.0, 60.0}});
  fixture.draw({{90.0, 60.0}, {89.9, 62.4}, {89.5, 65.2}, {88.8, 68.3}, {87.7, 71.5}});
  ASSERT_TRUE(fixture.session.exact_offer());
  fixture.must(ExactEvent{});
  for (int i = 0; i <= 10 * fixture.ink()->segment_count(); ++i) {
    EXPECT_NEAR(distance(fixture.ink()->position(0.1 * i), {60.0, 60.0}), 30.0, 3e-5);
  }
}

}  // namespace
}  // namespace felt::session_exact_test
