// Tests of guides and of linked mirror images in a session, with the real tools.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "felt/base/constants.h"
#include "felt/document/edit_builder.h"
#include "felt/session/session.h"
#include "felt/session/symmetry_edit.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::session_guides_test {
namespace {

constexpr double kSameMm = 1e-9;

/// A session with one symmetry guide, and a pen.
struct MirrorFixture {
  explicit MirrorFixture(int axes = 1, double angle_rad = 1.5707963267948966) {
    session = std::make_unique<Session>(make_tools(), SessionOptions{});
    DrawingGuide guide{DrawingGuideKind::kSymmetry, {100, 100}, angle_rad};
    guide.axes = axes;
    must(GuidesEvent{GuidesEvent::Do::kAdd, {}, guide});
  }
  template <class Command>
  void must(Command what) {
    const Result<void> done = session->apply({now_ns += 1'000'000, std::move(what)});
    ASSERT_TRUE(done) << done.error().message;
  }
  void pen(Point p, double z) { must(PenEvent{{p.x, p.y, z}, {}, 0}); }
  void drag(const char* tool, Point from, Point to, int samples = 60) {
    must(SelectTool{tool});
    now_ns += 1'000'000'000;
    pen(from, 5);
    for (int i = 0; i <= samples; ++i) pen(lerp(from, to, double(i) / samples), -1);
    for (int i = 0; i < 100; ++i) pen(to, 5);
  }
  [[nodiscard]] const Document& document() const { return session->document(); }

  std::int64_t now_ns = 0;
  std::unique_ptr<Session> session;
};

/// Returns the largest distance between a stroke and the image of another one, mm; a large number
/// if one is missing or they look different.
double error_mm(const StrokePtr& from, const Affine& map, const StrokePtr& image) {
  if (!from || !image) return 1e9;
  const auto &a = from->data(), &b = image->data();
  if (a.points.size() != b.points.size() || a.widths != b.widths || a.color != b.color) return 1e9;
  double worst = 0.0;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    worst = std::max(worst, distance(apply(map, a.points[i]), b.points[i]));
  }
  return worst;
}

/// Returns the largest distance between a stroke of a group and the image of the first, mm.
double largest_error_mm(const Document& document) {
  double worst = 0.0;
  for (const auto& [id, group] : document.symmetries()) {
    const SymmetryImage& first = group->images.front();
    for (const SymmetryImage& image : group->images) {
      const Affine map = image_map(*group, first.image, image.image);
      worst =
          std::max(worst, error_mm(document.find(first.stroke), map, document.find(image.stroke)));
    }
  }
  return worst;
}

/// Returns how far the mapping to an image after that to another one is from the direct mapping.
double map_error_mm(const SymmetryGroup& group, int a, int b) {
  const Point p{12.5, 40.25};
  return distance(apply(image_map(group, b), p),
                  apply(image_map(group, a, b), apply(image_map(group, a), p)));
}

TEST(SessionGuides, TheMapsOfASymmetryAreAGroup) {
  for (const int axes : {1, 2, 3, 5, 16}) {
    const SymmetryGroup group{{3, -7}, 0.4, axes, {}};
    double worst_mm = 0.0;
    for (int i = 0; i < 4 * axes * axes; ++i) {
      worst_mm = std::max(worst_mm, map_error_mm(group, i / (2 * axes), i % (2 * axes)));
    }
    EXPECT_LT(worst_mm, 1e-12) << axes;
  }
}

TEST(SessionGuides, AnInkStrokeGetsItsImagesInOneStepOfUndo) {
  for (const int axes : {1, 2, 4}) {
    MirrorFixture f(axes);
    const std::size_t steps = f.session->history().undo_count();
    f.drag("pencil", {110, 97}, {140, 80});
    EXPECT_EQ(f.document().stroke_count(), 2U * static_cast<std::size_t>(axes));
    EXPECT_EQ(f.document().symmetries().size(), 1U);
    EXPECT_EQ(f.session->history().undo_count(), steps + 1);
    EXPECT_LT(largest_error_mm(f.document()), kSameMm);
    f.must(UndoEvent{});
    EXPECT_EQ(f.document().stroke_count(), 0U);
    EXPECT_TRUE(f.document().symmetries().empty());
  }
}

