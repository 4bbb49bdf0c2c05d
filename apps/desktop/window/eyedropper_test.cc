#include "desktop/window/eyedropper.h"

#include <gtest/gtest.h>

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

#include "desktop/window/color_notice.h"
#include "felt/document/edit_builder.h"
#include "felt/document/visible_strokes.h"
#include "felt/session/session_medium.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::eyedropper_test {
namespace {

constexpr Rgba kRed{0xb0, 0x20, 0x20, 255}, kGreen{0x20, 0xb0, 0x20, 128};

StrokePtr line_at(double y_mm, Rgba color, double width_mm, const char* medium) {
  StrokeData data =
      felt::testing::straight_stroke({20, y_mm}, {80, y_mm}, width_mm, width_mm).data();
  data.color = color;
  data.medium = medium;
  return std::make_shared<const Stroke>(Stroke::create(std::move(data)).value());
}

struct Fixture {
  Studio studio{{.live = false, .first_options = false}};
  QWidget window;
  Actions actions{&window};
  Canvas canvas{studio, &window};
  Eyedropper eyedropper{actions, canvas};

  Fixture() {
    canvas.resize(1600, 1200);
    canvas.fit_page();
    studio.import(QStringLiteral("test"),
                  std::vector{line_at(40, kRed, 2.0, "chalk"), line_at(41, kGreen, 1.0, "pencil")});
    studio.apply(SelectStrokes{SelectStrokes::What::kNone});
  }
  void click(Point mm, Qt::KeyboardModifiers keys = {}) {
    const QPoint px = canvas.view().to_px(mm).toPoint();
    QTest::mouseClick(&canvas, Qt::LeftButton, keys, px);
  }
};

TEST(Eyedropper, PicksTheTopmostInk) {
  const Fixture fixture;
  const Document& document = fixture.studio.session().document();
  ASSERT_TRUE(ink_at(document, {50, 41}, 0.1));
  EXPECT_EQ(ink_at(document, {50, 41}, 0.1)->color, kGreen);
  EXPECT_EQ(ink_at(document, {50, 40.5}, 0.1)->color, kGreen) << "both lines have ink here";
  EXPECT_EQ(ink_at(document, {50, 39.2}, 0.1)->color, kRed);
  EXPECT_NEAR(ink_at(document, {50, 39.2}, 0.1)->width_mm, 2.0, 1e-9);
  EXPECT_FALSE(ink_at(document, {50, 38.0}, 0.5));
  EXPECT_TRUE(ink_at(document, {50, 38.0}, 1.5));
}

TEST(Eyedropper, PicksTheFillBetweenLines) {
  const Fixture fixture;
  Document document = fixture.studio.session().document();
  constexpr Rgba kBlue{0, 0, 200, 255};
  FillLoop loop{{{20, 20}}, {}};
  for (const Point to : {Point{80, 20}, Point{80, 80}, Point{20, 80}, Point{20, 20}}) {
    loop.points.insert(loop.points.end(), {loop.points.back(), to, to});
  }
  EditBuilder builder(document);
  builder.add_fill(document.layers()[0].id, std::make_shared<const Fill>(Fill{{loop}, kBlue, 0.0}));
  ASSERT_TRUE(document.apply(std::move(builder).build("Fill")));
  EXPECT_EQ(ink_at(document, {50, 38.0}, 1.5)->color, kBlue) << "not that of the nearest line";
  EXPECT_EQ(ink_at(document, {50, 38.0}, 1.5)->medium, "");
  EXPECT_EQ(ink_at(document, {50, 41}, 0.1)->color, kGreen) << "lines are above fills";
  EXPECT_FALSE(ink_at(document, {50, 90.0}, 1.5));
}

TEST(Eyedropper, AClickPicksOnceAndDrawsNothing) {
  Fixture fixture;
  fixture.actions.find(QStringLiteral("edit.pick_color"))->trigger();
  ASSERT_TRUE(fixture.eyedropper.is_armed()) << "the nib is not on the page";
  fixture.click({50, 39.2});
  EXPECT_EQ(fixture.studio.session().ink_color(), kRed);
  EXPECT_EQ(drawing_medium(fixture.studio.session()), "pencil");
  EXPECT_FALSE(fixture.eyedropper.is_armed());
  EXPECT_EQ(fixture.studio.session().document().stroke_count(), 2U);
}

TEST(Eyedropper, WithShiftItPicksTheMediumAndTheWidthToo) {
  Fixture fixture;
  fixture.eyedropper.arm(Eyedropper::What::kColor);
  fixture.click({50, 39.2}, Qt::ShiftModifier);
  const Session& session = fixture.studio.session();
  EXPECT_EQ(session.ink_color(), kRed);
  EXPECT_EQ(drawing_medium(session), "chalk");
  ASSERT_TRUE(session.first_tool(ToolKind::kDraws)->size());
  EXPECT_NEAR(session.first_tool(ToolKind::kDraws)->size()->mm, 2.0, 0.01);
}

TEST(Eyedropper, EscapeEndsItAndAMissSaysSo) {
  Fixture fixture;
  fixture.eyedropper.arm(Eyedropper::What::kColor);
  QTest::keyClick(&fixture.canvas, Qt::Key_Escape);
  EXPECT_FALSE(fixture.eyedropper.is_armed());
  const Rgba before = fixture.studio.session().ink_color();
  QSignalSpy said(&fixture.studio, &Studio::refused);
  EXPECT_FALSE(fixture.eyedropper.pick({150, 150}, Eyedropper::What::kAll));
  EXPECT_EQ(said.count(), 1);
  EXPECT_EQ(fixture.studio.session().ink_color(), before);
}

TEST(Eyedropper, SelectedLinesGetTheColourToo) {
  Fixture fixture;
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  ASSERT_TRUE(fixture.eyedropper.pick({50, 39.2}, Eyedropper::What::kColor));
  for (const StrokePtr& stroke : visible_strokes(fixture.studio.session().document())) {
    EXPECT_EQ(stroke->color(), kRed);
  }
}

TEST(ColorNotice, OffersAVisibleColourOnceAndLeavesWhenItIsVisible) {
  Studio studio({.live = false, .first_options = false});
  QWidget window;
  ColorNotice notice(studio, &window);
  const auto wait = [] { QTest::qWait(ColorNotice::kDelayMs + 100); };
  wait();
  EXPECT_TRUE(notice.isHidden()) << "black on white";
  studio.apply(SetOption{"ink.color", std::string("#f4f1e6")});
  EXPECT_TRUE(notice.isHidden()) << "not while the colour is still being chosen";
  wait();
  ASSERT_FALSE(notice.isHidden());
  notice.hide();
  studio.apply(SetOption{"ink.color", std::string("#f4f1e6")});
  wait();
  EXPECT_TRUE(notice.isHidden()) << "the user has closed it for this colour";
  studio.apply(SetOption{"ink.color", std::string("#fefefe")});
  wait();
  ASSERT_FALSE(notice.isHidden());
  notice.findChild<QPushButton*>()->click();
  EXPECT_EQ(studio.session().ink_color(), (Rgba{0x33, 0x35, 0x3b, 255})) << "that of the pencil";
  EXPECT_TRUE(notice.isHidden());
  Page dark = studio.page();
  dark.paper = {0x20, 0x24, 0x22, 255};
  studio.set_page(dark);
  wait();
  EXPECT_FALSE(notice.isHidden()) << "the page has become as dark as the ink";
}

}  // namespace
}  // namespace felt::desktop::eyedropper_test
