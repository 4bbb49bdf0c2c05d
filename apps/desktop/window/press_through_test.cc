#include "desktop/window/press_through.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QMainWindow>
#include <QMenu>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QTabletEvent>
#include <QTest>
#include <QToolBar>
#include <QToolButton>
#include <QWindow>

namespace felt::desktop::press_through_test {
namespace {

/// A page that counts the presses that reach it.
class PressedPage : public QWidget {
 public:
  int presses = 0, releases = 0, touches = 0;

 protected:
  void mousePressEvent(QMouseEvent*) override { ++presses; }
  void mouseReleaseEvent(QMouseEvent*) override { ++releases; }
  void tabletEvent(QTabletEvent* event) override {
    if (event->type() == QEvent::TabletPress) ++touches;
    event->accept();
  }
};

class PressThroughTest : public ::testing::Test {
 protected:
  PressThroughTest() {
    window_.setCentralWidget(page_);
    auto* bar = window_.addToolBar(QStringLiteral("bar"));
    list_->addItems({QStringLiteral("one"), QStringLiteral("two"), QStringLiteral("three")});
    menu_->addAction(QStringLiteral("first"));
    submenu_ = menu_->addMenu(QStringLiteral("more"));
    submenu_->addAction(QStringLiteral("second"));
    opener_->setMenu(menu_);
    opener_->setText(QStringLiteral("menu"));
    opener_->setPopupMode(QToolButton::InstantPopup);
    bar->addWidget(list_);
    bar->addWidget(opener_);
    window_.resize(600, 500);
    window_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window_));
    window_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window_));
  }

  /// As on X11, Qt does not send presses beside a pop-up once more.
  void open_list() {
    list_->showPopup();
    QApplication::activePopupWidget()->setAttribute(Qt::WA_NoMouseReplay);
  }
  void open_menu() {
    menu_->popup(opener_->mapToGlobal(QPoint(0, opener_->height())));
    QApplication::activePopupWidget()->setAttribute(Qt::WA_NoMouseReplay);
  }
  /// Sends an event as the window system does, so that an open pop-up gets it first.
  void click(const QWidget& on, Qt::MouseButton button = Qt::LeftButton) {
    const QPoint at = on.mapToGlobal(on.rect().center());
    const auto target = [this] {
      const QWidget* popup = QApplication::activePopupWidget();
      return (popup ? popup : static_cast<const QWidget*>(&window_))->windowHandle();
    };
    QTest::mousePress(target(), button, {}, target()->mapFromGlobal(at));
    QApplication::processEvents();
    QTest::mouseRelease(target(), button, {}, target()->mapFromGlobal(at));
    QApplication::processEvents();
  }

  QMainWindow window_;
  PressThrough through_{window_};
  PressedPage* page_ = new PressedPage;
  QComboBox* list_ = new QComboBox;
  QToolButton* opener_ = new QToolButton;
  QMenu* menu_ = new QMenu(opener_);
  QMenu* submenu_ = nullptr;
};

TEST_F(PressThroughTest, APressOnThePageReachesItAndClosesThePopUp) {
  int presses = 0;
  for (const Qt::MouseButton button : {Qt::LeftButton, Qt::RightButton}) {
    open_list();
    click(*page_, button);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
    EXPECT_EQ(page_->presses, ++presses);
    EXPECT_EQ(page_->releases, presses);
    open_menu();
    click(*page_, button);
    EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
    EXPECT_EQ(page_->presses, ++presses);
    EXPECT_EQ(page_->releases, presses);
  }
}

TEST_F(PressThroughTest, AnotherControlActs) {
  open_menu();
  click(*list_);
  ASSERT_NE(QApplication::activePopupWidget(), nullptr);
  EXPECT_EQ(QApplication::activePopupWidget()->parentWidget(), list_) << "the other list is open";
  QApplication::activePopupWidget()->close();
}

TEST_F(PressThroughTest, TheControlThatOpenedAListClosesIt) {
  open_menu();
  click(*opener_);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
}

TEST_F(PressThroughTest, AnOpenSubmenuClosesToo) {
  open_menu();
  submenu_->popup(menu_->mapToGlobal(QPoint(menu_->width(), 0)));
  submenu_->setAttribute(Qt::WA_NoMouseReplay);
  click(*page_);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
  EXPECT_EQ(page_->presses, 1);
}

TEST_F(PressThroughTest, APressInThePopUpChooses) {
  open_menu();
  int chosen = 0;
  QObject::connect(menu_->actions().front(), &QAction::triggered, [&chosen] { ++chosen; });
  const QPoint at = menu_->actionGeometry(menu_->actions().front()).center();
  QTest::mouseMove(menu_->windowHandle(), at);
  QTest::mouseClick(menu_->windowHandle(), Qt::LeftButton, {}, at);
  EXPECT_EQ(chosen, 1);
  EXPECT_EQ(page_->presses, 0);
}

TEST_F(PressThroughTest, AnotherWindowIsLeftAlone) {
  QMenu menu;  // of no window
  menu.addAction(QStringLiteral("one"));
  menu.popup(window_.mapToGlobal(QPoint(0, 60)));
  menu.setAttribute(Qt::WA_NoMouseReplay);
  click(*page_);
  EXPECT_EQ(page_->presses, 0);
  menu.close();
}

TEST_F(PressThroughTest, ATabletTouchesThePage) {
  const auto* pen =
      new QPointingDevice(QStringLiteral("test pen"), 41, QInputDevice::DeviceType::Stylus,
                          QPointingDevice::PointerType::Pen,
                          QInputDevice::Capability::Position | QInputDevice::Capability::Pressure,
                          1, 3, {}, QPointingDeviceUniqueId::fromNumericId(41), qApp);
  open_list();
  QWidget* popup = QApplication::activePopupWidget();
  const QPointF global = page_->mapToGlobal(QPointF(page_->rect().center()));
  QTabletEvent event(QEvent::TabletPress, pen, popup->mapFromGlobal(global), global, 0.5, 0, 0, 0,
                     0, 0, {}, Qt::LeftButton, Qt::LeftButton);
  QApplication::sendEvent(popup->window()->windowHandle(), &event);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
  EXPECT_EQ(page_->touches, 1);
}

}  // namespace
}  // namespace felt::desktop::press_through_test