TEST(SessionGuides, HiddenGuidesMirrorNothing) {
  MirrorFixture f;
  f.must(GuidesEvent{GuidesEvent::Do::kHide});
  EXPECT_EQ(f.session->symmetry(), nullptr);
  f.drag("pencil", {110, 97}, {140, 80});
  EXPECT_EQ(f.document().stroke_count(), 1U);
  f.must(UndoEvent{});
  f.must(UndoEvent{});
  EXPECT_NE(f.session->symmetry(), nullptr) << "undo shows them again";
}

TEST(SessionGuides, APullOfOneStrokePullsItsImagesAndThePreviewShowsIt) {
  MirrorFixture f(2);
  f.drag("pencil", {110, 80}, {150, 80});
  const Document before = f.document();
  f.must(SelectTool{"pull"});
  f.now_ns += 1'000'000'000;
  f.pen({130, 80}, 5);
  for (int i = 0; i <= 60; ++i) f.pen({130, 80 - 0.2 * i}, -1);
  Document shown = f.document();
  ASSERT_TRUE(f.session->preview_with_fills());
  ASSERT_TRUE(shown.apply(*f.session->preview_with_fills()));
  EXPECT_NE(shown, before);
  EXPECT_LT(largest_error_mm(shown), kSameMm);
  for (int i = 0; i < 100; ++i) f.pen({130, 68}, 5);
  EXPECT_NE(f.document(), before);
  EXPECT_EQ(f.document().stroke_count(), 4U);
  EXPECT_LT(largest_error_mm(f.document()), kSameMm);
  f.must(UndoEvent{});
  EXPECT_EQ(f.document(), before);
}

/// Both images are in the circle. The one that moves more leads, although its length hardly
/// changes, while that of the other one does.
TEST(SessionGuides, ABulgeOfBothImagesIsThatOfTheOneThatMovesMore) {
  MirrorFixture f;
  f.drag("pencil", {103, 98}, {107, 98});
  f.must(SetOption{"pull.mode", std::string("bulge")});
  const Document before = f.document();
  const StrokePtr line = before.find(before.layers().front().strokes.front());
  f.drag("pull", {112, 100}, {124, 100});
  const Document& after = f.document();
  EXPECT_NE(after, before);
  EXPECT_LT(largest_error_mm(after), kSameMm);
  const StrokePtr moved = after.find(before.layers().front().strokes.front());
  EXPECT_GT(distance(moved->position(0.0), line->position(0.0)), 2.5);
  f.must(UndoEvent{});
  EXPECT_EQ(f.document(), before);
}

TEST(SessionGuides, TheEraserDividesAndRemovesImagesToo) {
  MirrorFixture f;
  f.drag("pencil", {110, 80}, {150, 80});
  f.drag("eraser", {130, 74}, {130, 86});
  EXPECT_EQ(f.document().stroke_count(), 4U) << "two parts on each side";
  EXPECT_EQ(f.document().symmetries().size(), 2U);
  EXPECT_LT(largest_error_mm(f.document()), kSameMm);
  f.must(SelectStrokes{SelectStrokes::What::kAll});
  f.must(DeleteEvent{});
  EXPECT_EQ(f.document().stroke_count(), 0U);
  EXPECT_TRUE(f.document().symmetries().empty());
}

TEST(SessionGuides, ACopyOfTheLayerIsErasedAsInkOfItsOwn) {
  MirrorFixture f;
  f.drag("pencil", {110, 80}, {150, 80});
  f.must(LayerEvent{LayerEvent::Do::kDuplicate, {1}});
  f.drag("eraser", {130, 74}, {130, 86});
  EXPECT_EQ(f.document().layers()[0].strokes.size(), 4U) << "two parts on each side";
  EXPECT_EQ(f.document().layers()[1].strokes.size(), 3U) << "the copies are not linked";
  EXPECT_LT(largest_error_mm(f.document()), kSameMm);
}

