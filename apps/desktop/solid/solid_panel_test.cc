#include "desktop/solid/solid_panel.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QSignalSpy>
#include <QTest>
#include <memory>

#include "desktop/engine/settings.h"
#include "desktop/files/testing/studio_fixture.h"
#include "desktop/solid/solid_actions.h"
#include "desktop/solid/solid_setting_keys.h"
#include "desktop/solid/testing/drawn_lines.h"
#include "desktop/testing/accessible_names.h"

namespace felt::desktop::solid_panel_test {
namespace {

using testing::draw_square;

class SolidPanelTest : public ::testing::Test {
 protected:
  void TearDown() override { Settings::the().reset(solid_keys::kFillHoles); }
  bool waits() {
    return QTest::qWaitFor([this] { return panel_.is_up_to_date(); }, 20000);
  }
  template <class Widget>
  [[nodiscard]] Widget& control(const char* text) {
    for (Widget* widget : panel_.findChildren<Widget*>()) {
      if (widget->text().remove(QLatin1Char('&')).startsWith(QLatin1String(text))) return *widget;
    }
    ADD_FAILURE() << "there is no " << text;
    return *panel_.findChild<Widget*>();
  }
  [[nodiscard]] QString words() {
    QStringList words;
    for (QLabel* label : panel_.findChildren<QLabel*>()) words.push_back(label->text());
    return words.join(QLatin1Char('\n'));
  }
  [[nodiscard]] std::size_t bodies() const {
    return panel_.solid() ? panel_.solid()->bodies.size() : 0;
  }

  StudioFixture fixture_{testing::without_threads()};
  Studio& studio_ = fixture_.studio;
  SolidPanel panel_{studio_};
};

TEST_F(SolidPanelTest, FollowsEditsUndoAndOtherDrawings) {
  draw_square(studio_, {10, 10}, 40.0);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  ASSERT_EQ(bodies(), 1U);
  const std::shared_ptr<const Solid> first = panel_.solid();
  draw_square(studio_, {60, 10}, 30.0);
  EXPECT_FALSE(panel_.is_up_to_date());
  EXPECT_EQ(panel_.solid(), first) << "the body stays until the new ones are made";
  draw_square(studio_, {100, 10}, 30.0);
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 3U);
  studio_.apply(UndoEvent{});
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 2U);
  studio_.open(Document{}, Page{});
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 0U);
}

// Otherwise they could be exported under the name of another drawing.
TEST_F(SolidPanelTest, ForgetsTheBodiesWhenItIsClosedAndWhenAnotherDrawingIsOpened) {
  draw_square(studio_, {10, 10}, 40.0);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  ASSERT_TRUE(panel_.solid());
  QSignalSpy changes(&panel_, &SolidPanel::solid_changed);
  panel_.set_on(false);
  EXPECT_FALSE(panel_.solid());
  EXPECT_EQ(changes.count(), 1);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  ASSERT_TRUE(panel_.solid());
  studio_.open(Document{}, Page{});
  EXPECT_FALSE(panel_.solid()) << "at once";
  draw_square(studio_, {10, 10}, 40.0);
  panel_.set_on(false);
  panel_.set_on(true);  // while a job may run
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 1U);
}

TEST_F(SolidPanelTest, TheNewestDrawingWins) {
  panel_.set_on(true);
  for (int i = 0; i < 5; ++i) {
    draw_square(studio_, {10.0 + 40.0 * i, 10}, 30.0);
    QTest::qWait(SolidPanel::kWaitMs + 5);  // so that some of them begin
  }
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 5U);
}

TEST_F(SolidPanelTest, DoesNothingWhileItIsOff) {
  draw_square(studio_, {10, 10}, 40.0);
  QTest::qWait(2 * SolidPanel::kWaitMs);
  EXPECT_FALSE(panel_.solid());
  EXPECT_TRUE(panel_.is_up_to_date());
  panel_.set_on(true);
  panel_.set_on(false);  // while they are made
  QTest::qWait(500);
  EXPECT_FALSE(panel_.solid());
}

TEST_F(SolidPanelTest, WaitsWhileThePenIsDown) {
  draw_square(studio_, {10, 10}, 40.0);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  studio_.point({studio_.now_ns(), {100, 100}, true, 0.5});
  studio_.advance(50'000'000);
  draw_square(studio_, {60, 10}, 30.0);
  QTest::qWait(3 * SolidPanel::kWaitMs);
  EXPECT_FALSE(panel_.is_up_to_date());
  EXPECT_EQ(bodies(), 1U);
  studio_.point({studio_.now_ns(), {100, 100}, false, 0.0});
  studio_.advance(500'000'000);
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 2U);
}

