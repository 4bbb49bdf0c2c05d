#include "desktop/materials/material_editor_model.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "desktop/engine/settings.h"
#include "desktop/engine/testing/kept_events.h"
#include "desktop/materials/material_setting_keys.h"
#include "desktop/materials/media_picker.h"
#include "desktop/materials/testing/clean_materials.h"
#include "felt/base/atomic_file.h"
#include "felt/material/material_fields.h"
#include "felt/material/material_library.h"
#include "felt/material/relief.h"
#include "felt/session/session_medium.h"

namespace felt::desktop::material_editor_model_test {
namespace {

struct Bench {
  Clean clean;

  [[nodiscard]] SurfaceMaterial surface() const { return std::get<SurfaceMaterial>(fixture.now()); }
  [[nodiscard]] std::string surface_id() const { return studio.session().surface().id; }
  [[nodiscard]] std::size_t reported() const {
    std::size_t count = 0;
    for (const Event& event : events) count += std::holds_alternative<UseMaterial>(event.what);
    return count;
  }

  QTemporaryDir home;
  std::vector<Event> events;
  UserMaterials own{{home.path().toStdString()}};
  Studio studio{{.device = QStringLiteral("simulated:touch"),
                 .live = false,
                 .connect_early = keep_events(events)}};
  MaterialEditorModel fixture{studio, own};
};

TEST(MaterialEditorModel, AChangeOfABuiltInOneIsACopyThatIsFeltAtOnce) {
  Bench bench;
  bench.fixture.select({true, "glass"});
  EXPECT_EQ(bench.surface_id(), "glass");
  bench.fixture.set("feel.friction", 0.3);
  EXPECT_TRUE(bench.fixture.is_own());
  EXPECT_NE(bench.fixture.key().id, "glass");
  EXPECT_EQ(bench.surface_id(), bench.fixture.key().id);
  EXPECT_EQ(bench.studio.session().surface().friction, 0.3);
  EXPECT_EQ(find_surface("glass")->friction, 0.08);
  EXPECT_EQ(bench.studio.session().materials().find_surface("glass")->friction, 0.08);
  EXPECT_TRUE(bench.fixture.is_changed());
}

TEST(MaterialEditorModel, EveryChangeIsUndoneAndRedone) {
  Bench bench;
  std::vector<AnyMaterial> states{bench.fixture.now()};
  for (const SurfaceField& field : surface_fields()) {
    const double now = field.get(bench.surface());
    double other = field.kind == MaterialFieldKind::kColor ? 0x112233
                   : now == field.min                      ? 0.5 * (field.min + field.max)
                                                           : field.min;
    if (field.kind == MaterialFieldKind::kWhole) other = 42.0;
    if (field.kind == MaterialFieldKind::kChoice) other = 2.0;
    if (!field.allows(other) || other == now) continue;
    bench.fixture.set(field.id, other);
    ASSERT_EQ(field.get(bench.surface()), other) << field.id;
    states.push_back(bench.fixture.now());
  }
  ASSERT_GE(states.size(), 9u);
  EXPECT_EQ(bench.fixture.steps().count(), static_cast<int>(states.size()) - 1);
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    bench.fixture.steps().undo();
    EXPECT_EQ(bench.fixture.now(), states[i]) << i;
  }
  EXPECT_EQ(bench.fixture.key(), (MaterialKey{true, "paper"}));
  EXPECT_TRUE(bench.own.all().empty());
  for (std::size_t i = 1; i < states.size(); ++i) {
    bench.fixture.steps().redo();
    EXPECT_EQ(bench.fixture.now(), states[i]) << i;
  }
}

TEST(MaterialEditorModel, SaysNothingWhenItIsDeleted) {
  Bench bench;
  int reports = 0;
  {
    MaterialEditorModel other(bench.studio, bench.own);
    QObject::connect(&other.steps(), &QUndoStack::indexChanged, [&reports] { ++reports; });
    other.set("feel.friction", 0.4);
    ASSERT_EQ(other.steps().count(), 1);
    reports = 0;
  }
  EXPECT_EQ(reports, 0);
}

TEST(MaterialEditorModel, ADragIsOneStepAndFewEvents) {
  Bench bench;
  bench.fixture.set("feel.friction", 0.5);  // changing a built-in one makes a copy
  const std::size_t reported = bench.reported();
  for (int i = 0; i < 300; ++i) bench.fixture.set("feel.stiffness_n_per_m", 400.0 + i, 7);
  bench.fixture.report_now();
  EXPECT_EQ(bench.fixture.steps().count(), 2);
  EXPECT_LE(bench.reported(), reported + 2);
  EXPECT_EQ(bench.studio.session().surface().stiffness_n_per_m, 699.0);
  bench.fixture.steps().undo();
  EXPECT_EQ(bench.surface().stiffness_n_per_m, 500.0);
  EXPECT_EQ(bench.surface().friction, 0.5);
}

TEST(MaterialEditorModel, ValuesThatNoFileMayHaveAreNotTaken) {
  Bench bench;
  bench.fixture.set("feel.stiffness_n_per_m", 1e9);
  bench.fixture.set("feel.stiffness_n_per_m", std::nan(""));
  bench.fixture.set("grain.character", 99.0);
  bench.fixture.set("no.such_field", 1.0);
  EXPECT_FALSE(bench.fixture.is_own());
  EXPECT_EQ(bench.fixture.steps().count(), 0);
}

TEST(MaterialEditorModel, FiguresThatBelongTogetherFollowEachOther) {
  Bench bench;
  bench.fixture.select({true, "glass"});
  bench.fixture.set("grain.height_um", 10.0);
  EXPECT_GT(bench.surface().grain_mm, 0.0);
  EXPECT_EQ(material_error(bench.fixture.now()), "");
  bench.fixture.set("grain.character", 5.0);  // "picture", but no picture is set
  EXPECT_NE(bench.surface().grain_character, HeightCharacter::kPicture);
  bench.fixture.select({false, "pencil"});
  bench.fixture.set("line.max_mm", 0.1);
  EXPECT_EQ(std::get<Medium>(bench.fixture.now()).line.min_mm, 0.1);
  bench.fixture.set("line.min_mm", 7.0);
  EXPECT_EQ(std::get<Medium>(bench.fixture.now()).line.max_mm, 7.0);
  EXPECT_EQ(material_error(bench.fixture.now()), "");
}

TEST(MaterialEditorModel, OneKeyFlipsBetweenAAndB) {
  Bench bench;
  EXPECT_TRUE(bench.fixture.slots_are_alike());
  bench.fixture.set("feel.friction", 0.5);
  EXPECT_EQ(bench.fixture.slot(), 'A');
  bench.fixture.flip();
  EXPECT_EQ(bench.fixture.slot(), 'B');
  EXPECT_EQ(bench.surface().friction, find_surface("paper")->friction);
  EXPECT_EQ(bench.studio.session().surface().friction, find_surface("paper")->friction)
      << "the hand has it at once";
  bench.fixture.set("feel.friction", 0.9);
  bench.fixture.flip();
  EXPECT_EQ(bench.fixture.slot(), 'A');
  EXPECT_EQ(bench.surface().friction, 0.5);
  EXPECT_EQ(bench.studio.session().surface().friction, 0.5);
  bench.fixture.steps().undo();  // undoes a change of slot B, so it switches to B
  EXPECT_EQ(bench.fixture.slot(), 'B');
  EXPECT_EQ(bench.surface().friction, find_surface("paper")->friction);
  bench.fixture.flip();
  EXPECT_EQ(bench.surface().friction, 0.5);
  bench.fixture.copy_to_other();
  EXPECT_TRUE(bench.fixture.slots_are_alike());
}

TEST(MaterialEditorModel, UndoingAStepOfOneMaterialLeavesAAndBOfOthersAlone) {
  Bench bench;
  const double of_paper = find_surface("paper")->friction;
  bench.fixture.set("feel.friction", 0.5);
  const MaterialKey first = bench.fixture.key();
  bench.fixture.select({true, "glass"});
  bench.fixture.set("feel.friction", 0.3);
  bench.fixture.set("feel.friction", 0.4);
  const MaterialKey second = bench.fixture.key();
  bench.fixture.select(first);
  EXPECT_EQ(bench.fixture.slot(), 'A') << "each has its own";
  bench.fixture.flip();
  EXPECT_EQ(bench.surface().friction, of_paper);
  bench.fixture.steps().undo();
  EXPECT_EQ(bench.fixture.key(), second);
  EXPECT_EQ(bench.surface().friction, 0.3);
  EXPECT_EQ(bench.fixture.slot(), 'A');
  bench.fixture.select(first);
  EXPECT_EQ(bench.fixture.slot(), 'B');
  EXPECT_EQ(bench.surface().friction, of_paper);
  bench.fixture.flip();
  EXPECT_EQ(bench.surface().friction, 0.5);
}

TEST(MaterialEditorModel, CopyingToTheOtherSlotIsAStep) {
  Bench bench;
  bench.fixture.set("feel.friction", 0.5);
  bench.fixture.flip();
  bench.fixture.set("feel.friction", 0.9);
  bench.fixture.flip();
  const int steps = bench.fixture.steps().count();
  bench.fixture.copy_to_other();
  EXPECT_TRUE(bench.fixture.slots_are_alike());
  EXPECT_EQ(bench.fixture.steps().count(), steps + 1);
  bench.fixture.copy_to_other();
  EXPECT_EQ(bench.fixture.steps().count(), steps + 1) << "they are alike already";
  bench.fixture.steps().undo();
  EXPECT_EQ(bench.fixture.slot(), 'A');
  EXPECT_EQ(bench.surface().friction, 0.5);
  bench.fixture.flip();
  EXPECT_EQ(bench.surface().friction, 0.9) << "what was tuned in B is there again";
  bench.fixture.steps().redo();
  EXPECT_EQ(bench.surface().friction, 0.5);
  EXPECT_TRUE(bench.fixture.slots_are_alike());
}

/// Returns another user's version of the chalk, as it comes with a drawing.
AnyMaterial chalk_of_another_person() {
  Bench theirs;
  theirs.fixture.select({false, "chalk"});
  theirs.fixture.set("feel.wear", 0.5);
  return theirs.fixture.now();
}

TEST(MaterialEditorModel, NoCopyTakesTheIdOfWhatTheDrawingBrought) {
  const AnyMaterial theirs = chalk_of_another_person();
  Bench bench;
  const auto still_theirs = [&] {
    bench.fixture.report_now();
    const std::optional<AnyMaterial> known = find_in(bench.studio.materials(), key_of(theirs));
    const Medium* in_session = bench.studio.session().materials().find_medium(id_of(theirs));
    return known == theirs && in_session && AnyMaterial(*in_session) == theirs;
  };
  const std::vector<std::string> texts{write_material(theirs)};
  bench.studio.open(Document{}, Page{}, texts);
  bench.fixture.select({false, "chalk"});
  bench.fixture.set("feel.wear", 0.9);
  EXPECT_EQ(name_of(bench.fixture.now()), name_of(theirs));
  EXPECT_NE(bench.fixture.key(), key_of(theirs));
  EXPECT_TRUE(still_theirs());
  ASSERT_TRUE(bench.fixture.save());
  EXPECT_TRUE(still_theirs());
  bench.fixture.select({false, "chalk"});
  ASSERT_TRUE(bench.fixture.save_as(name_of(theirs)));
  EXPECT_NE(bench.fixture.key(), key_of(theirs));
  EXPECT_TRUE(still_theirs());
  const QString file = bench.home.filePath(QStringLiteral("theirs.txt"));
  AnyMaterial other = theirs;
  std::get<Medium>(other).wear = 0.1;
  ASSERT_TRUE(save_file(file.toStdString(), write_material(other)));
  ASSERT_TRUE(bench.fixture.import_file(file));
  EXPECT_NE(bench.fixture.key(), key_of(theirs));
  EXPECT_TRUE(still_theirs());
}

TEST(MaterialEditorModel, AnIdThatStrokesMayNameIsNotGivenAgain) {
  Bench bench;
  ASSERT_TRUE(bench.fixture.save_as(QStringLiteral("Mine")));
  const MaterialKey key = bench.fixture.key();
  ASSERT_TRUE(bench.fixture.remove());
  ASSERT_TRUE(bench.fixture.save_as(QStringLiteral("Mine")));
  EXPECT_NE(bench.fixture.key(), key);
}

/// A drawing whose surface has the id of a user-defined one but other figures.
struct OtherSurfaceOfThatId : Bench {
  OtherSurfaceOfThatId() {
    fixture.set("feel.friction", 0.5);
    EXPECT_TRUE(fixture.save());
    key = fixture.key();
    mine = surface();
    theirs = mine;
    theirs.friction = 0.9;
    Page page;
    page.surface = key.id;
    const std::vector<std::string> texts{write_material(theirs)};
    studio.open(Document{}, page, texts);
    fixture.select(key);
  }
  [[nodiscard]] std::optional<AnyMaterial> of_drawing() const {
    return find_in(studio.materials(), key);
  }