/// Draws a mirrored line whose free end is at (150, 80), and a line without images from `from`.
struct JoinFixture : MirrorFixture {
  explicit JoinFixture(Point from) {
    drag("pencil", {110, 80}, {150, 80});
    must(GuidesEvent{GuidesEvent::Do::kHide});
    drag("pencil", from, {175, 110});
    image = document().find(image_id());
  }
  [[nodiscard]] StrokeId image_id() const {
    for (const StrokeId id : document().layers().front().strokes) {
      if (document().find(id)->bounds().x1 < 100.0) return id;
    }
    return {};
  }
  StrokePtr image;
};

TEST(SessionGuides, AMirroredLineThatIsJoinedIntoAnotherOneKeepsItsImage) {
  const Point from{157, 84};
  JoinFixture f(from);
  ASSERT_EQ(f.document().stroke_count(), 3U);
  f.drag("connect", {150, 80}, from);
  EXPECT_EQ(f.document().stroke_count(), 2U) << "the joined line, and the image";
  EXPECT_EQ(f.document().find(f.image_id()), f.image);
  EXPECT_TRUE(f.document().symmetries().empty());
  f.must(UndoEvent{});
  EXPECT_EQ(f.document().stroke_count(), 3U);
  EXPECT_EQ(f.document().symmetries().size(), 1U);
}

TEST(SessionGuides, AJoinThatKeepsTheMirroredLineEndsItsGroup) {
  const Point from{157, 84};
  JoinFixture f(from);
  f.drag("connect", from, {150, 80});
  EXPECT_EQ(f.document().stroke_count(), 2U);
  EXPECT_EQ(f.document().find(f.image_id()), f.image);
  EXPECT_TRUE(f.document().symmetries().empty());
}

TEST(SessionGuides, TwoMirroredLinesAreJoinedOnBothSides) {
  MirrorFixture f;
  f.drag("pencil", {110, 80}, {150, 80});
  f.drag("pencil", {157, 84}, {175, 110});
  ASSERT_EQ(f.document().stroke_count(), 4U);
  f.drag("connect", {150, 80}, {157, 84});
  EXPECT_EQ(f.document().stroke_count(), 2U);
  EXPECT_EQ(f.document().symmetries().size(), 1U);
  EXPECT_LT(largest_error_mm(f.document()), kSameMm);
}

TEST(SessionGuides, InkBetweenTwoLinesKeepsTheImageOfOneOfThem) {
  JoinFixture f({165, 95});
  f.must(SetOption{"pencil.keep_separate", false});
  f.drag("pencil", {150, 80}, {165, 95}, 1000);
  EXPECT_EQ(f.document().stroke_count(), 2U);
  EXPECT_EQ(f.document().find(f.image_id()), f.image);
  EXPECT_TRUE(f.document().symmetries().empty());
}

TEST(SessionGuides, AMoveOfAllImagesMovesTheAxes) {
  MirrorFixture f;
  f.drag("pencil", {110, 80}, {150, 80});
  f.must(SelectStrokes{SelectStrokes::What::kAll});
  f.must(MoveEvent{{7, 3}});
  ASSERT_EQ(f.document().symmetries().size(), 1U);
  EXPECT_NEAR(f.document().symmetries().begin()->second->center.x, 107.0, 1e-9);
  EXPECT_LT(largest_error_mm(f.document()), kSameMm);
}

TEST(SessionGuides, RepeatedMovesOfAMirroredGroupAreOneStep) {
  MirrorFixture f;
  f.drag("pencil", {110, 80}, {150, 80});
  f.must(SelectStrokes{SelectStrokes::What::kAll});
  const Document before = f.document();
  const std::size_t steps = f.session->history().undo_count();
  for (int i = 0; i < 5; ++i) f.must(MoveEvent{{1, 0}});
  EXPECT_EQ(f.session->history().undo_count(), steps + 1);
  EXPECT_NEAR(f.document().symmetries().begin()->second->center.x, 105.0, 1e-9);
  const Document moved = f.document();
  f.must(UndoEvent{});
  EXPECT_EQ(f.document(), before);
  f.must(RedoEvent{});
  EXPECT_EQ(f.document(), moved);
}

