#include "desktop/panels/tool_bar.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QWidget>
#include <set>

#include "desktop/engine/tool_size.h"
#include "desktop/panels/edit_actions.h"
#include "desktop/panels/testing/panels_fixture.h"
#include "felt/document/visible_strokes.h"
#include "felt/stroke/testing/random_stroke.h"

namespace felt::desktop::tool_bar_test {
namespace {

using testing::still;

/// Returns the option that the size keys change.
QString size_option(const Studio& studio) {
  const std::string_view id = studio.session().tool().use().size;
  return QString::fromUtf8(id.data(), qsizetype(id.size()));
}

/// A fixture: a window with the actions of this folder.
struct ToolBarFixture {
  Studio studio{still()};
  QWidget window;
  Actions actions{&window};

  ToolBarFixture() {
    add_tool_actions(actions, studio);
    add_edit_actions(actions, studio);
    window.show();
    window.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&window));
  }
  [[nodiscard]] QAction* find(const char* name) const {
    return actions.find(QString::fromLatin1(name));
  }
  [[nodiscard]] std::string tool() const { return std::string(studio.session().tool().info().id); }
  [[nodiscard]] double number(const std::string& id) const {
    return std::get<double>(studio.session().option(id).value());
  }
};

TEST(ToolActions, KeysTakeTheToolsOfTheTables) {
  ToolBarFixture fixture;
  std::set<QString> keys;
  for (const auto& tool : fixture.studio.session().tools()) {
    const ToolInfo& info = tool->info();
    const QString name = QStringLiteral("tool.") + QString::fromStdString(std::string(info.id));
    const QAction* action = fixture.actions.find(name);
    ASSERT_NE(action, nullptr) << info.id;
    EXPECT_FALSE(action->icon().isNull());
    if (info.shortcut == 0) continue;
    EXPECT_TRUE(keys.insert(action->shortcut().toString()).second);
    QTest::keyClick(&fixture.window, info.shortcut);
    EXPECT_EQ(fixture.tool(), info.id);
    EXPECT_TRUE(action->isChecked());
  }
}

TEST(ToolActions, NoTwoActionsHaveTheSameKeys) {
  ToolBarFixture fixture;
  std::set<QString> keys;
  for (const QAction* action : fixture.actions.all()) {
    for (const QKeySequence& key : action->shortcuts()) {
      EXPECT_TRUE(keys.insert(key.toString()).second) << key.toString().toStdString();
    }
  }
}

TEST(ToolActions, SizesClimbAndFallWithinTheRangeOfEveryTool) {
  ToolBarFixture fixture;
  for (const auto& tool : fixture.studio.session().tools()) {
    const ToolInfo& info = tool->info();
    SCOPED_TRACE(info.id);
    fixture.studio.apply(SelectTool{std::string(info.id)});
    const QString option = size_option(fixture.studio);
    if (info.kind == ToolKind::kDraws || option.isEmpty()) continue;  // TheSizeOfThePencil...
    const std::string id = std::string(info.id) + "." + option.toStdString();
    const double start = fixture.number(id);
    QTest::keyClick(&fixture.window, Qt::Key_BracketRight);
    const double larger = fixture.number(id);
    EXPECT_GT(larger, start);
    EXPECT_LT(larger, 1.6 * start);
    QTest::keyClick(&fixture.window, Qt::Key_BracketLeft);
    EXPECT_NEAR(fixture.number(id), start, 0.2 * start);
    for (int i = 0; i < 60; ++i) fixture.find("tool.size_up")->trigger();
    const double largest = fixture.number(id);
    for (int i = 0; i < 99; ++i) fixture.find("tool.size_down")->trigger();
    EXPECT_LT(fixture.number(id), start);
    const auto* row =
        std::find_if(info.options.data(), info.options.data() + info.options.size(),
                     [&](const OptionSpec& spec) { return spec.id == option.toStdString(); });
    EXPECT_EQ(largest, row->max);
    EXPECT_EQ(fixture.number(id), row->min);
  }
}

