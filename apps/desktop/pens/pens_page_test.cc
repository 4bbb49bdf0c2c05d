#include "desktop/pens/pens_page.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QTabletEvent>
#include <QTest>
#include <algorithm>
#include <cmath>

#include "desktop/engine/settings.h"
#include "desktop/pens/pen_setting_keys.h"

namespace felt::desktop::pens_page_test {
namespace {

/// Every control that the user can reach has a text or an accessible name.
TEST(PensPage, HasNoNamelessControl) {
  PensPage page;
  for (const QWidget* widget : page.findChildren<QWidget*>()) {
    if (widget->focusPolicy() == Qt::NoFocus ||
        widget->objectName().startsWith(QLatin1String("qt_")))
      continue;
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    const bool inner = qobject_cast<const QComboBox*>(widget->parentWidget()) != nullptr;
    EXPECT_TRUE(inner || (button && !button->text().isEmpty()) ||
                !widget->accessibleName().isEmpty())
        << widget->metaObject()->className();
  }
}

TEST(PensPage, TheCurveFollowsSlidersHandlesAndKeys) {
  Settings::the().set(QString::fromLatin1(pen_keys::kPressureOn), true);
  PensPage page;
  page.resize(700, 600);
  page.show();
  auto* editor = page.findChild<PressureCurveEditor*>();
  ASSERT_NE(editor, nullptr);
  PressureCurve().store();
  EXPECT_EQ(editor->curve(), PressureCurve());
  const QList<QSlider*> sliders = page.findChildren<QSlider*>();
  ASSERT_EQ(sliders.size(), 2);
  sliders[0]->setValue(-100);
  EXPECT_GT(PressureCurve::load()(0.5), 0.6);
  sliders[1]->setValue(100);
  EXPECT_EQ(PressureCurve::load().threshold(), PressureCurve::kMaxThreshold);
  EXPECT_NEAR(PressureCurve::load().firmness(), -1.0, 1e-9) << "the other slider's stays";
  PressureCurve().store();
  editor->setFocus();
  for (int i = 0; i < 5; ++i) QTest::keyClick(editor, Qt::Key_Up);
  EXPECT_NEAR(PressureCurve::load().first().y(), 1.0 / 3.0 + 0.1, 1e-9);
  QTest::keyClick(editor, Qt::Key_Space);
  QTest::keyClick(editor, Qt::Key_Left);
  EXPECT_NEAR(PressureCurve::load().second().x(), 2.0 / 3.0 - 0.02, 1e-9);
  const QPoint middle = editor->rect().center();
  QTest::mousePress(editor, Qt::LeftButton, {}, middle);
  QTest::mouseRelease(editor, Qt::LeftButton, {}, middle);
  const PressureCurve now = PressureCurve::load();
  EXPECT_TRUE((now.first() - QPointF(0.5, 0.5)).manhattanLength() < 0.02 ||
              (now.second() - QPointF(0.5, 0.5)).manhattanLength() < 0.02);
  PressureCurve().store();
}

/// Tests a tablet that senses tilt, and one that does not.
TEST(PensPage, ShowsHowThePenTilts) {
  PensPage page;
  page.resize(700, 600);
  page.show();
  auto* area = page.findChild<PenTestArea*>();
  ASSERT_NE(area, nullptr);
  const auto says = [&page](const QString& words) {
    const QList<QLabel*> labels = page.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* label) { return label->text() == words; });
  };
  const auto tilt = [&](QInputDevice::Capabilities more) {
    const QPointingDevice pen(QStringLiteral("test pen"), 21, QInputDevice::DeviceType::Stylus,
                              QPointingDevice::PointerType::Pen,
                              QInputDevice::Capability::Position | more, 1, 3);
    QTabletEvent event(QEvent::TabletMove, &pen, {20, 20}, {20, 20}, 0.0, 45, 0, 0, 0, 0,
                       Qt::NoModifier, Qt::NoButton, Qt::NoButton);
    QApplication::sendEvent(area, &event);
  };
  const QString none = QStringLiteral("The tilt of the pen is not known");
  EXPECT_TRUE(says(none));
  tilt(QInputDevice::Capability::XTilt | QInputDevice::Capability::YTilt);
  EXPECT_TRUE(says(QStringLiteral("The pen is tilted by 45°")));
  tilt({});
  EXPECT_TRUE(says(none));
}

TEST(PensPage, TheTestAreaShowsWhatTheMouseDoes) {
  PensPage page;
  page.resize(700, 600);
  page.show();
  auto* area = page.findChild<PenTestArea*>();
  ASSERT_NE(area, nullptr);
  const QImage before = area->grab().toImage();
  int reported = 0;
  double last = 0.0;
  QObject::connect(area, &PenTestArea::pressed, [&](std::optional<double>, double curved) {
    ++reported;
    last = curved;
  });
  QTest::mousePress(area, Qt::LeftButton, {}, QPoint(20, 20));
  for (int x = 20; x < 120; x += 10) {
    QMouseEvent move(QEvent::MouseMove, QPointF(x, 25), QPointF(x, 25), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(area, &move);
  }
  EXPECT_EQ(last, 0.5);
  QTest::mouseRelease(area, Qt::LeftButton, {}, QPoint(120, 25));
  EXPECT_EQ(last, 0.0);
  EXPECT_GT(reported, 10);
  EXPECT_NE(area->grab().toImage(), before);
}

}  // namespace
}  // namespace felt::desktop::pens_page_test