  MaterialKey key;
  SurfaceMaterial mine, theirs;
};

TEST(MaterialEditorModel, WhatTheDrawingBroughtGoesBeforeOnesOwnOfThatId) {
  OtherSurfaceOfThatId bench;
  EXPECT_FALSE(bench.fixture.is_own());
  EXPECT_FALSE(bench.fixture.is_changed());
  EXPECT_EQ(bench.fixture.now(), AnyMaterial(bench.theirs));
  EXPECT_EQ(bench.studio.session().surface(), bench.theirs);
  bench.fixture.set("feel.friction", 0.7);
  EXPECT_NE(bench.fixture.key(), bench.key) << "a copy";
  EXPECT_TRUE(bench.fixture.is_own());
  EXPECT_EQ(bench.surface().friction, 0.7);
  bench.fixture.report_now();
  EXPECT_EQ(bench.of_drawing(), AnyMaterial(bench.theirs));
  EXPECT_EQ(bench.own.find(bench.key)->now, AnyMaterial(bench.mine));
  bench.fixture.steps().undo();
  EXPECT_EQ(bench.fixture.key(), bench.key);
  EXPECT_EQ(bench.fixture.now(), AnyMaterial(bench.theirs));
  bench.studio.open(Document{}, Page{});
  EXPECT_TRUE(bench.fixture.is_own()) << "that drawing is gone";
  EXPECT_EQ(bench.fixture.now(), AnyMaterial(bench.mine));
}

TEST(MaterialEditorModel, AChangeInAnotherWindowLeavesTheDrawingsOwnAlone) {
  OtherSurfaceOfThatId bench;
  Studio studio({.device = QStringLiteral("simulated:touch"), .live = false});
  MaterialEditorModel elsewhere(studio, bench.own);
  elsewhere.select(bench.key);
  EXPECT_TRUE(elsewhere.is_own());
  elsewhere.set("feel.friction", 0.6);
  elsewhere.report_now();
  EXPECT_EQ(studio.session().surface().friction, 0.6);
  bench.fixture.report_now();
  EXPECT_EQ(bench.of_drawing(), AnyMaterial(bench.theirs));
  EXPECT_FALSE(bench.fixture.is_own());
  bench.studio.open(Document{}, Page{});
  EXPECT_TRUE(bench.fixture.is_own());
  EXPECT_EQ(std::get<SurfaceMaterial>(bench.of_drawing().value()).friction, 0.6)
      << "what was withheld";
}

TEST(MaterialEditorModel, AnotherDrawingTakesWhatTheLastOneBroughtFromTheDesk) {
  const AnyMaterial theirs = chalk_of_another_person();
  Bench bench;
  const std::vector<std::string> texts{write_material(theirs)};
  bench.studio.open(Document{}, Page{}, texts);
  bench.fixture.select(key_of(theirs));
  EXPECT_EQ(bench.fixture.now(), theirs);
  EXPECT_FALSE(bench.fixture.is_own());
  bench.studio.open(Document{}, Page{});
  EXPECT_EQ(bench.fixture.key(), (MaterialKey{true, bench.surface_id()}));
}

TEST(MaterialEditorModel, SavingRenamingAndDeletingCanBeUndone) {
  Bench bench;
  bench.fixture.set("feel.friction", 0.5);
  ASSERT_TRUE(bench.fixture.save_as(QStringLiteral("My rough one")));
  const MaterialKey key{true, "my-rough-one"};
  EXPECT_EQ(bench.fixture.key(), key);
  EXPECT_FALSE(bench.fixture.is_changed());
  const QString file = bench.home.filePath(QStringLiteral("my-rough-one.toml"));
  EXPECT_TRUE(QFile::exists(file));
  bench.fixture.rename(QStringLiteral("Sandpaper"));
  EXPECT_EQ(name_of(bench.fixture.now()), QStringLiteral("Sandpaper"));
  EXPECT_EQ(bench.fixture.key(), key) << "drawings go on naming it so";
  EXPECT_FALSE(bench.fixture.is_changed());
  ASSERT_TRUE(bench.fixture.remove());
  EXPECT_FALSE(QFile::exists(file));
  EXPECT_EQ(bench.surface_id(), "paper");
  bench.fixture.steps().undo();
  EXPECT_TRUE(QFile::exists(file));
  EXPECT_EQ(bench.fixture.key(), key);
  EXPECT_EQ(name_of(bench.fixture.now()), QStringLiteral("Sandpaper"));
  EXPECT_EQ(bench.surface_id(), "my-rough-one");
  // Undoing the creation of the copy deletes no file.
  while (bench.fixture.steps().canUndo()) bench.fixture.steps().undo();
  EXPECT_TRUE(QFile::exists(file));
}

TEST(MaterialEditorModel, UndoingADeletionBringsBackTheFileAsItWasAndWhatWasNotSaved) {
  Bench bench;
  ASSERT_TRUE(bench.fixture.save_as(QStringLiteral("Mine")));
  const MaterialKey key = bench.fixture.key();
  const AnyMaterial saved = bench.fixture.now();
  const std::string file = bench.home.filePath(QStringLiteral("mine.toml")).toStdString();
  bench.fixture.set("feel.friction", 0.9);
  const AnyMaterial changed = bench.fixture.now();
  ASSERT_TRUE(bench.fixture.remove());
  EXPECT_FALSE(bench.own.find(key));
  for (int i = 0; i < 2; ++i) {
    bench.fixture.steps().undo();
    EXPECT_EQ(bench.fixture.key(), key);
    EXPECT_EQ(bench.fixture.now(), changed);
    EXPECT_TRUE(bench.fixture.is_changed());
    const Result<AnyMaterial> there = read_material_file(file);
    ASSERT_TRUE(there) << there.error().message;
    EXPECT_EQ(*there, saved);
    bench.fixture.steps().redo();
    EXPECT_FALSE(bench.own.find(key));
    EXPECT_FALSE(read_material_file(file));
  }
}

TEST(MaterialEditorModel, ADeletionThatFailsIsNoStep) {
  Bench bench;
  ASSERT_TRUE(bench.fixture.save_as(QStringLiteral("Mine")));
  const MaterialKey key = bench.fixture.key();
  const int steps = bench.fixture.steps().count();
  const std::string file = bench.home.filePath(QStringLiteral("mine.toml")).toStdString();
  // Another program writes the file.
  ASSERT_TRUE(save_file(file, "kind = \"surface\"\nid = \"mine\"\n"));
  const Result<void> removed = bench.fixture.remove();
  ASSERT_FALSE(removed);
  EXPECT_NE(removed.error().message.find(file), std::string::npos);
  EXPECT_EQ(bench.fixture.steps().count(), steps);
  EXPECT_EQ(bench.fixture.key(), key);
  EXPECT_TRUE(bench.own.find(key));
}

TEST(MaterialEditorModel, TheSameNameIsNoStep) {
  Bench bench;
  ASSERT_TRUE(bench.fixture.save_as(QStringLiteral("Mine")));
  const int steps = bench.fixture.steps().count();
  for (const char* name : {"Mine", "  Mine ", "Mine\x07", "\x07", ""}) {
    bench.fixture.rename(QString::fromLatin1(name));
    EXPECT_EQ(bench.fixture.steps().count(), steps) << name;
  }
  bench.fixture.rename(QStringLiteral("Yours"));
  EXPECT_EQ(bench.fixture.steps().count(), steps + 1);
}

TEST(MaterialEditorModel, RevertBringsBackWhatTheFileHas) {
  Bench bench;
  ASSERT_TRUE(bench.fixture.save_as(QStringLiteral("Mine")));
  const AnyMaterial saved = bench.fixture.now();
  bench.fixture.set("feel.friction", 0.9);
  bench.fixture.set("grain.height_um", 20.0);
  EXPECT_TRUE(bench.fixture.is_changed());
  bench.fixture.revert();
  EXPECT_EQ(bench.fixture.now(), saved);
  EXPECT_FALSE(bench.fixture.is_changed());
  bench.fixture.steps().undo();
  EXPECT_EQ(bench.surface().grain_um, 20.0);
}

TEST(MaterialEditorModel, FilesComeInAndGoOut) {
  Bench bench;
  bench.fixture.select({false, "chalk"});
  bench.fixture.set_pair("glass", 0.11);
  bench.fixture.set("feel.wear", 0.5);
  const QString path = bench.home.filePath(QStringLiteral("out.txt"));
  const AnyMaterial made = bench.fixture.now();
  ASSERT_TRUE(bench.fixture.export_file(path));
  ASSERT_TRUE(bench.fixture.import_file(path));
  EXPECT_NE(bench.fixture.key(), key_of(made)) << "there was one of that id";
  EXPECT_EQ(std::get<Medium>(bench.fixture.now()).pairs, std::get<Medium>(made).pairs);
  EXPECT_EQ(std::get<Medium>(bench.fixture.now()).wear, 0.5);
  const Result<void> none = bench.fixture.import_file(bench.home.filePath(QStringLiteral("none")));
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("none"), std::string::npos);
}