TEST_F(SolidPanelTest, OffersAGapThatClosesTheLine) {
  draw_square(studio_, {10, 10}, 60.0, 12.0);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 0U);
  EXPECT_TRUE(words().contains(QStringLiteral("no line is closed"))) << words().toStdString();
  EXPECT_TRUE(words().contains(QStringLiteral("gap of 12.00 mm"))) << words().toStdString();
  auto& offer = control<QPushButton>("Close gaps up to 16 mm");
  ASSERT_FALSE(offer.isHidden());
  offer.click();
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 1U);
  EXPECT_TRUE(offer.isHidden());
  EXPECT_FALSE(control<QCheckBox>("Automatic").isChecked());
  control<QCheckBox>("Automatic").click();
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 0U);
}

TEST_F(SolidPanelTest, TheSliderSetsTheGapAndTheBoxFillsHoles) {
  draw_square(studio_, {10, 10}, 60.0, 5.0);
  draw_square(studio_, {30, 30}, 20.0);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  auto* gap = panel_.findChild<QSlider*>();
  EXPECT_EQ(gap->value(), 16) << "the automatic gap is 8 mm, in steps of 0.5";
  EXPECT_EQ(panel_.solid()->bodies.at(0).holes, 0);
  control<QCheckBox>("Fill holes").click();
  ASSERT_TRUE(waits());
  EXPECT_EQ(panel_.solid()->bodies.at(0).holes, 1);
  gap->setValue(2);
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 1U) << "only the inner square is closed";
  EXPECT_EQ(panel_.solid()->bodies.at(0).holes, 0);
}

TEST_F(SolidPanelTest, NamesWhatIsLeftOutAndOnlyCountsTheRest) {
  for (int i = 0; i < 5; ++i) {
    const double x = 60.0 * i;
    testing::draw_lines(studio_, {{x, 0}, {x + 40, 40}, {x + 40, 0}, {x + 10, 30}, {x, 0}});
  }
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  EXPECT_EQ(bodies(), 5U);
  EXPECT_TRUE(words().contains(QStringLiteral("Left out the smaller part: strokes s1 and s3")))
      << words().toStdString();
  EXPECT_TRUE(words().contains(QStringLiteral("and 2 more"))) << words().toStdString();
}

TEST_F(SolidPanelTest, EveryControlHasAName) {
  EXPECT_EQ(nameless_controls(panel_).join(QLatin1Char(',')).toStdString(), "");
}

TEST_F(SolidPanelTest, ExportsInEveryFormat) {
  add_solid_actions(fixture_.actions, *fixture_.files, panel_, &fixture_.window);
  QAction* stl = fixture_.actions.find(QStringLiteral("file.export_solid_stl"));
  ASSERT_TRUE(stl);
  EXPECT_FALSE(stl->isEnabled()) << "there is no body";
  draw_square(studio_, {10, 10}, 40.0);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  for (const char* ending : {"stl", "obj", "3mf", "glb"}) {
    QAction* action =
        fixture_.actions.find(QStringLiteral("file.export_solid_") + QString::fromLatin1(ending));
    ASSERT_TRUE(action && action->isEnabled());
    fixture_.person->next = fixture_.at("body");
    action->trigger();
    fixture_.files->finish_writing();
    const QString path = fixture_.at("body.") + QString::fromLatin1(ending);
    EXPECT_TRUE(fixture_.person->suggested.endsWith(QString::fromLatin1(ending)));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    const std::string expected =
        encode_solid(*panel_.solid(), solid_format_of(ending).value()).value();
    EXPECT_EQ(file.readAll().toStdString(), expected);
  }
  fixture_.person->next = fixture_.at("no/body.stl");
  stl->trigger();
  fixture_.files->finish_writing();
  ASSERT_EQ(fixture_.person->errors.size(), 1);
  EXPECT_TRUE(fixture_.person->errors[0].contains(QStringLiteral("body.stl")));
  studio_.apply(UndoEvent{});
  ASSERT_TRUE(waits());
  EXPECT_FALSE(stl->isEnabled());
}

TEST_F(SolidPanelTest, AnExportWithoutThePaintSaysSo) {
  add_solid_actions(fixture_.actions, *fixture_.files, panel_, &fixture_.window);
  QStringList said;
  QObject::connect(fixture_.files, &FileActions::exported, &panel_,
                   [&said](const QString&, const LostObjects& lost, const QString& changed) {
                     EXPECT_EQ(lost, LostObjects());
                     said.push_back(changed);
                   });
  const auto export_as = [this](const char* name, const char* ending) {
    fixture_.person->next = fixture_.at(name);
    fixture_.actions.find(QStringLiteral("file.export_solid_") + QString::fromLatin1(ending))
        ->trigger();
    fixture_.files->finish_writing();
  };
  draw_square(studio_, {10, 10}, 40.0);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  export_as("plain", "stl");
  EXPECT_EQ(said, QStringList{QString()}) << "the body has no paint";
  said.clear();
  draw_square(studio_, {25, 25}, 8.0);  // painted on the front
  ASSERT_TRUE(waits());
  for (const char* ending : {"stl", "obj", "3mf", "glb"}) export_as("body", ending);
  ASSERT_EQ(said.size(), 4);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(said[i].contains(QStringLiteral("glTF has it")));
  EXPECT_EQ(said[3], QString());
}

}  // namespace
}  // namespace felt::desktop::solid_panel_test
