#include "desktop/materials/material_desk.h"

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

namespace felt::desktop::material_desk_test {
namespace {

struct Bench {
  Clean clean;

  [[nodiscard]] SurfaceMaterial surface() const { return std::get<SurfaceMaterial>(desk.now()); }
  [[nodiscard]] std::string felt_on() const { return studio.session().surface().id; }
  [[nodiscard]] std::size_t told() const {
    std::size_t count = 0;
    for (const Event& event : events) count += std::holds_alternative<UseMaterial>(event.what);
    return count;
  }

  QTemporaryDir home;
  std::vector<Event> events;
  OwnMaterials own{{home.path().toStdString()}};
  Studio studio{{.device = QStringLiteral("simulated:touch"),
                 .live = false,
                 .connect_early = keep_events(events)}};
  MaterialDesk desk{studio, own};
};

TEST(MaterialDesk, AChangeOfABuiltInOneIsACopyThatIsFeltAtOnce) {
  Bench bench;
  bench.desk.select({true, "glass"});
  EXPECT_EQ(bench.felt_on(), "glass");
  bench.desk.set("feel.friction", 0.3);
  EXPECT_TRUE(bench.desk.is_own());
  EXPECT_NE(bench.desk.key().id, "glass");
  EXPECT_EQ(bench.felt_on(), bench.desk.key().id);
  EXPECT_EQ(bench.studio.session().surface().friction, 0.3);
  EXPECT_EQ(find_surface("glass")->friction, 0.08);
  EXPECT_EQ(bench.studio.session().materials().find_surface("glass")->friction, 0.08);
  EXPECT_TRUE(bench.desk.is_changed());
}

TEST(MaterialDesk, EveryChangeIsUndoneAndRedone) {
  Bench bench;
  std::vector<AnyMaterial> states{bench.desk.now()};
  for (const SurfaceField& field : surface_fields()) {
    const double now = field.get(bench.surface());
    double other = field.kind == MaterialFieldKind::kColor ? 0x112233
                   : now == field.min                      ? 0.5 * (field.min + field.max)
                                                           : field.min;
    if (field.kind == MaterialFieldKind::kWhole) other = 42.0;
    if (field.kind == MaterialFieldKind::kChoice) other = 2.0;
    if (!field.allows(other) || other == now) continue;
    bench.desk.set(field.id, other);
    ASSERT_EQ(field.get(bench.surface()), other) << field.id;
    states.push_back(bench.desk.now());
  }
  ASSERT_GE(states.size(), 9u);
  EXPECT_EQ(bench.desk.steps().count(), static_cast<int>(states.size()) - 1);
  for (std::size_t i = states.size() - 1; i-- > 0;) {
    bench.desk.steps().undo();
    EXPECT_EQ(bench.desk.now(), states[i]) << i;
  }
  EXPECT_EQ(bench.desk.key(), (MaterialKey{true, "paper"}));
  EXPECT_TRUE(bench.own.all().empty());
  for (std::size_t i = 1; i < states.size(); ++i) {
    bench.desk.steps().redo();
    EXPECT_EQ(bench.desk.now(), states[i]) << i;
  }
}

TEST(MaterialDesk, ADragIsOneStepAndFewEvents) {
  Bench bench;
  bench.desk.set("feel.friction", 0.5);  // changing a built-in one makes a copy
  const std::size_t told = bench.told();
  for (int i = 0; i < 300; ++i) bench.desk.set("feel.stiffness_n_per_m", 400.0 + i, 7);
  bench.desk.tell_now();
  EXPECT_EQ(bench.desk.steps().count(), 2);
  EXPECT_LE(bench.told(), told + 2);
  EXPECT_EQ(bench.studio.session().surface().stiffness_n_per_m, 699.0);
  bench.desk.steps().undo();
  EXPECT_EQ(bench.surface().stiffness_n_per_m, 500.0);
  EXPECT_EQ(bench.surface().friction, 0.5);
}

TEST(MaterialDesk, ValuesThatNoFileMayHaveAreNotTaken) {
  Bench bench;
  bench.desk.set("feel.stiffness_n_per_m", 1e9);
  bench.desk.set("feel.stiffness_n_per_m", std::nan(""));
  bench.desk.set("grain.character", 99.0);
  bench.desk.set("no.such_field", 1.0);
  EXPECT_FALSE(bench.desk.is_own());
  EXPECT_EQ(bench.desk.steps().count(), 0);
}

TEST(MaterialDesk, FiguresThatBelongTogetherFollowEachOther) {
  Bench bench;
  bench.desk.select({true, "glass"});
  bench.desk.set("grain.height_um", 10.0);
  EXPECT_GT(bench.surface().grain_mm, 0.0);
  EXPECT_EQ(material_error(bench.desk.now()), "");
  bench.desk.set("grain.character", 5.0);  // "picture", but no picture is set
  EXPECT_NE(bench.surface().grain_character, HeightCharacter::kPicture);
  bench.desk.select({false, "pencil"});
  bench.desk.set("line.max_mm", 0.1);
  EXPECT_EQ(std::get<Medium>(bench.desk.now()).line.min_mm, 0.1);
  bench.desk.set("line.min_mm", 7.0);
  EXPECT_EQ(std::get<Medium>(bench.desk.now()).line.max_mm, 7.0);
  EXPECT_EQ(material_error(bench.desk.now()), "");
}

TEST(MaterialDesk, OneKeyFlipsBetweenAAndB) {
  Bench bench;
  EXPECT_TRUE(bench.desk.slots_are_alike());
  bench.desk.set("feel.friction", 0.5);
  EXPECT_EQ(bench.desk.slot(), 'A');
  bench.desk.flip();
  EXPECT_EQ(bench.desk.slot(), 'B');
  EXPECT_EQ(bench.surface().friction, find_surface("paper")->friction);
  EXPECT_EQ(bench.studio.session().surface().friction, find_surface("paper")->friction)
      << "the hand has it at once";
  bench.desk.set("feel.friction", 0.9);
  bench.desk.flip();
  EXPECT_EQ(bench.desk.slot(), 'A');
  EXPECT_EQ(bench.surface().friction, 0.5);
  EXPECT_EQ(bench.studio.session().surface().friction, 0.5);
  bench.desk.steps().undo();  // undoes a change of slot B, so it switches to B
  EXPECT_EQ(bench.desk.slot(), 'B');
  EXPECT_EQ(bench.surface().friction, find_surface("paper")->friction);
  bench.desk.flip();
  EXPECT_EQ(bench.surface().friction, 0.5);
  bench.desk.copy_to_other();
  EXPECT_TRUE(bench.desk.slots_are_alike());
}

TEST(MaterialDesk, UndoingAStepOfOneMaterialLeavesAAndBOfOthersAlone) {
  Bench bench;
  const double of_paper = find_surface("paper")->friction;
  bench.desk.set("feel.friction", 0.5);
  const MaterialKey first = bench.desk.key();
  bench.desk.select({true, "glass"});
  bench.desk.set("feel.friction", 0.3);
  bench.desk.set("feel.friction", 0.4);
  const MaterialKey second = bench.desk.key();
  bench.desk.select(first);
  EXPECT_EQ(bench.desk.slot(), 'A') << "each has its own";
  bench.desk.flip();
  EXPECT_EQ(bench.surface().friction, of_paper);
  bench.desk.steps().undo();
  EXPECT_EQ(bench.desk.key(), second);
  EXPECT_EQ(bench.surface().friction, 0.3);
  EXPECT_EQ(bench.desk.slot(), 'A');
  bench.desk.select(first);
  EXPECT_EQ(bench.desk.slot(), 'B');
  EXPECT_EQ(bench.surface().friction, of_paper);
  bench.desk.flip();
  EXPECT_EQ(bench.surface().friction, 0.5);
}

TEST(MaterialDesk, CopyingToTheOtherSlotIsAStep) {
  Bench bench;
  bench.desk.set("feel.friction", 0.5);
  bench.desk.flip();
  bench.desk.set("feel.friction", 0.9);
  bench.desk.flip();
  const int steps = bench.desk.steps().count();
  bench.desk.copy_to_other();
  EXPECT_TRUE(bench.desk.slots_are_alike());
  EXPECT_EQ(bench.desk.steps().count(), steps + 1);
  bench.desk.copy_to_other();
  EXPECT_EQ(bench.desk.steps().count(), steps + 1) << "they are alike already";
  bench.desk.steps().undo();
  EXPECT_EQ(bench.desk.slot(), 'A');
  EXPECT_EQ(bench.surface().friction, 0.5);
  bench.desk.flip();
  EXPECT_EQ(bench.surface().friction, 0.9) << "what was tuned in B is there again";
  bench.desk.steps().redo();
  EXPECT_EQ(bench.surface().friction, 0.5);
  EXPECT_TRUE(bench.desk.slots_are_alike());
}

/// Returns another user's version of the chalk, as it comes with a drawing.
AnyMaterial chalk_of_another_person() {
  Bench theirs;
  theirs.desk.select({false, "chalk"});
  theirs.desk.set("feel.wear", 0.5);
  return theirs.desk.now();
}

TEST(MaterialDesk, NoCopyTakesTheIdOfWhatTheDrawingBrought) {
  const AnyMaterial theirs = chalk_of_another_person();
  Bench bench;
  const auto still_theirs = [&] {
    bench.desk.tell_now();
    const std::optional<AnyMaterial> known = find_in(bench.studio.materials(), key_of(theirs));
    const Medium* in_session = bench.studio.session().materials().find_medium(id_of(theirs));
    return known == theirs && in_session && AnyMaterial(*in_session) == theirs;
  };
  const std::vector<std::string> texts{write_material(theirs)};
  bench.studio.open(Document{}, Page{}, texts);
  bench.desk.select({false, "chalk"});
  bench.desk.set("feel.wear", 0.9);
  EXPECT_EQ(name_of(bench.desk.now()), name_of(theirs));
  EXPECT_NE(bench.desk.key(), key_of(theirs));
  EXPECT_TRUE(still_theirs());
  ASSERT_TRUE(bench.desk.save());
  EXPECT_TRUE(still_theirs());
  bench.desk.select({false, "chalk"});
  ASSERT_TRUE(bench.desk.save_as(name_of(theirs)));
  EXPECT_NE(bench.desk.key(), key_of(theirs));
  EXPECT_TRUE(still_theirs());
  const QString file = bench.home.filePath(QStringLiteral("theirs.txt"));
  AnyMaterial other = theirs;
  std::get<Medium>(other).wear = 0.1;
  ASSERT_TRUE(save_file(file.toStdString(), write_material(other)));
  ASSERT_TRUE(bench.desk.import_file(file));
  EXPECT_NE(bench.desk.key(), key_of(theirs));
  EXPECT_TRUE(still_theirs());
}

TEST(MaterialDesk, AnIdThatStrokesMayNameIsNotGivenAgain) {
  Bench bench;
  ASSERT_TRUE(bench.desk.save_as(QStringLiteral("Mine")));
  const MaterialKey key = bench.desk.key();
  ASSERT_TRUE(bench.desk.remove());
  ASSERT_TRUE(bench.desk.save_as(QStringLiteral("Mine")));
  EXPECT_NE(bench.desk.key(), key);
}

/// A drawing whose surface has the id of a user-defined one but other figures.
struct OtherSurfaceOfThatId : Bench {
  OtherSurfaceOfThatId() {
    desk.set("feel.friction", 0.5);
    EXPECT_TRUE(desk.save());
    key = desk.key();
    mine = surface();
    theirs = mine;
    theirs.friction = 0.9;
    Page page;
    page.surface = key.id;
    const std::vector<std::string> texts{write_material(theirs)};
    studio.open(Document{}, page, texts);
    desk.select(key);
  }
  [[nodiscard]] std::optional<AnyMaterial> of_drawing() const {
    return find_in(studio.materials(), key);
  }

