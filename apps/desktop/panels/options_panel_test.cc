#include "desktop/panels/options_panel.h"

#include "desktop/engine/first_options.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <map>

#include "desktop/engine/settings.h"
#include "desktop/engine/tool_texts.h"
#include "desktop/engine/wheel_guard.h"
#include "desktop/panels/testing/panels_fixture.h"

namespace felt::desktop::options_panel_test {
namespace {

using testing::still;

std::string id_of(const Studio& studio, const OptionSpec& spec) {
  return std::string(studio.session().tool().info().id) + "." + std::string(spec.id);
}

OptionValue value_of(const Studio& studio, const OptionSpec& spec) {
  return studio.session().option(id_of(studio, spec)).value();
}

/// Types a number into the row's field, with or without its unit.
void type_number(OptionRow& row, const QString& text) {
  auto* spin = row.findChild<QDoubleSpinBox*>();
  spin->setFocus();
  spin->selectAll();
  QTest::keyClicks(spin, text);
  QTest::keyClick(spin, Qt::Key_Return);
}

/// Sets every value of a row by its controls, and checks that the session receives it.
class EveryRow {
 public:
  EveryRow(Studio& studio, OptionRow& row) : studio_(studio), row_(row), spec_(row.spec()) {}

  void check() {
    SCOPED_TRACE(id_of(studio_, spec_));
    if (spec_.kind == OptionKind::kNumber) check_number();
    if (spec_.kind == OptionKind::kSwitch) check_switch();
    if (spec_.kind == OptionKind::kChoice) check_choices();
    QTest::mouseClick(row_.findChild<QToolButton*>(QStringLiteral("reset")), Qt::LeftButton);
    EXPECT_EQ(value_of(studio_, spec_), default_value(spec_)) << "reset";
    EXPECT_TRUE(row_.findChild<QToolButton*>(QStringLiteral("reset"))->isHidden());
  }

 private:
  void check_number() {
    auto* spin = row_.findChild<QDoubleSpinBox*>();
    auto* slider = row_.findChild<QSlider*>();
    const OptionScale scale(spec_);
    for (const double wanted : {spec_.min, spec_.max, scale.value_at(400)}) {
      type_number(row_, scale.text_of(wanted));
      EXPECT_NEAR(std::get<double>(value_of(studio_, spec_)), wanted, 1e-9) << "typed";
      EXPECT_EQ(scale.value_at(slider->value()), scale.value_at(scale.place_of(wanted)));
    }
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Home);
    EXPECT_EQ(value_of(studio_, spec_), OptionValue(spec_.min));
    QTest::keyClick(slider, Qt::Key_End);
    EXPECT_EQ(value_of(studio_, spec_), OptionValue(spec_.max));
    QTest::keyClick(slider, Qt::Key_PageDown);
    const double lower = std::get<double>(value_of(studio_, spec_));
    EXPECT_LT(lower, spec_.max);
    EXPECT_NEAR(spin->value(), lower * scale.shown_per_unit(),
                0.5 * std::pow(10, -spin->decimals()));
  }

  void check_switch() {
    auto* box = row_.findChild<QCheckBox*>();
    for (int i = 0; i < 2; ++i) {
      const bool was = std::get<bool>(value_of(studio_, spec_));
      QTest::keyClick(box, Qt::Key_Space);
      EXPECT_EQ(value_of(studio_, spec_), OptionValue(!was));
      EXPECT_EQ(box->isChecked(), !was);
    }
    QTest::keyClick(box, Qt::Key_Space);
  }

  void check_choices() {
    auto* list = row_.findChild<QComboBox*>();
    for (std::size_t i = spec_.choices.size(); i-- > 0;) {
      const OptionValue wanted = std::string(spec_.choices[i]);
      if (list) {
        list->setFocus();
        QTest::keyClick(list, Qt::Key_Home);
        for (std::size_t k = 0; k < i; ++k) QTest::keyClick(list, Qt::Key_Down);
        EXPECT_EQ(list->currentIndex(), static_cast<int>(i));
      } else {
        const auto all = row_.findChildren<QToolButton*>();
        const auto button = std::find_if(all.begin(), all.end(), [&](QToolButton* one) {
          return one->isCheckable() && one->text() == choice_text(spec_.choices[i]);
        });
        ASSERT_NE(button, all.end());
        QTest::mouseClick(*button, Qt::LeftButton);
        EXPECT_TRUE((*button)->isChecked());
      }
      EXPECT_EQ(value_of(studio_, spec_), wanted);
    }
    if (spec_.choices.size() > 1) {
      studio_.apply(SetOption{id_of(studio_, spec_), std::string(spec_.choices.back())});
    }
  }

