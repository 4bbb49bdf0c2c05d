// Tests of the offers of a session, with the pencil.
#include <gtest/gtest.h>

#include <cmath>

#include "felt/base/constants.h"
#include "felt/session/session.h"

namespace felt::session_offers_test {
namespace {

using What = OfferKind;

struct Fixture {
  Fixture() {
    for (const char* id : {"pencil.scratch_out", "pencil.double_loop", "pencil.shapes"}) {
      must(SetOption{id, true});
    }
    must(SetOption{"pencil.snap", std::string("off")});
  }

  void must(decltype(Event::what) what) { ASSERT_TRUE(session.apply({now_ns, std::move(what)})); }
  void pen(Point at, double z, double pressure = 0.4) {
    now_ns += 4'000'000;
    must(PenEvent{{at.x, at.y, z}, z < 0.0 ? std::optional(pressure) : std::nullopt, 0});
  }
  void rest(Point at, double s, double pressure = 0.4) {
    for (int i = 0; i < static_cast<int>(s / 0.004); ++i) pen(at, -0.1, pressure);
  }
  void down(const std::vector<Point>& path) {
    pen(path.front(), 5.0);
    for (const Point p : path) pen(p, -0.1);
    last = path.back();
  }
  void lift() {
    for (int i = 0; i < 12; ++i) pen(last, 5.0);
  }
  void stroke(const std::vector<Point>& path) {
    down(path);
    lift();
  }
  void line(double y) {
    std::vector<Point> path;
    for (int i = 0; i <= 40; ++i) path.push_back({40.0 + 0.5 * i, y});
    stroke(path);
  }
  void scratch(Point from, int passes = 9) {
    std::vector<Point> path;
    for (int i = 0; i < 20 * passes; ++i) {
      const double share = (i / 20) % 2 == 0 ? i % 20 / 20.0 : 1.0 - i % 20 / 20.0;
      path.push_back(from + Vec{26.0 * share, i / 20.0});
    }
    stroke(path);
  }
  static std::vector<Point> round(double turns, double a = 20.0, double b = 20.0) {
    std::vector<Point> path;
    for (int i = 0; i <= 80 * turns; ++i) {
      path.push_back({50.0 + a * std::cos(kTau * i / 80), 60.0 + b * std::sin(kTau * i / 80)});
    }
    return path;
  }
  [[nodiscard]] std::size_t lines() const {
    return session.document().layers().back().strokes.size();
  }
  [[nodiscard]] std::size_t steps() const { return session.history().undo_count(); }
  [[nodiscard]] bool offers(What what) const {
    const auto offer = session.offered();
    return offer && std::any_of(offer->rows.begin(), offer->rows.end(),
                                [what](const OfferRow& r) { return r.kind == what; });
  }

