#include "desktop/window/canvas_popup.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QInputDialog>
#include <QTest>
#include <QToolButton>

#include "desktop/engine/presets.h"
#include "desktop/engine/settings.h"
#include "desktop/materials/media_picker.h"
#include "desktop/testing/accessible_names.h"
#include "desktop/window/main_window.h"
#include "felt/session/session_medium.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::canvas_popup_test {
namespace {

StudioOptions still() {
  return {.device = QStringLiteral("tablet"), .live = false};
}

class CanvasPopupTest : public ::testing::Test {
 protected:
  CanvasPopupTest() {
    window_.show();
    Q_EMIT window_.canvas().popup_wanted({200, 150});
    popup_ = window_.findChild<CanvasPopup*>();
  }
  ~CanvasPopupTest() override { Settings::the().reset(QLatin1String(kPresets)); }

  void add_line() {
    window_.studio().import(QStringLiteral("test"),
                            std::vector{std::make_shared<const Stroke>(
                                felt::testing::straight_stroke({10, 10}, {30, 20}, 1, 1))});
  }
  std::string tool() { return std::string(window_.studio().session().tool().info().id); }
  QAction* entry(const QString& text) {
    for (QAction* action : popup_->actions()) {
      if (action->text().remove(QLatin1Char('&')) == text) return action;
    }
    return nullptr;
  }

  MainWindow window_{still()};
  CanvasPopup* popup_ = nullptr;
};

TEST_F(CanvasPopupTest, OpensAtThePointerWithToolsMediaAndCommands) {
  ASSERT_TRUE(popup_);
  EXPECT_TRUE(popup_->isVisible());
  EXPECT_TRUE(nameless_controls(*popup_).isEmpty());
  EXPECT_EQ(popup_->findChildren<MediaPicker*>().size(), 1);
  for (QToolButton* button : popup_->findChildren<QToolButton*>()) {
    const QAction* action = button->defaultAction();
    if (action && action->objectName() == QLatin1String("tool.eraser")) button->click();
  }
  EXPECT_EQ(tool(), "eraser");
  EXPECT_FALSE(popup_->isVisible()) << "a choice closes it";
  Q_EMIT window_.canvas().popup_wanted({200, 150});
  auto* media = popup_->findChild<MediaPicker*>();
  media->button("chalk")->click();
  EXPECT_EQ(drawing_medium(window_.studio().session()), "chalk");
  EXPECT_EQ(tool(), "pencil");
  EXPECT_FALSE(popup_->isVisible());
}

TEST_F(CanvasPopupTest, PastesWhereItWasOpened) {
  add_line();
  window_.actions().find(QStringLiteral("edit.copy"))->trigger();
  QAction* paste = entry(QStringLiteral("Paste here"));
  ASSERT_TRUE(paste);
  paste->trigger();
  const Document& document = window_.studio().session().document();
  ASSERT_EQ(document.stroke_count(), 2U);
  const Point middle = document.find({2})->position(0.5);
  EXPECT_LT(distance(middle, window_.canvas().view().to_mm({200, 150})), 1e-6);
}

TEST_F(CanvasPopupTest, StaysClosedWhileALineIsDrawn) {
  popup_->close();
  window_.studio().apply(PenEvent{{50, 50, 5}, {}, 0});
  window_.studio().apply(PenEvent{{50, 50, -1}, 0.5, 0});
  window_.studio().apply(PenEvent{{60, 50, -1}, 0.5, 0});
  ASSERT_TRUE(window_.studio().session().gesture_in_progress());
  Q_EMIT window_.canvas().popup_wanted({200, 150});
  EXPECT_FALSE(popup_->isVisible());
}

TEST_F(CanvasPopupTest, RecolourStaysWhenAMediumIsChosen) {
  popup_->close();
  Studio& studio = window_.studio();
  studio.apply(SelectTool{"recolor"});
  auto* media = window_.findChild<QComboBox*>(QStringLiteral("top_media"));
  const auto choose = [&](const char* id) {
    media->setCurrentIndex(media->findData(QString::fromLatin1(id)));
    Q_EMIT media->activated(media->currentIndex());
  };
  choose("charcoal");
  EXPECT_EQ(tool(), "recolor");
  EXPECT_EQ(studio.session().option("recolor.gives"), OptionValue(std::string("medium")));
  EXPECT_EQ(drawing_medium(studio.session()), "charcoal");
  studio.apply(SelectTool{"shape"});
  choose("chalk");
  EXPECT_EQ(tool(), "shape") << "shapes have the medium, too";
  studio.apply(SelectTool{"smooth"});
  choose("crayon");
  EXPECT_EQ(tool(), "pencil");
}

TEST_F(CanvasPopupTest, APresetIsKeptAndListed) {
  popup_->close();
  Studio& studio = window_.studio();
  studio.apply(SetOption{"pencil.medium", std::string("chalk")});
  window_.actions().find(QStringLiteral("edit.preset_keep"))->trigger();
  auto* dialog = window_.findChild<QInputDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_FALSE(dialog->textValue().isEmpty());
  dialog->setTextValue(QStringLiteral("Mine & yours"));
  dialog->accept();
  studio.apply(SetOption{"pencil.medium", std::string("crayon")});
  auto* button = window_.findChild<QToolButton*>(QStringLiteral("top_presets"));
  ASSERT_TRUE(button);
  Q_EMIT button->menu()->aboutToShow();
  ASSERT_EQ(button->menu()->actions().front()->text(), QStringLiteral("Mine && yours"));
  button->menu()->actions().front()->trigger();
  EXPECT_EQ(drawing_medium(studio.session()), "chalk");
  QMenu* remove = button->menu()->actions().back()->menu();
  ASSERT_TRUE(remove);
  remove->actions().front()->trigger();
  EXPECT_TRUE(stored_presets().empty());
}

}  // namespace
}  // namespace felt::desktop::canvas_popup_test
