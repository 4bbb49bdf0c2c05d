#include "desktop/panels/tactile_panel.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>

#include "desktop/engine/settings.h"
#include "desktop/panels/panel_setting_keys.h"
#include "desktop/panels/testing/panels_fixture.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::tactile_panel_test {
namespace {

class TactilePanelTest : public ::testing::Test {
 protected:
  TactilePanelTest() {
    QObject::connect(&panel_, &TactilePanel::marks_changed, &panel_,
                     [this](const Overlay& marks) { marks_ = marks; });
  }
  ~TactilePanelTest() override {
    Settings::the().reset(QString::fromLatin1(panel_keys::kTactileEmbossed));
  }
  void add_line(double y) {
    studio_.import(QStringLiteral("test"),
                   std::vector{std::make_shared<const Stroke>(
                       felt::testing::straight_stroke({20, y}, {80, y}, 1, 1))});
  }
  bool waits() {
    return QTest::qWaitFor([this] { return panel_.is_up_to_date(); }, 20000);
  }
  [[nodiscard]] QListWidget& list() { return *panel_.findChild<QListWidget*>(); }

  Studio studio_{testing::still()};
  TactilePanel panel_{studio_};
  Overlay marks_;
};

TEST_F(TactilePanelTest, ListsAndMarksTheFaultsAfterEachEdit) {
  add_line(20);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  EXPECT_EQ(list().count(), 0);
  add_line(26);
  EXPECT_FALSE(panel_.is_up_to_date()) << "the check waits until the drawing rests";
  ASSERT_TRUE(waits());
  ASSERT_EQ(list().count(), 1);
  EXPECT_EQ(list().item(0)->text().toStdString(),
            "1 Gap: 5.0 mm between lines, for 60 mm; at least 6.4 mm");
  ASSERT_EQ(marks_.rings.size(), 1U);
  EXPECT_NEAR(marks_.rings[0].center.y, 23.0, 0.1);
  EXPECT_EQ(marks_.labels[0].text, "1 Gap");
  studio_.apply(UndoEvent{});
  ASSERT_TRUE(waits());
  EXPECT_EQ(list().count(), 0);
  EXPECT_TRUE(marks_.rings.empty());
}

TEST_F(TactilePanelTest, LayersOutOfViewAreNotChecked) {
  add_line(20);
  const LayerId first = studio_.session().layer();
  studio_.apply(LayerEvent{});
  add_line(26);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  EXPECT_EQ(list().count(), 1);
  studio_.apply(UseView{{first}});
  ASSERT_TRUE(waits());
  EXPECT_EQ(list().count(), 0);
}

TEST_F(TactilePanelTest, LinesInTheColourOfThePaperAreNotChecked) {
  add_line(20);
  add_line(26);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  EXPECT_EQ(list().count(), 1);
  Page page = studio_.page();
  page.paper = studio_.session().seen().find(panel_.faults()[0].stroke)->color();
  studio_.set_page(page);
  ASSERT_TRUE(waits());
  EXPECT_EQ(list().count(), 0);
}

TEST_F(TactilePanelTest, OnlyTheFirstFaultOfARuleHasALabel) {
  for (const double y : {20.0, 26.0, 32.0}) add_line(y);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  EXPECT_EQ(marks_.rings.size(), 2U);
  ASSERT_EQ(marks_.labels.size(), 1U);
  EXPECT_EQ(marks_.labels[0].text, "1 Gap");
}

TEST_F(TactilePanelTest, AClickGoesToTheFault) {
  add_line(20);
  add_line(26);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  std::vector<Point> wanted;
  QObject::connect(&panel_, &TactilePanel::wants_position, &panel_,
                   [&wanted](Point at) { wanted.push_back(at); });
  Q_EMIT list().itemActivated(list().item(0));
  ASSERT_EQ(wanted.size(), 1U);
  EXPECT_EQ(wanted[0], panel_.faults()[0].at);
}

TEST_F(TactilePanelTest, TheMarksGoWhenItIsOffAndTheEmbosserAllowsMore) {
  add_line(20);
  add_line(26);
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  panel_.set_on(false);
  EXPECT_TRUE(marks_.rings.empty());
  add_line(40);
  QTest::qWait(TactilePanel::kWaitMs + 50);
  EXPECT_TRUE(marks_.rings.empty());
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  EXPECT_EQ(marks_.rings.size(), 1U);
  panel_.findChild<QComboBox*>()->setCurrentIndex(1);
  ASSERT_TRUE(waits());
  EXPECT_TRUE(marks_.rings.empty());
}

TEST_F(TactilePanelTest, ADrawingOfKilometresIsRefusedInWords) {
  studio_.import(QStringLiteral("test"),
                 std::vector{std::make_shared<const Stroke>(
                     felt::testing::straight_stroke({0, 0}, {2e5, 0}, 1, 1))});
  panel_.set_on(true);
  ASSERT_TRUE(waits());
  EXPECT_EQ(list().count(), 0);
  bool is_said = false;
  for (const QLabel* label : panel_.findChildren<QLabel*>()) {
    is_said = is_said || label->text().contains(QStringLiteral("100 m"));
  }
  EXPECT_TRUE(is_said);
}

TEST_F(TactilePanelTest, EveryControlHasAName) {
  EXPECT_TRUE(testing::nameless(panel_).empty());
}

/// The panel may be closed while the check runs.
TEST(TactilePanel, MayGoWhileTheCheckRuns) {
  Studio studio(testing::still());
  {
    TactilePanel panel(studio);
    panel.set_on(true);
  }
  QTest::qWait(100);
}

}  // namespace
}  // namespace felt::desktop::tactile_panel_test