TEST(MaterialEditorModel, TheLineOfAMediumReachesThePencil) {
  Bench bench;
  bench.fixture.select({false, "crayon"});
  EXPECT_EQ(drawing_medium(bench.studio.session()), "crayon");
  bench.fixture.set("line.max_mm", 9.5);
  bench.fixture.report_now();
  const auto width = [&] {
    return std::get<double>(bench.studio.session().option("pencil.max_width_mm").value());
  };
  EXPECT_EQ(width(), 9.5);
  bench.fixture.set("line.max_mm", 4.0);
  bench.fixture.report_now();
  EXPECT_EQ(width(), 4.0);
}

TEST(MaterialEditorModel, TheColourOfWhatIsWorkedOnIsThatOfPageAndInk) {
  Bench bench;
  const auto paper = [&] { return bench.studio.page().paper; };
  bench.fixture.select({true, "blackboard"});
  EXPECT_EQ(paper(), (Rgba{0x34, 0x46, 0x3e, 255}));
  bench.fixture.set("color", 0x203040);
  bench.fixture.report_now();
  EXPECT_EQ(paper(), (Rgba{0x20, 0x30, 0x40, 255}));
  bench.fixture.steps().undo();
  EXPECT_EQ(paper(), (Rgba{0x34, 0x46, 0x3e, 255}));
  bench.fixture.select({false, "chalk"});
  const auto ink = [&] { return bench.studio.session().ink_color(); };
  const Rgba before = ink();
  EXPECT_NE(before, (Rgba{0xf4, 0xf1, 0xe6, 255})) << "a medium does not change the colour";
  bench.fixture.set("color", 0xffff10);
  bench.fixture.report_now();
  EXPECT_EQ(ink(), before) << "it is not the colour of the medium";
  bench.studio.apply(SetOption{"ink.color", std::string("#ffff10")});
  bench.fixture.set("color", 0xffff00);
  bench.fixture.report_now();
  EXPECT_EQ(ink(), (Rgba{0xff, 0xff, 0x00, 255}));
}