  std::int64_t now_ns = 0;
  Point last;
  Session session{make_tools(), {}};
};

TEST(SessionOffers, AScratchOutDeletesOnlyWhenChosenAndIsOneStep) {
  Fixture f;
  f.line(60.0);
  f.line(62.0);
  f.line(120.0);
  const Document before = f.session.document();
  f.scratch({37.0, 57.0});
  ASSERT_TRUE(f.offers(What::kDelete));
  EXPECT_EQ(f.session.offered()->rows.front(), (OfferRow{What::kDelete, 2}));
  EXPECT_EQ(f.session.offered()->rows[f.session.offered()->chosen].kind, What::kInk);
  EXPECT_EQ(f.lines(), 4U) << "nothing is deleted yet, and the ink is there";
  Overlay overlay;
  f.session.draw(overlay);
  EXPECT_FALSE(overlay.spans.empty()) << "what would be deleted is marked";
  f.must(ChooseOffer{What::kDelete});
  EXPECT_EQ(f.lines(), 1U);
  EXPECT_EQ(f.steps(), 4U) << "the choice replaces the step of the line";
  EXPECT_EQ(f.session.history().undo_label(), "Scratch out");
  EXPECT_FALSE(f.session.offered());
  f.must(UndoEvent{});
  EXPECT_EQ(f.session.document(), before);
  f.must(RedoEvent{});
  EXPECT_EQ(f.lines(), 1U);
}

TEST(SessionOffers, GoingOnUndoToolsAndOtherChangesKeepTheInk) {
  const auto changes = std::vector<decltype(Event::what)>{SelectTool{"eraser"}, CancelEvent{},
                                                          ChooseOffer{What::kInk},
                                                          LayerEvent{LayerEvent::Do::kAdd, {}}};
  for (const auto& change : changes) {
    Fixture f;
    f.line(60.0);
    f.scratch({37.0, 56.0});
    ASSERT_TRUE(f.offers(What::kDelete));
    f.must(change);
    EXPECT_FALSE(f.session.offered());
    f.must(ChooseOffer{What::kDelete});
    EXPECT_EQ(f.session.document().layers().front().strokes.size(), 2U);
  }
  Fixture f;
  f.line(60.0);
  f.scratch({37.0, 56.0});
  f.pen({100, 100}, -0.1);
  EXPECT_FALSE(f.session.offered()) << "the next line begins";
  Fixture undone;
  undone.line(60.0);
  undone.scratch({37.0, 56.0});
  undone.must(UndoEvent{});
  undone.must(ChooseOffer{What::kDelete});
  EXPECT_EQ(undone.lines(), 1U);
}

TEST(SessionOffers, ADoubleLoopSelectsWhatItEncloses) {
  Fixture f;
  f.line(60.0);
  f.line(110.0);
  f.stroke(Fixture::round(2.0));
  ASSERT_TRUE(f.offers(What::kSelect));
  EXPECT_TRUE(f.session.selection().empty());
  f.must(ChooseOffer{What::kSelect});
  EXPECT_EQ(f.lines(), 2U) << "the loop is not ink";
  EXPECT_EQ(f.session.selection().strokes().size(), 1U);
  EXPECT_EQ(f.steps(), 2U);
  f.must(RedoEvent{});
  EXPECT_EQ(f.lines(), 3U) << "the ink is not lost";
}

TEST(SessionOffers, APenThatRestsOffersShapesAndPressingTakesTheBest) {
  Fixture f;
  f.down(Fixture::round(1.0, 20.0, 16.5));
  f.rest(f.last, 0.4);
  EXPECT_FALSE(f.session.offered());
  f.rest(f.last, 0.2);
  ASSERT_TRUE(f.session.offered());
  EXPECT_EQ(f.session.offered()->rows.size(), 3U) << "circle, ellipse, ink";
  const What best = f.session.offered()->rows[0].kind;
  f.rest(f.last, 0.3, 0.9);
  EXPECT_EQ(f.session.offered()->chosen, 0U);
  f.lift();
  EXPECT_EQ(f.steps(), 1U);
  EXPECT_EQ(f.session.history().undo_label(), "Shape");
  EXPECT_EQ(f.session.document().layers().back().strokes.size(), 1U);
  // The other shape and the ink are still one choice away.
  const What other = f.session.offered()->rows[1].kind;
  EXPECT_NE(best, other);
  f.must(ChooseOffer{other});
  EXPECT_EQ(f.steps(), 1U);
  EXPECT_EQ(f.lines(), 1U);
}

TEST(SessionOffers, AMouseTakesTheShapeByStayingOrByAKey) {
  for (const bool key : {false, true}) {
    Fixture f;
    f.down(Fixture::round(1.0));
    f.rest(f.last, key ? 0.6 : 1.8);
    if (key) f.must(ChooseOffer{What::kCircle});
    f.lift();
    EXPECT_EQ(f.session.history().undo_label(), "Shape");
    f.must(ChooseOffer{What::kInk});
    EXPECT_EQ(f.session.history().undo_label(), "Draw");
  }
}

TEST(SessionOffers, GoingOnRefusesTheShape) {
  Fixture f;
  f.down(Fixture::round(1.0));
  f.rest(f.last, 0.6);
  ASSERT_TRUE(f.session.offered());
  for (int i = 0; i < 40; ++i) f.pen(f.last + Vec{0.5 * i, 0.0}, -0.1);
  EXPECT_FALSE(f.session.offered());
  f.lift();
  EXPECT_EQ(f.session.history().undo_label(), "Draw");
  EXPECT_FALSE(f.session.offered());
}

TEST(SessionOffers, AnOfferThatIsNotTakenStaysAfterTheLift) {
  Fixture f;
  f.down(Fixture::round(1.0));
  f.rest(f.last, 0.6);
  f.lift();
  EXPECT_EQ(f.session.history().undo_label(), "Draw");
  ASSERT_TRUE(f.offers(What::kCircle));
  f.must(ChooseOffer{What::kCircle});
  EXPECT_EQ(f.session.history().undo_label(), "Shape");
  const StrokePtr circle = f.session.document().find(f.session.document().layers()[0].strokes[0]);
  EXPECT_TRUE(circle->closed());
  EXPECT_NEAR(distance(circle->position(0.5), {50, 60}), 20.0, 0.2);
}

TEST(SessionOffers, WithoutTheOptionsALineIsInk) {
  Fixture f;
  for (const char* id : {"pencil.scratch_out", "pencil.double_loop", "pencil.shapes"}) {
    f.must(SetOption{id, false});
  }
  f.line(60.0);
  f.scratch({37.0, 56.0});
  EXPECT_FALSE(f.session.offered());
  f.down(Fixture::round(2.0));
  f.rest(f.last, 2.0);
  EXPECT_FALSE(f.session.offered());
  f.lift();
  EXPECT_FALSE(f.session.offered());
  EXPECT_EQ(f.lines(), 3U);
}

/// If no layer is open, the step of a line also adds its layer. The choice that replaces the line
/// must not lose it.
TEST(SessionOffers, AChoiceKeepsTheLayerThatTheLineAdded) {
  for (const auto& [closes, symmetry] :
       {std::pair{LayerEvent::Do::kLock, false}, std::pair{LayerEvent::Do::kHide, true}}) {
    for (const bool accepted : {false, true}) {
      Fixture f;
      if (symmetry) {
        GuidesEvent add{GuidesEvent::Do::kAdd};
        add.guide.kind = DrawingGuideKind::kSymmetry;
        add.guide.origin = {100, 0};
        add.guide.angle_rad = kTau / 4.0;
        add.guide.axes = 1;
        f.must(add);
      }
      f.must(LayerEvent{closes, LayerId{1}});
      const Document before = f.session.document();
      const std::size_t steps = f.steps();
      f.down(Fixture::round(1.0));
      f.rest(f.last, accepted ? 1.8 : 0.6);
      f.lift();
      const Document first = f.session.document();
      ASSERT_EQ(first.layers().size(), 2U);
      const std::size_t lines = symmetry ? 2U : 1U;
      EXPECT_EQ(f.lines(), lines);
      EXPECT_EQ(f.session.history().undo_label(), accepted ? "Shape" : "Draw");
      f.must(ChooseOffer{accepted ? What::kInk : What::kCircle});
      EXPECT_EQ(f.session.history().undo_label(), accepted ? "Draw" : "Shape");
      EXPECT_EQ(f.steps(), steps + 1) << "the layer and its ink are one step";
      EXPECT_EQ(f.lines(), lines);
      EXPECT_EQ(f.session.layer(), first.layers().back().id);
      const Document chosen = f.session.document();
      EXPECT_EQ(chosen.layers().back().id, first.layers().back().id);
      f.must(UndoEvent{});
      EXPECT_EQ(f.session.document(), before);
      f.must(RedoEvent{});
      EXPECT_EQ(f.session.document(), chosen);
      f.line(120.0);
      EXPECT_EQ(f.steps(), steps + 2) << "the next line is a step of its own";
    }
  }
}

TEST(SessionOffers, LockedAndHiddenLinesAreNotMeant) {
  for (const auto change : {LayerEvent::Do::kLock, LayerEvent::Do::kHide}) {
    Fixture f;
    f.line(60.0);
    f.must(LayerEvent{LayerEvent::Do::kAdd, {}});
    f.must(LayerEvent{change, LayerId{1}});
    f.scratch({37.0, 56.0});
    EXPECT_FALSE(f.session.offered());
  }
}

}  // namespace
}  // namespace felt::session_offers_test