  MaterialKey key;
  SurfaceMaterial mine, theirs;
};

TEST(MaterialDesk, WhatTheDrawingBroughtGoesBeforeOnesOwnOfThatId) {
  OtherSurfaceOfThatId bench;
  EXPECT_FALSE(bench.desk.is_own());
  EXPECT_FALSE(bench.desk.is_changed());
  EXPECT_EQ(bench.desk.now(), AnyMaterial(bench.theirs));
  EXPECT_EQ(bench.studio.session().surface(), bench.theirs);
  bench.desk.set("feel.friction", 0.7);
  EXPECT_NE(bench.desk.key(), bench.key) << "a copy";
  EXPECT_TRUE(bench.desk.is_own());
  EXPECT_EQ(bench.surface().friction, 0.7);
  bench.desk.tell_now();
  EXPECT_EQ(bench.of_drawing(), AnyMaterial(bench.theirs));
  EXPECT_EQ(bench.own.find(bench.key)->now, AnyMaterial(bench.mine));
  bench.desk.steps().undo();
  EXPECT_EQ(bench.desk.key(), bench.key);
  EXPECT_EQ(bench.desk.now(), AnyMaterial(bench.theirs));
  bench.studio.open(Document{}, Page{});
  EXPECT_TRUE(bench.desk.is_own()) << "that drawing is gone";
  EXPECT_EQ(bench.desk.now(), AnyMaterial(bench.mine));
}

TEST(MaterialDesk, AChangeInAnotherWindowLeavesTheDrawingsOwnAlone) {
  OtherSurfaceOfThatId bench;
  Studio studio({.device = QStringLiteral("simulated:touch"), .live = false});
  MaterialDesk elsewhere(studio, bench.own);
  elsewhere.select(bench.key);
  EXPECT_TRUE(elsewhere.is_own());
  elsewhere.set("feel.friction", 0.6);
  elsewhere.tell_now();
  EXPECT_EQ(studio.session().surface().friction, 0.6);
  bench.desk.tell_now();
  EXPECT_EQ(bench.of_drawing(), AnyMaterial(bench.theirs));
  EXPECT_FALSE(bench.desk.is_own());
  bench.studio.open(Document{}, Page{});
  EXPECT_TRUE(bench.desk.is_own());
  EXPECT_EQ(std::get<SurfaceMaterial>(bench.of_drawing().value()).friction, 0.6)
      << "what was withheld";
}

TEST(MaterialDesk, AnotherDrawingTakesWhatTheLastOneBroughtFromTheDesk) {
  const AnyMaterial theirs = chalk_of_another_person();
  Bench bench;
  const std::vector<std::string> texts{write_material(theirs)};
  bench.studio.open(Document{}, Page{}, texts);
  bench.desk.select(key_of(theirs));
  EXPECT_EQ(bench.desk.now(), theirs);
  EXPECT_FALSE(bench.desk.is_own());
  bench.studio.open(Document{}, Page{});
  EXPECT_EQ(bench.desk.key(), (MaterialKey{true, bench.felt_on()}));
}

TEST(MaterialDesk, SavingRenamingAndDeletingCanBeUndone) {
  Bench bench;
  bench.desk.set("feel.friction", 0.5);
  ASSERT_TRUE(bench.desk.save_as(QStringLiteral("My rough one")));
  const MaterialKey key{true, "my-rough-one"};
  EXPECT_EQ(bench.desk.key(), key);
  EXPECT_FALSE(bench.desk.is_changed());
  const QString file = bench.home.filePath(QStringLiteral("my-rough-one.toml"));
  EXPECT_TRUE(QFile::exists(file));
  bench.desk.rename(QStringLiteral("Sandpaper"));
  EXPECT_EQ(name_of(bench.desk.now()), QStringLiteral("Sandpaper"));
  EXPECT_EQ(bench.desk.key(), key) << "drawings go on naming it so";
  EXPECT_FALSE(bench.desk.is_changed());
  ASSERT_TRUE(bench.desk.remove());
  EXPECT_FALSE(QFile::exists(file));
  EXPECT_EQ(bench.felt_on(), "paper");
  bench.desk.steps().undo();
  EXPECT_TRUE(QFile::exists(file));
  EXPECT_EQ(bench.desk.key(), key);
  EXPECT_EQ(name_of(bench.desk.now()), QStringLiteral("Sandpaper"));
  EXPECT_EQ(bench.felt_on(), "my-rough-one");
  // Undoing the creation of the copy deletes no file.
  while (bench.desk.steps().canUndo()) bench.desk.steps().undo();
  EXPECT_TRUE(QFile::exists(file));
}

TEST(MaterialDesk, UndoingADeletionBringsBackTheFileAsItWasAndWhatWasNotSaved) {
  Bench bench;
  ASSERT_TRUE(bench.desk.save_as(QStringLiteral("Mine")));
  const MaterialKey key = bench.desk.key();
  const AnyMaterial saved = bench.desk.now();
  const std::string file = bench.home.filePath(QStringLiteral("mine.toml")).toStdString();
  bench.desk.set("feel.friction", 0.9);
  const AnyMaterial changed = bench.desk.now();
  ASSERT_TRUE(bench.desk.remove());
  EXPECT_FALSE(bench.own.find(key));
  for (int i = 0; i < 2; ++i) {
    bench.desk.steps().undo();
    EXPECT_EQ(bench.desk.key(), key);
    EXPECT_EQ(bench.desk.now(), changed);
    EXPECT_TRUE(bench.desk.is_changed());
    const Result<AnyMaterial> there = read_material_file(file);
    ASSERT_TRUE(there) << there.error().message;
    EXPECT_EQ(*there, saved);
    bench.desk.steps().redo();
    EXPECT_FALSE(bench.own.find(key));
    EXPECT_FALSE(read_material_file(file));
  }
}

TEST(MaterialDesk, ADeletionThatFailsIsNoStep) {
  Bench bench;
  ASSERT_TRUE(bench.desk.save_as(QStringLiteral("Mine")));
  const MaterialKey key = bench.desk.key();
  const int steps = bench.desk.steps().count();
  const std::string file = bench.home.filePath(QStringLiteral("mine.toml")).toStdString();
  ASSERT_TRUE(save_file(file, "kind = \"sheet\"\nid = \"mine\"\n"));  // written by another program
  const Result<void> removed = bench.desk.remove();
  ASSERT_FALSE(removed);
  EXPECT_NE(removed.error().message.find(file), std::string::npos);
  EXPECT_EQ(bench.desk.steps().count(), steps);
  EXPECT_EQ(bench.desk.key(), key);
  EXPECT_TRUE(bench.own.find(key));
}

TEST(MaterialDesk, TheSameNameIsNoStep) {
  Bench bench;
  ASSERT_TRUE(bench.desk.save_as(QStringLiteral("Mine")));
  const int steps = bench.desk.steps().count();
  for (const char* name : {"Mine", "  Mine ", "Mine\x07", "\x07", ""}) {
    bench.desk.rename(QString::fromLatin1(name));
    EXPECT_EQ(bench.desk.steps().count(), steps) << name;
  }
  bench.desk.rename(QStringLiteral("Yours"));
  EXPECT_EQ(bench.desk.steps().count(), steps + 1);
}

TEST(MaterialDesk, RevertBringsBackWhatTheFileHas) {
  Bench bench;
  ASSERT_TRUE(bench.desk.save_as(QStringLiteral("Mine")));
  const AnyMaterial saved = bench.desk.now();
  bench.desk.set("feel.friction", 0.9);
  bench.desk.set("grain.height_um", 20.0);
  EXPECT_TRUE(bench.desk.is_changed());
  bench.desk.revert();
  EXPECT_EQ(bench.desk.now(), saved);
  EXPECT_FALSE(bench.desk.is_changed());
  bench.desk.steps().undo();
  EXPECT_EQ(bench.surface().grain_um, 20.0);
}

TEST(MaterialDesk, FilesComeInAndGoOut) {
  Bench bench;
  bench.desk.select({false, "chalk"});
  bench.desk.set_pair("glass", 0.11);
  bench.desk.set("feel.wear", 0.5);
  const QString path = bench.home.filePath(QStringLiteral("out.txt"));
  const AnyMaterial made = bench.desk.now();
  ASSERT_TRUE(bench.desk.export_file(path));
  ASSERT_TRUE(bench.desk.import_file(path));
  EXPECT_NE(bench.desk.key(), key_of(made)) << "there was one of that id";
  EXPECT_EQ(std::get<Medium>(bench.desk.now()).pairs, std::get<Medium>(made).pairs);
  EXPECT_EQ(std::get<Medium>(bench.desk.now()).wear, 0.5);
  const Result<void> none = bench.desk.import_file(bench.home.filePath(QStringLiteral("none")));
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("none"), std::string::npos);
}

TEST(MaterialDesk, TheLineOfAMediumReachesThePencil) {
  Bench bench;
  bench.desk.select({false, "crayon"});
  EXPECT_EQ(drawing_medium(bench.studio.session()), "crayon");
  bench.desk.set("line.max_mm", 9.5);
  bench.desk.tell_now();
  const auto width = [&] {
    return std::get<double>(bench.studio.session().option("pencil.max_width_mm").value());
  };
  EXPECT_EQ(width(), 9.5);
  bench.desk.set("line.max_mm", 4.0);
  bench.desk.tell_now();
  EXPECT_EQ(width(), 4.0);
}

TEST(MaterialDesk, TheColourOfWhatIsWorkedOnIsThatOfPageAndInk) {
  Bench bench;
  const auto paper = [&] { return bench.studio.page().paper; };
  bench.desk.select({true, "blackboard"});
  EXPECT_EQ(paper(), (Rgba{0x34, 0x46, 0x3e, 255}));
  bench.desk.set("color", 0x203040);
  bench.desk.tell_now();
  EXPECT_EQ(paper(), (Rgba{0x20, 0x30, 0x40, 255}));
  bench.desk.steps().undo();
  EXPECT_EQ(paper(), (Rgba{0x34, 0x46, 0x3e, 255}));
  bench.desk.select({false, "chalk"});
  const auto ink = [&] { return bench.studio.session().ink_color(); };
  EXPECT_EQ(ink(), (Rgba{0xf4, 0xf1, 0xe6, 255}));
  bench.desk.set("color", 0xffff00);
  bench.desk.tell_now();
  EXPECT_EQ(ink(), (Rgba{0xff, 0xff, 0x00, 255}));
}

TEST(MaterialDesk, AReliefOfAPictureIsFeltAndSaved) {
  Bench bench;
  HeightPicture picture{.width = 64, .height = 64, .heights = {}, .width_mm = 0.0};
  for (int i = 0; i < 64 * 64; ++i) {
    picture.heights.push_back(static_cast<float>((i / 64 / 8 + i % 64 / 8) % 2));
  }
  ASSERT_TRUE(bench.desk.take_relief(picture));
  EXPECT_EQ(bench.surface().grain_character, HeightCharacter::kPicture);
  ASSERT_NE(surface_grain(bench.surface()), nullptr);
  ASSERT_TRUE(bench.desk.save());
  OwnMaterials next({bench.home.path().toStdString()});
  ASSERT_TRUE(next.find(bench.desk.key()));
  EXPECT_EQ(next.find(bench.desk.key())->now, bench.desk.now());
  picture.heights.assign(picture.heights.size(), 0.5F);
  EXPECT_FALSE(bench.desk.take_relief(picture)) << "a picture of one grey is no relief";
}

TEST(MaterialDesk, WhatWasToldReplaysAlike) {
  Bench bench;
  bench.desk.set("feel.friction", 0.5);
  bench.desk.set("grain.height_um", 30.0);
  bench.desk.tell_now();
  Session other(make_tools(), {});
  for (const Event& event : bench.events) ASSERT_TRUE(other.apply(event));
  EXPECT_EQ(other.surface(), bench.studio.session().surface());
}

}  // namespace
}  // namespace felt::desktop::material_desk_test