// The thinnest line never becomes wider than the widest. The keys work up to the end of the range,
// which a message reports.
TEST(ToolActions, TheSizeOfThePencilIsTheLineOfAMouse) {
  ToolBarFixture fixture;
  const auto size = [&fixture] { return fixture.studio.session().tool().size().value(); };
  const double thin = fixture.number("pencil.min_width_mm"),
               broad = fixture.number("pencil.max_width_mm");
  EXPECT_NEAR(size().mm, thin + (broad - thin) * fixture.number("pencil.mouse_pressure"), 1e-12);
  set_tool_size(fixture.studio, 2.0);
  EXPECT_NEAR(size().mm, 2.0, 1e-9);
  EXPECT_NEAR(fixture.number("pencil.max_width_mm") / fixture.number("pencil.min_width_mm"),
              broad / thin, 1e-9);
  QSignalSpy said(&fixture.studio, &Studio::refused);
  double before = size().mm;
  for (int i = 0; i < 99 && said.isEmpty(); ++i) {
    fixture.find("tool.size_down")->trigger();
    EXPECT_LE(fixture.number("pencil.min_width_mm"), fixture.number("pencil.max_width_mm"));
    if (said.isEmpty()) {
      EXPECT_LT(size().mm, before);
    }
    before = size().mm;
  }
  EXPECT_NEAR(size().mm, size().min_mm, 1e-9);
  EXPECT_EQ(said.count(), 1);
  for (int i = 0; i < 99 && said.count() == 1; ++i) fixture.find("tool.size_up")->trigger();
  EXPECT_NEAR(size().mm, size().max_mm, 1e-9);
  EXPECT_EQ(said.count(), 2);
}

// The options panel and a custom medium allow widths above the range of the keys.
TEST(ToolActions, AKeyThatMakesItLargerNeverMakesItSmaller) {
  ToolBarFixture fixture;
  fixture.studio.apply(SetOption{"pencil.max_width_mm", 50.0});
  fixture.studio.apply(SetOption{"pencil.mouse_pressure", 1.0});
  const double before = fixture.studio.session().tool().size()->mm;
  ASSERT_NEAR(before, 50.0, 1e-9);
  QSignalSpy said(&fixture.studio, &Studio::refused);
  fixture.find("tool.size_up")->trigger();
  EXPECT_NEAR(fixture.studio.session().tool().size()->mm, before, 1e-9);
  EXPECT_EQ(said.count(), 1);
  fixture.find("tool.size_down")->trigger();
  EXPECT_LT(fixture.studio.session().tool().size()->mm, before);
}

TEST(ToolActions, TheSizeIsForShapesAndForTheSelectedLines) {
  ToolBarFixture fixture;
  fixture.studio.apply(SelectTool{"shape"});
  set_tool_size(fixture.studio, 2.0);
  const Session& session = fixture.studio.session();
  EXPECT_NEAR(tool_size(session)->mm, 2.0, 1e-9);
  EXPECT_NEAR(session.first_tool(ToolKind::kDraws)->size()->mm, 2.0, 1e-9);
  fixture.studio.import(QStringLiteral("test"),
                        std::vector{std::make_shared<const Stroke>(
                            felt::testing::straight_stroke({0, 0}, {60, 0}, 3, 5))});
  fixture.find("tool.size_up")->trigger();
  const StrokePtr line = session.document().find({1});
  EXPECT_NEAR(tool_size(session)->mm, 2.5, 1e-9);
  EXPECT_NEAR(line->width_mm(0.5), 2.5, 1e-9) << "the mean width";
  EXPECT_NEAR(line->width_mm(1.0) / line->width_mm(0.0), 5.0 / 3.0, 1e-9);
  fixture.studio.apply(SelectTool{"eraser"});
  fixture.find("tool.size_up")->trigger();
  EXPECT_EQ(session.document().find({1}), line) << "the eraser has its own size";
}

TEST(ToolActions, SizeIsThatOfTheModeInHand) {
  ToolBarFixture fixture;
  fixture.studio.apply(SelectTool{"pull"});
  EXPECT_EQ(size_option(fixture.studio), QStringLiteral("radius_mm"));
  fixture.studio.apply(SetOption{"pull.mode", std::string("push")});
  EXPECT_EQ(size_option(fixture.studio), QStringLiteral("nib_radius_mm"));
}

TEST(ToolActions, StrengthGoesInTenthsFromNoneToAll) {
  ToolBarFixture fixture;
  EXPECT_EQ(fixture.number("pencil.strength"), 0.6);
  fixture.find("tool.strength_up")->trigger();
  EXPECT_NEAR(fixture.number("pencil.strength"), 0.7, 1e-12);
  for (int i = 0; i < 20; ++i) fixture.find("tool.strength_up")->trigger();
  EXPECT_EQ(fixture.number("pencil.strength"), 1.0);
  QTest::keyClick(&fixture.window, Qt::Key_BracketLeft, Qt::ShiftModifier);
  EXPECT_NEAR(fixture.number("pencil.strength"), 0.9, 1e-12);
  for (int i = 0; i < 20; ++i) fixture.find("tool.strength_down")->trigger();
  EXPECT_EQ(fixture.number("pencil.strength"), 0.0);
}