TEST(MaterialEditorModel, AReliefOfAPictureIsFeltAndSaved) {
  Bench bench;
  HeightPicture picture{.width = 64, .height = 64, .heights = {}, .width_mm = 0.0};
  for (int i = 0; i < 64 * 64; ++i) {
    picture.heights.push_back(static_cast<float>((i / 64 / 8 + i % 64 / 8) % 2));
  }
  ASSERT_TRUE(bench.fixture.take_relief(picture));
  EXPECT_EQ(bench.surface().grain_character, HeightCharacter::kPicture);
  ASSERT_NE(surface_grain(bench.surface()), nullptr);
  ASSERT_TRUE(bench.fixture.save());
  UserMaterials next({bench.home.path().toStdString()});
  ASSERT_TRUE(next.find(bench.fixture.key()));
  EXPECT_EQ(next.find(bench.fixture.key())->now, bench.fixture.now());
  picture.heights.assign(picture.heights.size(), 0.5F);
  EXPECT_FALSE(bench.fixture.take_relief(picture)) << "a picture of one grey is no relief";
}

TEST(MaterialEditorModel, WhatWasToldReplaysAlike) {
  Bench bench;
  bench.fixture.set("feel.friction", 0.5);
  bench.fixture.set("grain.height_um", 30.0);
  bench.fixture.report_now();
  Session other(make_tools(), {});
  for (const Event& event : bench.events) ASSERT_TRUE(other.apply(event));
  EXPECT_EQ(other.surface(), bench.studio.session().surface());
}

}  // namespace
}  // namespace felt::desktop::material_editor_model_test