  Studio& studio_;
  OptionRow& row_;
  const OptionSpec& spec_;
};

TEST(OptionsPanel, SetsEveryOptionOfEveryToolByItsControls) {
  Studio studio(still());
  OptionsPanel panel(studio);
  panel.resize(300, 700);
  panel.show();
  for (const auto& tool : studio.session().tools()) {
    const ToolInfo& info = tool->info();
    ASSERT_TRUE(studio.apply(SelectTool{std::string(info.id)}));
    for (const OptionSpec& spec : info.options) {
      OptionRow* row = panel.row(spec.id);
      ASSERT_NE(row, nullptr) << spec.id;
      row->show();  // other tests check whether it has an effect
      EveryRow(studio, *row).check();
    }
  }
}

// Everything that can be chosen is seen where one loops, and no label is cut off.
TEST(OptionsPanel, FourChoicesAreTwoLinesOfButtons) {
  Settings::the().set(QStringLiteral("panels/more_options"), true);
  Studio studio(still());
  OptionsPanel panel(studio);
  panel.resize(panel.minimumSizeHint().width(), 700);
  panel.show();
  int rows = 0;
  for (const auto& tool : studio.session().tools()) {
    const ToolInfo& info = tool->info();
    ASSERT_TRUE(studio.apply(SelectTool{std::string(info.id)}));
    for (const OptionSpec& spec : info.options) {
      if (spec.choices.size() != 4) continue;
      SCOPED_TRACE(id_of(studio, spec));
      OptionRow* row = panel.row(spec.id);
      row->show();
      QApplication::processEvents();
      EXPECT_EQ(row->findChild<QComboBox*>(), nullptr);
      std::map<int, int> in_line;  // buttons by their height in the panel
      for (const QToolButton* button : row->findChildren<QToolButton*>()) {
        if (!button->isCheckable()) continue;
        ++in_line[button->y()];
        EXPECT_GE(button->width(), button->sizeHint().width()) << button->text().toStdString();
      }
      EXPECT_EQ(in_line.size(), 2U);
      for (const auto& [y, count] : in_line) EXPECT_EQ(count, 2) << y;
      ++rows;
    }
  }
  EXPECT_GE(rows, 3) << "what a lasso takes, and what snaps";
  Settings::the().reset(QStringLiteral("panels/more_options"));
}

TEST(OptionsPanel, FollowsWhatOthersSetAndAnotherDrawing) {
  Studio studio(still());
  OptionsPanel panel(studio);
  const auto shown = [&panel] {
    return panel.row("max_width_mm")->findChild<QDoubleSpinBox*>()->value();
  };
  studio.apply(SetOption{"pencil.max_width_mm", 12.5});
  EXPECT_EQ(shown(), 12.5);
  EXPECT_EQ(std::get<double>(studio.session().option("pencil.max_width_mm").value()), 12.5);
  studio.open(Document{}, Page{});
  EXPECT_EQ(shown(), 12.5);
  studio.apply(SelectTool{"eraser"});
  EXPECT_EQ(panel.row("max_width_mm"), nullptr);
  ASSERT_NE(panel.row("include_width"), nullptr);
}

TEST(OptionsPanel, ShowsTheRowsThatMeanSomething) {
  Studio studio(still());
  OptionsPanel panel(studio);
  for (const auto& tool : studio.session().tools()) {
    const ToolInfo& info = tool->info();
    studio.apply(SelectTool{std::string(info.id)});
    for (const OptionSpec& decider : info.options) {
      for (const std::string_view choice : decider.choices) {
        studio.apply(SetOption{id_of(studio, decider), std::string(choice)});
        for (const OptionSpec& spec : info.options) {
          if (decider_of(spec) != decider.id) continue;
          EXPECT_EQ(!panel.row(spec.id)->isHidden(), matters_with(spec, choice))
              << spec.id << " with " << choice;
        }
      }
    }
  }
}

TEST(OptionsPanel, ResetsTheWholeToolAndNoOther) {
  Studio studio(still());
  OptionsPanel panel(studio);
  studio.apply(SetOption{"eraser.radius_mm", 7.0});
  studio.apply(SetOption{"pencil.min_width_mm", 1.0});
  studio.apply(SetOption{"pencil.snap", std::string("off")});
  QTest::mouseClick(panel.findChild<QToolButton*>(QStringLiteral("reset_tool")), Qt::LeftButton);
  for (const OptionSpec& row : studio.session().tool().info().options) {
    const OptionSpec spec = as_at_first(ToolKind::kDraws, row);
    EXPECT_EQ(value_of(studio, spec), default_value(spec)) << spec.id;
  }
  EXPECT_EQ(studio.session().option("eraser.radius_mm").value(), OptionValue(7.0));
}

TEST(OptionsPanel, AWheelThatScrollsChangesNothing) {
  guard_values_from_wheel();
  Studio studio(still());
  OptionsPanel panel(studio);
  panel.show();
  QSignalSpy changes(&studio, &Studio::option_changed);
  for (QWidget* child : panel.findChildren<QWidget*>()) {
    if (!qobject_cast<QAbstractSpinBox*>(child) && !qobject_cast<QSlider*>(child) &&
        !qobject_cast<QComboBox*>(child)) {
      continue;
    }
    child->clearFocus();
    QWheelEvent wheel({2, 2}, child->mapToGlobal(QPointF(2, 2)), {}, {0, 120}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(child, &wheel);
  }
  EXPECT_EQ(changes.count(), 0);
}

TEST(OptionsPanel, SaysTheHelpAndNamesEveryControl) {
  Studio studio(still());
  OptionsPanel panel(studio);
  for (const auto& tool : studio.session().tools()) {
    studio.apply(SelectTool{std::string(tool->info().id)});
    for (const OptionSpec& spec : tool->info().options) {
      EXPECT_EQ(panel.row(spec.id)->toolTip(), translated(spec.help));
      EXPECT_EQ(panel.row(spec.id)->whatsThis(), translated(spec.help));
    }
  }
  EXPECT_EQ(testing::nameless(panel), std::vector<std::string>{});
}

TEST(OptionScale, GoesBothWaysForEveryNumberOfEveryTable) {
  const Studio studio(still());
  for (const auto& tool : studio.session().tools()) {
    for (const OptionSpec& spec : tool->info().options) {
      if (spec.kind != OptionKind::kNumber) continue;
      SCOPED_TRACE(std::string(tool->info().id) + "." + std::string(spec.id));
      const OptionScale scale(spec);
      EXPECT_EQ(scale.place_of(spec.min), 0);
      EXPECT_EQ(scale.place_of(spec.max), OptionScale::kPlaces);
      EXPECT_EQ(scale.value_at(0), spec.min);
      EXPECT_EQ(scale.value_at(OptionScale::kPlaces), spec.max);
      for (int place = 1; place <= OptionScale::kPlaces; ++place) {
        const double value = scale.value_at(place);
        ASSERT_GE(value, scale.value_at(place - 1)) << "the slider never runs backwards";
        ASSERT_GE(value, spec.min);
        ASSERT_LE(value, spec.max);
        // Typing the shown number again must give the same value.
        const double factor = scale.shown_per_unit() * std::pow(10.0, scale.decimals());
        if (place < OptionScale::kPlaces) {
          ASSERT_NEAR(value * factor, std::round(value * factor), 1e-6);
        }
      }
    }
  }
}

TEST(OptionsPanel, IsAsWideForEveryToolAndFoldsWhatIsSeldomNeeded) {
  Studio studio(still());
  OptionsPanel panel(studio);
  panel.resize(320, 700);
  panel.show();
  const int width = panel.minimumSizeHint().width();
  for (const auto& tool : studio.session().tools()) {
    studio.apply(SelectTool{std::string(tool->info().id)});
    EXPECT_EQ(panel.minimumSizeHint().width(), width) << tool->info().id;
  }
  studio.apply(SelectTool{"pencil"});
  EXPECT_FALSE(panel.row("tolerance_mm")->isVisible());
  EXPECT_TRUE(panel.row("snap")->isVisible());
  for (auto* button : panel.findChildren<QToolButton*>(QStringLiteral("more"))) {
    if (button->isVisible()) button->click();
  }
  EXPECT_TRUE(panel.row("tolerance_mm")->isVisible());
  Settings::the().reset(QStringLiteral("panels/more_options"));
}

}  // namespace
}  // namespace felt::desktop::options_panel_test