/// Returns an edit that adds two lines, the second one so far away that its image has no valid
/// coordinates.
Edit near_and_far(const Document& document) {
  EditBuilder edit(document);
  for (const double size : {50.0, 1.3e308}) {
    edit.add(document.layers().front().id, std::make_shared<const Stroke>(testing::straight_stroke(
                                               {size, size}, {1.05 * size, size}, 1, 1)));
  }
  return std::move(edit).build("Draw");
}

/// Returns true if the edit changes or adds all strokes of a group.
bool has_strokes_of(const Edit& edit, const SymmetryChange& group) {
  const auto has = [&edit](const SymmetryImage& image) {
    return std::any_of(edit.changes.begin(), edit.changes.end(),
                       [&image](const StrokeChange& c) { return c.id == image.stroke; });
  };
  return std::all_of(group.after->images.begin(), group.after->images.end(), has);
}

TEST(SessionGuides, AnImageThatIsTooFarAwayLeavesNoHalfGroups) {
  Document document;
  DrawingGuide symmetry{DrawingGuideKind::kSymmetry, {20, 10}, kTau / 16.0};
  Edit edit = near_and_far(document);
  add_images(document, symmetry, edit);
  for (const SymmetryChange& group : edit.symmetries) {
    EXPECT_TRUE(has_strokes_of(edit, group));
  }
  ASSERT_TRUE(document.apply(edit));
  EXPECT_EQ(document.stroke_count(), 3U) << "the near line has its image";
  EXPECT_EQ(document.symmetries().size(), 1U);
  EXPECT_LT(largest_error_mm(document), kSameMm);
}

TEST(SessionGuides, UnlinkedStrokesDoNotFollow) {
  MirrorFixture f;
  f.drag("pencil", {110, 80}, {150, 80});
  f.must(SelectStrokes{SelectStrokes::What::kAll});
  f.must(GuidesEvent{GuidesEvent::Do::kUnlink});
  EXPECT_TRUE(f.document().symmetries().empty());
  const auto strokes = f.document().layers().front().strokes;
  const StrokePtr other = f.document().find(strokes[1]);
  f.drag("pull", {130, 80}, {130, 70});
  EXPECT_EQ(f.document().find(strokes[1]), other);
}

/// Makes ten random gestures. Returns the documents after each step.
std::vector<Document> random_gestures(MirrorFixture& f, testing::RandomStroke& random) {
  constexpr const char* kTools[] = {"pencil", "pull",    "smooth",  "width",
                                    "eraser", "recolor", "connect", "shape"};
  std::vector<Document> states{f.document()};
  for (int i = 0; i < 10; ++i) {
    const auto point = [&] {
      return Point{random.uniform(70.0, 130.0), random.uniform(70.0, 130.0)};
    };
    const char* tool = kTools[i < 2 ? 0 : random.pick(0, 7)];
    const std::size_t steps = f.session->history().undo_count();
    f.drag(tool, point(), point());
    EXPECT_LT(largest_error_mm(f.document()), kSameMm) << tool;
    if (f.session->history().undo_count() > steps) states.push_back(f.document());
  }
  return states;
}

TEST(SessionGuides, RandomGesturesKeepImagesAndUndoIsExact) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    testing::RandomStroke random(seed);
    MirrorFixture f(random.pick(1, 4), random.uniform(0.0, 3.0));
    std::vector<Document> states = random_gestures(f, random);
    ASSERT_FALSE(::testing::Test::HasFailure()) << "seed " << seed;
    EXPECT_FALSE(f.document().symmetries().empty() && f.document().stroke_count() > 1);
    for (; states.size() > 1; states.pop_back()) {
      ASSERT_EQ(f.document(), states.back());
      f.must(UndoEvent{});
    }
    EXPECT_EQ(f.document(), states.front());
  }
}

