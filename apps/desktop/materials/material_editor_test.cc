#include "desktop/materials/material_editor.h"

#include <gtest/gtest.h>

#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "desktop/engine/settings.h"
#include "desktop/materials/material_setting_keys.h"
#include "desktop/materials/testing/clean_materials.h"
#include "desktop/testing/accessible_names.h"

namespace felt::desktop::material_editor_test {
namespace {

struct Shown {
  explicit Shown(const QString& device = QStringLiteral("simulated:touch"))
      : studio({.device = device, .live = false}) {
    editor.show();
    editor.activateWindow();
    static_cast<void>(QTest::qWaitForWindowActive(&editor));
  }
  [[nodiscard]] SurfaceMaterial surface() const { return std::get<SurfaceMaterial>(fixture.now()); }
  QDoubleSpinBox* spin(const char* field) {
    return editor.fields().row(field)->findChild<QDoubleSpinBox*>();
  }
  QSlider* slider(const char* field) { return editor.fields().row(field)->findChild<QSlider*>(); }

  Clean clean;
  QTemporaryDir home;
  UserMaterials own{{home.path().toStdString()}};
  Studio studio;
  MaterialEditorModel fixture{studio, own};
  MaterialEditor editor{studio, fixture, nullptr};
};

TEST(MaterialEditor, EveryFieldOfTheTablesHasARowThatShowsItsValue) {
  Shown shown;
  for (const SurfaceField& field : surface_fields()) {
    FigureRow* row = shown.editor.fields().row(field.id);
    ASSERT_NE(row, nullptr) << field.id;
    if (auto* spin = row->findChild<QDoubleSpinBox*>()) {
      const double factor = spin->suffix() == QStringLiteral(" %") ? 100.0 : 1.0;
      EXPECT_NEAR(spin->value(), factor * field.get(shown.surface()), 0.051 * factor) << field.id;
    }
  }
  shown.fixture.select({false, "pencil"});
  for (const MediumField& field : medium_fields()) {
    ASSERT_NE(shown.editor.fields().row(field.id), nullptr) << field.id;
  }
}

TEST(MaterialEditor, EverySliderSetsWhatAFileMayHave) {
  Shown shown;
  const auto try_all = [&](const auto& fields, const auto& value_of) {
    for (const auto& field : fields) {
      auto* slider = shown.editor.fields().row(field.id)->template findChild<QSlider*>();
      ASSERT_EQ(slider != nullptr, field.kind == MaterialFieldKind::kNumber) << field.id;
      if (!slider) continue;
      for (const int place : {0, 150, 430, 1000}) {
        slider->setValue(place == slider->value() ? place + 1 : place);
        ASSERT_TRUE(field.allows(value_of(field))) << field.id << " at " << place;
      }
      EXPECT_EQ(value_of(field), field.max) << field.id;
    }
    EXPECT_EQ(material_error(shown.fixture.now()), "");
  };
  try_all(surface_fields(), [&](const SurfaceField& field) { return field.get(shown.surface()); });
  shown.fixture.select({false, "pencil"});
  try_all(medium_fields(), [&](const MediumField& field) {
    return field.get(std::get<Medium>(shown.fixture.now()));
  });
}

TEST(MaterialEditor, AShapeIsUsedAndABadOneIsNot) {
  Shown shown;
  shown.fixture.select({false, "rope"});
  const auto shape = [&] { return std::get<Medium>(shown.fixture.now()).style.shape; };
  auto* line = shown.editor.findChild<QLineEdit*>(QStringLiteral("style_shape"));
  ASSERT_NE(line, nullptr);
  EXPECT_EQ(line->text().toStdString(), shape());
  const auto type = [&](const char* text) {
    line->setText(QString::fromLatin1(text));
    Q_EMIT line->editingFinished();
  };
  type("M0 0H1V.5Z");
  EXPECT_EQ(shape(), "M0 0H1V.5Z");
  EXPECT_TRUE(shown.fixture.is_own());
  type("M0 0H2V.5Z");
  EXPECT_EQ(shape(), "M0 0H1V.5Z");
  EXPECT_EQ(material_error(shown.fixture.now()), "");
  shown.fixture.steps().undo();
  EXPECT_EQ(line->text().toStdString(), find_medium("rope")->style.shape);
}

TEST(MaterialEditor, ANumberThatIsTypedIsFelt) {
  Shown shown;
  shown.spin("feel.stiffness_n_per_m")->setValue(800.0);
  shown.fixture.report_now();
  EXPECT_EQ(shown.studio.session().surface().stiffness_n_per_m, 800.0);
  EXPECT_TRUE(shown.fixture.is_own());
}

TEST(MaterialEditor, ADragOfASliderIsOneStepThatKeysUndo) {
  Shown shown;
  shown.fixture.set("feel.friction", 0.4);
  QSlider* slider = shown.slider("feel.stiffness_n_per_m");
  slider->setSliderDown(true);
  for (int place = 500; place < 900; place += 7) slider->setValue(place);
  slider->setSliderDown(false);
  EXPECT_NE(shown.surface().stiffness_n_per_m, 500.0);
  EXPECT_EQ(shown.fixture.steps().count(), 2);
  // The keys also work with the focus in a number field.
  QLineEdit* edit = shown.spin("feel.friction")->findChild<QLineEdit*>();
  edit->setFocus();
  QTest::keyClick(edit, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(shown.surface().stiffness_n_per_m, 500.0);
  EXPECT_EQ(shown.surface().friction, 0.4);
  QTest::keyClick(edit, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_NE(shown.surface().stiffness_n_per_m, 500.0);
}

TEST(MaterialEditor, TheKeyBFlipsAndTheLabelSaysWhich) {
  Shown shown;
  shown.fixture.set("feel.friction", 0.4);
  shown.editor.list().setFocus();
  QAction* flip = shown.editor.action("flip");
  EXPECT_TRUE(flip->text().contains(u'A'));
  QTest::keyClick(&shown.editor.list(), Qt::Key_B);
  EXPECT_EQ(shown.fixture.slot(), 'B');
  EXPECT_TRUE(flip->text().contains(u'B'));
  EXPECT_EQ(shown.studio.session().surface().friction, find_surface("paper")->friction);
}

TEST(MaterialEditor, TheListTakesWhatIsChosenInHand) {
  Shown shown;
  const std::vector<MaterialKey> keys = shown.editor.list().keys();
  EXPECT_EQ(keys.size(), surface_materials().size() + Materials::built_in().media().size() - 1)
      << "no eraser";
  Q_EMIT shown.editor.list().chosen({true, "canvas"});
  EXPECT_EQ(shown.studio.session().surface().id, "canvas");
  EXPECT_EQ(shown.fixture.key().id, "canvas");
}

TEST(MaterialEditor, R56_TheSignTurnsRedForASurfaceThatTheDeviceCannotMake) {
  Shown shown;
  QSignalSpy figured(&shown.editor.probe(), &ForceProbe::figured);
  shown.fixture.set("feel.stiffness_n_per_m", 2000.0);
  while (shown.editor.probe().is_busy()) ASSERT_TRUE(figured.wait(8000));
  EXPECT_EQ(shown.editor.stability().level(), StabilityLevel::kNotGiven);
  // A Touch renders harder surfaces softer, so that they remain distinguishable (R13):
  // plane_for().
  shown.fixture.set("feel.stiffness_n_per_m", 150.0);
  while (shown.editor.probe().is_busy()) ASSERT_TRUE(figured.wait(8000));
  EXPECT_EQ(shown.editor.stability().level(), StabilityLevel::kGiven);
}

TEST(MaterialEditor, ThePictureFollows) {
  Shown shown;
  QSignalSpy drawn(&shown.editor.preview(), &StrokePreview::drawn);
  shown.fixture.select({false, "charcoal"});
  ASSERT_TRUE(drawn.wait(8000));
  const QImage before = shown.editor.preview().picture();
  shown.fixture.set("line.max_mm", 2.0);
  ASSERT_TRUE(drawn.wait(8000));
  EXPECT_NE(shown.editor.preview().picture(), before);
}

TEST(MaterialEditor, TheSeedIsForReliefsThatAreGrownNotForAPicture) {
  Shown shown;
  shown.fixture.select({true, "rough-paper"});
  const auto controls = shown.editor.fields().row("grain.seed")->findChildren<QToolButton*>();
  ASSERT_EQ(controls.size(), 1) << "the key that throws another";
  const auto can_be_set = [&] {
    return shown.spin("grain.seed")->isEnabled() && controls.first()->isEnabled();
  };
  EXPECT_TRUE(can_be_set());
  HeightPicture steps{.width = 64, .height = 64, .heights = {}, .width_mm = 0.0};
  for (int i = 0; i < 64 * 64; ++i) steps.heights.push_back(static_cast<float>(i / 64 / 8 % 2));
  ASSERT_TRUE(shown.fixture.take_relief(steps));
  EXPECT_FALSE(shown.spin("grain.seed")->isEnabled());
  EXPECT_FALSE(controls.first()->isEnabled());
  shown.fixture.set("grain.character", 0.0);
  EXPECT_TRUE(can_be_set());
  shown.fixture.steps().undo();
  EXPECT_FALSE(can_be_set());
}

TEST(MaterialEditor, SaysWhatCouldNotBeWritten) {
  Shown shown;
  shown.fixture.set("feel.friction", 0.4);
  QFile::remove(shown.home.path());
  shown.home.remove();
  QFile in_the_way(shown.home.path());
  ASSERT_TRUE(in_the_way.open(QIODevice::WriteOnly));
  shown.editor.action("save")->trigger();
  EXPECT_TRUE(shown.editor.notice().contains(shown.home.path()))
      << shown.editor.notice().toStdString();
  EXPECT_TRUE(shown.fixture.is_changed());
  in_the_way.remove();
}

TEST(MaterialEditor, ADeletionThatFailsSaysOnlyThat) {
  Shown shown;
  ASSERT_TRUE(shown.fixture.save_as(QStringLiteral("Mine")));
  QFile file(shown.home.filePath(QStringLiteral("mine.toml")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
  file.write("kind = \"surface\"\nid = \"mine\"\n");  // written by another program
  file.close();
  QAction* remove = shown.editor.action("delete");
  ASSERT_TRUE(remove->isEnabled());
  remove->trigger();
  EXPECT_TRUE(shown.editor.notice().contains(file.fileName()))
      << shown.editor.notice().toStdString();
  EXPECT_FALSE(shown.editor.notice().contains(QStringLiteral("Undo")));
  EXPECT_TRUE(shown.fixture.is_own());
  ASSERT_TRUE(file.remove());
  remove->trigger();
  EXPECT_TRUE(shown.editor.notice().contains(QStringLiteral("Undo")))
      << shown.editor.notice().toStdString();
}

TEST(MaterialEditor, WhatIsForAllUsersCannotBeDeletedAndSaysWhy) {
  const Clean clean;
  const QTemporaryDir home, all_users;
  SurfaceMaterial slate = *find_surface("blackboard");
  slate.id = "slate";
  slate.label = "Slate";
  QFile file(all_users.filePath(QStringLiteral("slate.toml")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QByteArray::fromStdString(write_material(slate)));
  file.close();
  UserMaterials own({home.path().toStdString(), all_users.path().toStdString()});
  Studio studio({.device = QStringLiteral("simulated:touch"), .live = false});
  MaterialEditorModel fixture(studio, own);
  MaterialEditor editor(studio, fixture, nullptr);
  QAction* remove = editor.action("delete");
  fixture.select({true, "slate"});
  EXPECT_TRUE(fixture.is_own());
  EXPECT_FALSE(remove->isEnabled());
  EXPECT_TRUE(remove->toolTip().contains(file.fileName())) << remove->toolTip().toStdString();
  fixture.set("feel.friction", 0.4);
  ASSERT_TRUE(fixture.save());
  EXPECT_TRUE(remove->isEnabled()) << "the person's now";
  EXPECT_FALSE(remove->toolTip().contains(file.fileName()));
  fixture.select({true, "paper"});
  EXPECT_FALSE(remove->isEnabled());
}

TEST(MaterialEditor, EveryControlHasAName) {
  Shown shown;
  EXPECT_EQ(nameless_controls(shown.editor).join(QStringLiteral(", ")).toStdString(), "");
  for (const QAction* action : shown.editor.findChildren<QAction*>()) {
    if (action->objectName().isEmpty() || action->isSeparator()) continue;
    EXPECT_FALSE(action->text().isEmpty()) << action->objectName().toStdString();
  }
}

}  // namespace
}  // namespace felt::desktop::material_editor_test
