// Turns the wheel over every control of every page and dialog: it scrolls, and changes no value.
#include <gtest/gtest.h>

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QMetaProperty>
#include <QScrollBar>
#include <QTest>
#include <QWheelEvent>
#include <memory>

#include "desktop/window/main_window.h"
#include "desktop/window/preferences.h"
#include "desktop/window/size_field.h"

namespace felt::desktop::wheel_test {
namespace {

/// Returns the value that the user sees and can change, or an invalid value for other widgets.
QVariant value_of(const QWidget& widget) {
  if (qobject_cast<const QScrollBar*>(&widget)) return {};
  if (const auto* list = qobject_cast<const QComboBox*>(&widget)) return list->currentIndex();
  if (const auto* slider = qobject_cast<const QAbstractSlider*>(&widget)) return slider->value();
  if (qobject_cast<const QAbstractSpinBox*>(&widget)) return widget.property("text");
  return {};
}

/// Turns the wheel up and down over each visible control of `top`, without and with the focus.
/// Returns the number of controls.
int turn_over_all(QWidget& top) {
  int count = 0;
  for (QWidget* control : top.findChildren<QWidget*>()) {
    const QVariant before = value_of(*control);
    if (!before.isValid() || !control->isVisible() || control->window() != top.window()) continue;
    ++count;
    for (const bool has_focus : {false, true}) {
      has_focus ? control->setFocus(Qt::MouseFocusReason) : control->clearFocus();
      for (const int units : {120, -120, -240}) {
        const QPointF at = control->rect().center();
        QWheelEvent wheel(at, control->mapToGlobal(at), {}, {0, units}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QWidget* under = control->childAt(at.toPoint());
        QApplication::sendEvent(under ? under : control, &wheel);
        EXPECT_EQ(value_of(*control), before)
            << control->metaObject()->className() << " " << control->accessibleName().toStdString();
      }
    }
  }
  return count;
}

TEST(Wheel, ChangesNoValueInThePreferences) {
  MainWindow window(StudioOptions{.device = QStringLiteral("tablet"), .live = false});
  Preferences preferences(window);
  preferences.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&preferences));
  int count = 0;
  for (const QString& page : preferences.page_names()) {
    ASSERT_TRUE(preferences.show_page(page));
    QApplication::processEvents();
    count += turn_over_all(preferences);
  }
  EXPECT_GT(count, 8);
}

TEST(Wheel, ChangesNoValueInAnyDialogOrPanel) {
  MainWindow window(StudioOptions{.device = QStringLiteral("tablet"), .live = false});
  window.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
  int count = 0;
  for (QDockWidget* panel : window.findChildren<QDockWidget*>()) {
    panel->show();
    panel->raise();
    QApplication::processEvents();
    count += turn_over_all(*panel->widget());
  }
  EXPECT_GT(count, 8);
  window.material_editor().show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&window.material_editor()));
  EXPECT_GT(turn_over_all(window.material_editor()), 3);
}

// The field of the size in the bar steps by the wheel: nothing scrolls there (size_field.h).
TEST(Wheel, StepsTheSizeInTheBar) {
  MainWindow window(StudioOptions{.device = QStringLiteral("tablet"), .live = false});
  window.show();
  auto* size = window.findChild<SizeField*>();
  ASSERT_NE(size, nullptr);
  const double before = size->value();
  QWheelEvent wheel({3, 3}, size->mapToGlobal(QPointF(3, 3)), {}, {0, 120}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(size, &wheel);
  EXPECT_GT(size->value(), before);
}

}  // namespace
}  // namespace felt::desktop::wheel_test
