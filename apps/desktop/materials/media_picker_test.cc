#include "desktop/materials/media_picker.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QSignalSpy>
#include <QTest>
#include <vector>

#include "desktop/engine/testing/kept_events.h"
#include "desktop/materials/medium_picture.h"
#include "desktop/testing/accessible_names.h"
#include "felt/document/visible_strokes.h"
#include "felt/session/session_medium.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::media_picker_test {
namespace {

struct Fixture {
  std::vector<Event> events;
  Studio studio{{.device = QStringLiteral("simulated:touch"),
                 .live = false,
                 .first_options = false,
                 .connect_early = keep_events(events)}};
  QWidget window;
  MediaPictures pictures{studio, &window};
  MediaPicker picker{studio, pictures, &window};
};

double number(const Studio& studio, const char* id) {
  return std::get<double>(studio.session().option(id).value());
}

TEST(MediaPicker, OffersEveryMediumThatDrawsAndNoEraser) {
  Fixture fixture;
  ASSERT_GE(fixture.picker.ids().size(), 9u);
  for (const Medium& medium : media()) {
    QAbstractButton* button = fixture.picker.button(medium.id);
    ASSERT_EQ(button != nullptr, medium.draws) << medium.id;
    if (!button) continue;
    EXPECT_FALSE(button->text().isEmpty());
    EXPECT_FALSE(button->toolTip().isEmpty());
    EXPECT_TRUE(button->focusPolicy() & Qt::TabFocus);
  }
  EXPECT_TRUE(fixture.picker.button("pencil")->isChecked());
  EXPECT_TRUE(nameless_controls(fixture.picker).isEmpty());
}

TEST(MediaPicker, AClickTakesAMediumWithItsOwnWidthsAsEvents) {
  Fixture fixture;
  for (const Medium& medium : media()) {
    if (!medium.draws) continue;
    fixture.studio.apply(SetOption{"pencil.gamma", OptionValue(4.0)});
    fixture.picker.button(medium.id)->click();
    EXPECT_EQ(drawing_medium(fixture.studio.session()), medium.id);
    EXPECT_EQ(number(fixture.studio, "pencil.min_width_mm"), medium.line.min_mm) << medium.id;
    EXPECT_EQ(number(fixture.studio, "pencil.max_width_mm"), medium.line.max_mm) << medium.id;
    EXPECT_EQ(number(fixture.studio, "pencil.gamma"), medium.line.gamma) << medium.id;
  }
  // The events give the same result in another session.
  Session other(make_tools(), {});
  for (const Event& event : fixture.events) {
    if (!std::holds_alternative<SetOption>(event.what)) continue;
    ASSERT_TRUE(other.apply(event));
  }
  for (const char* id : {"pencil.medium", "pencil.min_width_mm", "pencil.max_width_mm"}) {
    EXPECT_EQ(other.option(id).value(), fixture.studio.session().option(id).value()) << id;
  }
}

std::string ink(const Studio& studio) {
  return std::get<std::string>(studio.session().option("ink.color").value());
}

TEST(MediaPicker, NewInkIsOfTheUsualColourUnlessAPersonChoseAnother) {
  Fixture fixture;
  ASSERT_EQ(ink(fixture.studio), "#000000");
  ASSERT_TRUE(take_medium(fixture.studio, "pencil"));
  EXPECT_EQ(ink(fixture.studio), "#000000") << "it was in hand already";
  ASSERT_TRUE(take_medium(fixture.studio, "chalk"));
  EXPECT_EQ(ink(fixture.studio), "#3c66a0") << "white chalk is invisible on white paper";
  fixture.studio.apply(SetOption{"surface.material", std::string("blackboard")});
  EXPECT_EQ(ink(fixture.studio), "#f4f1e6");
  fixture.studio.apply(SetOption{"surface.material", std::string("paper")});
  EXPECT_EQ(ink(fixture.studio), "#3c66a0");
  ASSERT_TRUE(take_medium(fixture.studio, "crayon"));
  EXPECT_EQ(ink(fixture.studio), "#c0402f");
  // A transparent version of a colour counts as the same colour.
  fixture.studio.apply(SetOption{"ink.color", std::string("#c0402f80")});
  ASSERT_TRUE(take_medium(fixture.studio, "pencil"));
  EXPECT_EQ(ink(fixture.studio), "#33353b80");
  fixture.studio.apply(SetOption{"ink.color", std::string("#20a040")});
  for (const char* medium : {"chalk", "felt-tip", "pencil"}) {
    ASSERT_TRUE(take_medium(fixture.studio, medium));
    EXPECT_EQ(ink(fixture.studio), "#20a040") << medium;
  }
  EXPECT_FALSE(fixture.studio.is_modified()) << "nothing is drawn yet";
}

TEST(MediaPicker, FollowsWhatOthersChoose) {
  Fixture fixture;
  fixture.studio.apply(SetOption{"pencil.medium", OptionValue(std::string("chalk"))});
  EXPECT_TRUE(fixture.picker.button("chalk")->isChecked());
  EXPECT_FALSE(fixture.picker.button("pencil")->isChecked());
}

TEST(MediaPicker, KeysTakeAMedium) {
  Fixture fixture;
  fixture.window.resize(300, 400);
  fixture.picker.resize(300, 400);
  fixture.window.show();
  fixture.window.activateWindow();
  static_cast<void>(QTest::qWaitForWindowActive(&fixture.window));
  QAbstractButton* first = fixture.picker.button("pencil");
  first->setFocus();
  QTest::keyClick(first, Qt::Key_Right);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  EXPECT_NE(drawing_medium(fixture.studio.session()), "pencil");
}

TEST(MediaPicker, PicturesComeByThemselvesAndAreOthersOnAnotherSurface) {
  Fixture fixture;
  QSignalSpy changed(&fixture.pictures, &MediaPictures::changed);
  ASSERT_TRUE(changed.wait(8000));
  const QImage on_paper = fixture.pictures.of("chalk"), pencil = fixture.pictures.of("pencil");
  ASSERT_FALSE(on_paper.isNull());
  EXPECT_NE(on_paper, pencil);
  EXPECT_FALSE(fixture.picker.button("chalk")->icon().isNull());
  fixture.studio.apply(SetOption{"surface.material", OptionValue(std::string("canvas"))});
  ASSERT_TRUE(changed.wait(8000));
  EXPECT_NE(fixture.pictures.of("chalk"), on_paper);
}

TEST(MediaPicker, AsManySideBySideAsThereIsRoomFor) {
  Fixture fixture;
  EXPECT_GT(fixture.picker.height_for(160), fixture.picker.height_for(600));
  fixture.picker.resize(160, 10);
  EXPECT_EQ(fixture.picker.height(), fixture.picker.height_for(160));
  for (const std::string& id : fixture.picker.ids()) {
    EXPECT_TRUE(fixture.picker.rect().contains(fixture.picker.button(id)->geometry())) << id;
  }
}

TEST(MediumPicture, AStrokeGoesFromLightToHard) {
  const QImage image =
      draw_medium({.medium = *find_medium("charcoal"), .surface = *find_surface("rough-paper")});
  ASSERT_EQ(image.size(), QSize(64, 26));
  const auto ink = [&image](int from, int to) {
    int sum = 0;
    for (int x = from; x < to; ++x) {
      for (int y = 0; y < image.height(); ++y) sum += 255 - qGray(image.pixel(x, y));
    }
    return sum;
  };
  EXPECT_GT(ink(40, 60), 2 * ink(4, 24));
  EXPECT_GT(ink(4, 24), 0);
}

TEST(MediumPicture, InkIsSeenOnAnyPaper) {
  EXPECT_EQ(readable_ink(Qt::red, Qt::white), QColor(Qt::red));
  EXPECT_LT(qGray(readable_ink(Qt::white, Qt::white).rgb()), 80);
  EXPECT_GT(qGray(readable_ink(Qt::black, QColor(40, 40, 40)).rgb()), 200);
}

TEST(MediaPicker, AClickIsForTheSelectedLinesTooAndSaysTheColour) {
  Studio studio({.live = false});
  studio.import(QStringLiteral("test"),
                std::vector{std::make_shared<const Stroke>(
                    felt::testing::straight_stroke({10, 10}, {90, 40}, 1, 2))});
  studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  QSignalSpy said(&studio, &Studio::refused);
  const std::size_t steps = studio.session().history().undo_count();
  ASSERT_TRUE(choose_medium(studio, "crayon"));
  EXPECT_EQ(visible_strokes(studio.session().document()).front()->medium(), "crayon");
  EXPECT_EQ(studio.session().history().undo_count(), steps + 1);
  ASSERT_EQ(said.count(), 1);
  EXPECT_TRUE(said[0][0].toString().contains(QLatin1Char('#')));
}

}  // namespace
}  // namespace felt::desktop::media_picker_test