TEST(SessionGuides, EventsChangeGuidesAndBadOnesChangeNothing) {
  MirrorFixture f;
  const GuideId id = f.document().guides().begin()->first;
  DrawingGuide ruler;
  ruler.origin = {20, 30};
  f.must(GuidesEvent{GuidesEvent::Do::kChange, id, ruler});
  EXPECT_EQ(*f.document().find_guide(id), ruler);
  const Document before = f.document();
  ruler.size_mm = kNan;
  DrawingGuide trace{DrawingGuideKind::kTrace};
  trace.stroke = {77};
  for (const GuidesEvent& bad :
       {GuidesEvent{GuidesEvent::Do::kChange, id, ruler},
        GuidesEvent{GuidesEvent::Do::kAdd, {}, ruler}, GuidesEvent{GuidesEvent::Do::kRemove, {999}},
        GuidesEvent{GuidesEvent::Do::kAdd, {}, trace}}) {
    EXPECT_FALSE(f.session->apply({f.now_ns, bad}));
  }
  EXPECT_EQ(f.document(), before);
  f.must(GuidesEvent{GuidesEvent::Do::kClear});
  EXPECT_TRUE(f.document().guides().empty());
  f.must(UndoEvent{});
  EXPECT_EQ(f.document(), before);
}

TEST(SessionGuides, ATraceGoesWithItsStroke) {
  Session session(make_tools(), SessionOptions{});
  const StrokePtr line =
      std::make_shared<const Stroke>(testing::straight_stroke({10, 10}, {50, 10}, 1, 1));
  ASSERT_TRUE(session.import(0, ImportEvent{"x", true}, {&line, 1}));
  DrawingGuide trace{DrawingGuideKind::kTrace};
  trace.stroke = session.document().layers().front().strokes.front();
  ASSERT_TRUE(session.apply({1, GuidesEvent{GuidesEvent::Do::kAdd, {}, trace}}));
  ASSERT_TRUE(session.apply({2, DeleteEvent{}}));
  EXPECT_TRUE(session.document().guides().empty());
  ASSERT_TRUE(session.apply({3, UndoEvent{}}));
  EXPECT_EQ(session.document().guides().size(), 1U);
  EXPECT_EQ(session.document().stroke_count(), 1U);
}

/// Returns the ends of the stroke of the only guide.
std::pair<Point, Point> traced_ends(const Document& document) {
  if (document.guides().size() != 1) return {};
  const StrokePtr stroke = document.find(document.guides().begin()->second->stroke);
  if (!stroke) return {};
  return {stroke->data().points.front(), stroke->data().points.back()};
}

TEST(SessionGuides, ATraceFollowsTheLongestPartOfItsStroke) {
  MirrorFixture f;
  f.must(GuidesEvent{GuidesEvent::Do::kClear});
  f.drag("pencil", {100, 80}, {160, 80});
  DrawingGuide trace{DrawingGuideKind::kTrace};
  trace.stroke = f.document().layers().front().strokes.front();
  f.must(GuidesEvent{GuidesEvent::Do::kAdd, {}, trace});
  const Document whole = f.document();
  for (const double x : {110.0, 150.0}) {
    f.drag("eraser", {x, 74}, {x, 86});
    const auto [from, to] = traced_ends(f.document());
    EXPECT_NEAR(from.x, 113.0, 4.0);
    EXPECT_NEAR(to.x, x < 130 ? 160.0 : 147.0, 4.0);
  }
  EXPECT_EQ(f.document().stroke_count(), 3U);
  f.must(UndoEvent{});
  f.must(UndoEvent{});
  EXPECT_EQ(f.document(), whole);
}

TEST(SessionGuides, ATraceFollowsAStrokeThatIsJoinedIntoAnother) {
  MirrorFixture f;
  f.must(GuidesEvent{GuidesEvent::Do::kClear});
  f.drag("pencil", {100, 80}, {150, 80});
  DrawingGuide trace{DrawingGuideKind::kTrace};
  trace.stroke = f.document().layers().front().strokes.front();
  f.must(GuidesEvent{GuidesEvent::Do::kAdd, {}, trace});
  f.drag("pencil", {157, 84}, {175, 110});
  f.drag("connect", {150, 80}, {157, 84});
  ASSERT_EQ(f.document().stroke_count(), 1U);
  const auto [from, to] = traced_ends(f.document());
  EXPECT_LT(std::min(distance(from, {100, 80}), distance(to, {100, 80})), 1.0);
  EXPECT_LT(std::min(distance(from, {175, 110}), distance(to, {175, 110})), 1.0);
}

}  // namespace
}  // namespace felt::session_guides_test
