#include "desktop/pens/steady_dialog.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>
#include <QPushButton>
#include <cmath>
#include <numbers>

#include "desktop/pens/steady_group.h"
#include "desktop/testing/accessible_names.h"

namespace felt::desktop::steady_dialog_test {
namespace {

/// Draws with the mouse in the area: a spiral of this many seconds, shaken by some pixels.
void draw_spiral(SpiralArea& area, double seconds, double shake_px, int step_ms = 8) {
  const QPointF middle = QRectF(area.rect()).center();
  const auto send = [&](QEvent::Type type, QPointF at, Qt::MouseButtons buttons, int ms) {
    QMouseEvent event(type, at, area.mapToGlobal(at), Qt::LeftButton, buttons, Qt::NoModifier);
    event.setTimestamp(static_cast<std::uint64_t>(1000 + ms));
    QApplication::sendEvent(&area, &event);
  };
  QPointF at = middle;
  const int end_ms = static_cast<int>(1e3 * seconds);
  for (int ms = 0; ms < end_ms; ms += step_ms) {
    const double s = 1e-3 * ms, a = 2.0 * std::numbers::pi * 0.5 * s;
    at = middle + 12.0 * s * QPointF(std::cos(a), std::sin(a)) +
         QPointF(shake_px * std::sin(2.0 * std::numbers::pi * 5.0 * s), 0.0);
    send(ms == 0 ? QEvent::MouseButtonPress : QEvent::MouseMove, at, Qt::LeftButton, ms);
  }
  send(QEvent::MouseButtonRelease, at, Qt::NoButton, end_ms);
}

QPushButton* button(QWidget& widget, const QString& text) {
  for (QPushButton* b : widget.findChildren<QPushButton*>()) {
    if (b->text().remove(QLatin1Char('&')) == text) return b;
  }
  return nullptr;
}

TEST(SteadyDialog, ASpiralSetsTheSteadyHand) {
  Studio studio({});
  SteadyDialog dialog(studio);
  dialog.resize(500, 600);
  dialog.show();
  ASSERT_FALSE(button(dialog, QStringLiteral("Use"))->isEnabled());
  draw_spiral(dialog.area(), 10.0, 5.0);
  ASSERT_TRUE(dialog.found()) << dialog.sentence().toStdString();
  EXPECT_NEAR(dialog.found()->hz, 5.0, 0.4);
  EXPECT_EQ(studio.session().option("pencil.steady"), OptionValue(false)) << "nothing is set yet";
  button(dialog, QStringLiteral("Use"))->click();
  EXPECT_EQ(studio.session().option("pencil.steady"), OptionValue(true));
  EXPECT_EQ(shake_of(studio.session()), *dialog.found());
}

TEST(SteadyDialog, SaysWhyItFindsNothing) {
  Studio studio({});
  SteadyDialog dialog(studio);
  dialog.resize(500, 600);
  dialog.show();
  draw_spiral(dialog.area(), 2.0, 5.0);
  EXPECT_TRUE(dialog.sentence().startsWith(QStringLiteral("That was too short")));
  button(dialog, QStringLiteral("Start again"))->click();
  EXPECT_TRUE(dialog.sentence().isEmpty());
  draw_spiral(dialog.area(), 10.0, 0.0);
  EXPECT_TRUE(dialog.sentence().startsWith(QStringLiteral("No shaking")));
  button(dialog, QStringLiteral("Start again"))->click();
  draw_spiral(dialog.area(), 10.0, 5.0, 60);
  EXPECT_TRUE(dialog.sentence().startsWith(QStringLiteral("This pen reports")));
  EXPECT_FALSE(dialog.found());
  EXPECT_FALSE(button(dialog, QStringLiteral("Use"))->isEnabled());
}

TEST(SteadyDialog, EveryControlHasAName) {
  Studio studio({});
  SteadyDialog dialog(studio);
  SteadyGroup group(studio);
  EXPECT_EQ(nameless_controls(dialog), QStringList());
  EXPECT_EQ(nameless_controls(group), QStringList());
}

TEST(SteadyGroup, ShowsAndSetsTheOption) {
  Studio studio({});
  SteadyGroup group(studio);
  auto* box = group.findChild<QCheckBox*>();
  ASSERT_TRUE(box);
  EXPECT_FALSE(box->isChecked());
  box->click();
  EXPECT_EQ(studio.session().option("pencil.steady"), OptionValue(true));
  studio.apply(SetOption{"pencil.steady", false});
  EXPECT_FALSE(box->isChecked());
}

}  // namespace
}  // namespace felt::desktop::steady_dialog_test