TEST(ToolBar, AClickTakesTheToolAndTheBarFollowsKeys) {
  ToolBarFixture fixture;
  ToolBar bar(fixture.studio, fixture.actions);
  bar.show();
  for (const auto& tool : fixture.studio.session().tools()) {
    const QString name =
        QStringLiteral("tool.") + QString::fromStdString(std::string(tool->info().id));
    auto* button = qobject_cast<QToolButton*>(bar.widgetForAction(fixture.actions.find(name)));
    ASSERT_NE(button, nullptr);
    QTest::mouseClick(button, Qt::LeftButton);
    EXPECT_EQ(fixture.tool(), tool->info().id);
    int pressed = 0;
    for (auto* one : bar.findChildren<QToolButton*>()) pressed += one->isChecked() ? 1 : 0;
    EXPECT_EQ(pressed, 1);
    EXPECT_TRUE(button->isChecked());
  }
  EXPECT_EQ(testing::nameless(bar), std::vector<std::string>{});
}

TEST(ToolBar, ShowsABorrowedToolAndTheOneThatComesBack) {
  ToolBarFixture fixture;
  ToolBar bar(fixture.studio, fixture.actions);
  const QWidget* pencil = bar.widgetForAction(fixture.find("tool.pencil"));
  const QWidget* eraser = bar.widgetForAction(fixture.find("tool.eraser"));
  fixture.studio.borrow_tool(QStringLiteral("eraser"));
  EXPECT_TRUE(fixture.find("tool.eraser")->isChecked());
  EXPECT_TRUE(eraser->font().italic());
  EXPECT_TRUE(pencil->font().underline());
  fixture.studio.give_back_tool();
  EXPECT_TRUE(fixture.find("tool.pencil")->isChecked());
  EXPECT_FALSE(eraser->font().italic() || pencil->font().underline());
}

TEST(EditActions, NameTheStepAndDoItByKeys) {
  ToolBarFixture fixture;
  EXPECT_FALSE(fixture.find("edit.undo")->isEnabled());
  testing::draw_lines(fixture.studio, 2);
  fixture.studio.apply(LayerEvent{});
  EXPECT_EQ(fixture.find("edit.undo")->text(), QStringLiteral("&Undo Add layer"));
  QTest::keyClick(&fixture.window, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(fixture.find("edit.undo")->text(), QStringLiteral("&Undo Import"));
  EXPECT_EQ(fixture.find("edit.redo")->text(), QStringLiteral("&Redo Add layer"));
  QTest::keyClick(&fixture.window, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(fixture.studio.session().document().stroke_count(), 1U);
  QTest::keyClick(&fixture.window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(fixture.studio.session().document().stroke_count(), 2U);
  QTest::keyClick(&fixture.window, Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(fixture.studio.session().document().layers().size(), 2U);
  EXPECT_FALSE(fixture.find("edit.redo")->isEnabled());
  fixture.studio.open(Document{}, Page{});
  EXPECT_FALSE(fixture.find("edit.undo")->isEnabled());
}

TEST(EditActions, SelectDeleteAndDuplicateByKeys) {
  ToolBarFixture fixture;
  testing::draw_lines(fixture.studio, 3);
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kNone});
  EXPECT_FALSE(fixture.find("edit.delete")->isEnabled());
  QTest::keyClick(&fixture.window, Qt::Key_A, Qt::ControlModifier);
  EXPECT_EQ(fixture.studio.session().selection().strokes().size(), 3U);
  EXPECT_TRUE(fixture.find("edit.delete")->isEnabled());
  QTest::keyClick(&fixture.window, Qt::Key_D, Qt::ControlModifier);
  EXPECT_EQ(fixture.studio.session().document().stroke_count(), 6U);
  QTest::keyClick(&fixture.window, Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(fixture.studio.session().selection().strokes().size(), 3U);
  QTest::keyClick(&fixture.window, Qt::Key_Delete);
  EXPECT_EQ(fixture.studio.session().document().stroke_count(), 3U);
  QTest::keyClick(&fixture.window, Qt::Key_A, Qt::ControlModifier);
  QTest::keyClick(&fixture.window, Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_TRUE(fixture.studio.session().selection().empty());
  EXPECT_FALSE(fixture.find("edit.delete")->isEnabled());
}

TEST(EditActions, SelectedLinesBecomeBroaderAndThinner) {
  ToolBarFixture fixture;
  testing::draw_lines(fixture.studio, 2);
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kNone});
  EXPECT_FALSE(fixture.find("edit.broader")->isEnabled());
  const auto width = [&] {
    return visible_strokes(fixture.studio.session().document()).front()->widths()[0].width_mm;
  };
  const double before = width();
  fixture.studio.apply(SelectStrokes{SelectStrokes::What::kAll});
  fixture.find("edit.broader")->trigger();
  EXPECT_DOUBLE_EQ(width(), 1.25 * before);
  fixture.find("edit.thinner")->trigger();
  EXPECT_DOUBLE_EQ(width(), before);
  fixture.studio.apply(UndoEvent{});
  EXPECT_DOUBLE_EQ(width(), 1.25 * before) << "each is one step";
}

}  // namespace
}  // namespace felt::desktop::tool_bar_test
