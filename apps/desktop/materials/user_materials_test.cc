#include "desktop/materials/user_materials.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>

#include "desktop/engine/settings.h"
#include "desktop/materials/material_setting_keys.h"
#include "felt/material/material_library.h"

namespace felt::desktop::user_materials_test {
namespace {

SurfaceMaterial slate() {
  SurfaceMaterial surface = *find_surface("blackboard");
  surface.id = "slate";
  surface.label = "Slate";
  surface.stiffness_n_per_m = 950.0;
  return surface;
}

SurfaceMaterial harder_slate() {
  SurfaceMaterial surface = slate();
  surface.stiffness_n_per_m = 1500.0;
  return surface;
}

void forget_unsaved() {
  Settings::the().reset(QString::fromLatin1(material_keys::kUnsaved));
}

void write(const QString& path, const QByteArray& text) {
  QFile file(path);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(text);
}

// The folder of materials is read before the first window, so a pipe in it must not block.
TEST(UserMaterials, APipeForAPictureKeepsNobodyWaiting) {
  forget_unsaved();
  const QTemporaryDir home;
  ASSERT_EQ(::mkfifo(home.filePath(QStringLiteral("pipe.png")).toLocal8Bit().constData(), 0600), 0);
  write(home.filePath(QStringLiteral("a.toml")),
        "kind = \"surface\"\nid = \"piped\"\n[grain]\npicture = \"pipe.png\"\n");
  UserMaterials own({home.path().toStdString()});
  EXPECT_TRUE(own.all().empty());
  const QStringList problems = own.take_problems();
  ASSERT_EQ(problems.size(), 1);
  EXPECT_TRUE(problems.first().contains(QStringLiteral("pipe.png: not a regular file")));
}

TEST(UserMaterials, WhatIsSavedIsThereAtTheNextStart) {
  forget_unsaved();
  const QTemporaryDir home;
  const std::string folder = home.path().toStdString() + "/feltline/materials";
  const MaterialKey key{true, "slate"};
  {
    UserMaterials own({folder});
    EXPECT_TRUE(own.all().empty());
    own.put(slate());
    ASSERT_TRUE(own.find(key));
    EXPECT_TRUE(own.find(key)->is_changed());
    ASSERT_TRUE(own.save(key));
    EXPECT_FALSE(own.find(key)->is_changed());
  }
  UserMaterials next({folder});
  EXPECT_TRUE(next.take_problems().isEmpty());
  ASSERT_TRUE(next.find(key));
  EXPECT_EQ(next.find(key)->now, AnyMaterial(slate()));
  EXPECT_FALSE(next.find(key)->is_changed());
  EXPECT_NE(next.known().find_surface("slate"), nullptr);
  EXPECT_NE(next.known().find_surface("paper"), nullptr);
}

TEST(UserMaterials, WhatIsNotSavedIsKeptAllTheSame) {
  forget_unsaved();
  const QTemporaryDir home;
  const MaterialKey key{true, "slate"};
  {
    UserMaterials own({home.path().toStdString()});
    own.put(slate());
    ASSERT_TRUE(own.save(key));
    SurfaceMaterial harder = slate();
    harder.stiffness_n_per_m = 1500.0;
    own.put(harder);
  }
  UserMaterials next({home.path().toStdString()});
  ASSERT_TRUE(next.find(key));
  EXPECT_TRUE(next.find(key)->is_changed());
  EXPECT_EQ(std::get<SurfaceMaterial>(next.find(key)->now).stiffness_n_per_m, 1500.0);
  EXPECT_EQ(std::get<SurfaceMaterial>(*next.find(key)->saved).stiffness_n_per_m, 950.0);
  next.revert(key);
  EXPECT_FALSE(next.find(key)->is_changed());
  forget_unsaved();
}

TEST(UserMaterials, ABadFileIsToldWithItsLineAndDisturbsNoOther) {
  forget_unsaved();
  const QTemporaryDir home;
  {
    UserMaterials own({home.path().toStdString()});
    own.put(slate());
    ASSERT_TRUE(own.save({true, "slate"}));
  }
  write(home.filePath(QStringLiteral("bad.toml")),
        "kind = \"surface\"\nid = \"bad\"\n\n[feel]\nfriction = 99\n");
  write(home.filePath(QStringLiteral("paper.toml")), "kind = \"surface\"\nid = \"paper\"\n");
  write(home.filePath(QStringLiteral("zslate.toml")), "kind = \"surface\"\nid = \"slate\"\n");
  UserMaterials own({home.path().toStdString()});
  const QStringList problems = own.take_problems();
  ASSERT_EQ(problems.size(), 3) << problems.join(QLatin1Char('\n')).toStdString();
  EXPECT_TRUE(problems[0].contains(QStringLiteral("bad.toml:5:"))) << problems[0].toStdString();
  EXPECT_TRUE(problems[1].contains(QStringLiteral("paper")));
  EXPECT_TRUE(problems[2].contains(QStringLiteral("zslate.toml")));
  EXPECT_TRUE(own.take_problems().isEmpty());
  EXPECT_EQ(own.all().size(), 1u);
}

TEST(UserMaterials, BuiltInOnesAreNeverReplaced) {
  forget_unsaved();
  const QTemporaryDir home;
  UserMaterials own({home.path().toStdString()});
  SurfaceMaterial paper = *find_surface("paper");
  paper.friction = 0.9;
  own.put(paper);
  EXPECT_TRUE(own.all().empty());
  EXPECT_EQ(own.known().find_surface("paper")->friction, find_surface("paper")->friction);
  EXPECT_TRUE(own.is_taken("paper"));
  EXPECT_FALSE(own.is_taken("slate"));
}

TEST(UserMaterials, RemovingTakesTheFileAway) {
  forget_unsaved();
  const QTemporaryDir home;
  UserMaterials own({home.path().toStdString()});
  QSignalSpy changed(&own, &UserMaterials::changed);
  own.put(slate());
  ASSERT_TRUE(own.save({true, "slate"}));
  EXPECT_TRUE(QFile::exists(home.filePath(QStringLiteral("slate.toml"))));
  ASSERT_TRUE(own.remove({true, "slate"}));
  EXPECT_FALSE(QFile::exists(home.filePath(QStringLiteral("slate.toml"))));
  EXPECT_EQ(changed.count(), 3);
  EXPECT_FALSE(own.find({true, "slate"}));
}

TEST(UserMaterials, AFolderThatCannotBeWrittenSaysSoAndNothingIsLost) {
  forget_unsaved();
  const QTemporaryDir home;
  write(home.filePath(QStringLiteral("file")), "no folder");
  UserMaterials own({home.path().toStdString() + "/file/materials"});
  own.put(slate());
  const Result<void> saved = own.save({true, "slate"});
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().message.find("file/materials"), std::string::npos);
  EXPECT_TRUE(own.find({true, "slate"})->is_changed());
  forget_unsaved();
}

TEST(UserMaterials, AFileThatAnotherProgramChangedIsNeitherReplacedNorDeleted) {
  forget_unsaved();
  const QTemporaryDir home;
  const MaterialKey key{true, "slate"};
  const QString file = home.filePath(QStringLiteral("slate.toml"));
  UserMaterials own({home.path().toStdString()});
  own.put(slate());
  ASSERT_TRUE(own.save(key));
  SurfaceMaterial theirs = slate();
  theirs.friction = 0.77;
  write(file, QByteArray::fromStdString(write_material(theirs)));
  own.put(harder_slate());
  const Result<void> saved = own.save(key), removed = own.remove(key);
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().message.find(file.toStdString()), std::string::npos);
  ASSERT_FALSE(removed);
  EXPECT_NE(removed.error().message.find(file.toStdString()), std::string::npos);
  EXPECT_EQ(read_material_file(file.toStdString()).value(), AnyMaterial(theirs));
  ASSERT_TRUE(own.find(key));
  EXPECT_EQ(own.find(key)->now, AnyMaterial(harder_slate()));
  EXPECT_TRUE(own.find(key)->is_changed());
  // If the file is gone, nothing can be lost.
  ASSERT_TRUE(QFile::remove(file));
  ASSERT_TRUE(own.save(key));
  EXPECT_EQ(read_material_file(file.toStdString()).value(), AnyMaterial(harder_slate()));
  ASSERT_TRUE(QFile::remove(file));
  EXPECT_TRUE(own.remove(key));
  EXPECT_FALSE(own.find(key));
  forget_unsaved();
}

TEST(UserMaterials, AFileThatWasNeverReadIsNotReplaced) {
  forget_unsaved();
  const QTemporaryDir home;
  UserMaterials own({home.path().toStdString()});
  own.put(slate());
  Medium medium = *find_medium("chalk");
  medium.id = "x";
  own.put(medium);
  // Another program adds files to the folder while this program runs.
  SurfaceMaterial theirs = slate();
  theirs.friction = 0.77;
  write(home.filePath(QStringLiteral("slate.toml")),
        QByteArray::fromStdString(write_material(theirs)));
  const QString surface = home.filePath(QStringLiteral("x.toml"));
  write(surface, "kind = \"surface\"\nid = \"x\"\n");
  EXPECT_FALSE(own.save({true, "slate"}));
  const Result<void> saved = own.save({false, "x"});
  ASSERT_FALSE(saved);
  EXPECT_NE(saved.error().message.find(surface.toStdString() + " is a surface"), std::string::npos)
      << saved.error().message;
  const Result<AnyMaterial> there = read_material_file(surface.toStdString());
  ASSERT_TRUE(there);
  EXPECT_TRUE(std::holds_alternative<SurfaceMaterial>(*there));
  forget_unsaved();
}

TEST(UserMaterials, WhatIsForAllUsersIsNotDeleted) {
  forget_unsaved();
  const QTemporaryDir home, all_users;
  const MaterialKey key{true, "slate"};
  const QString file = all_users.filePath(QStringLiteral("slate.toml"));
  write(file, QByteArray::fromStdString(write_material(slate())));
  UserMaterials own({home.path().toStdString(), all_users.path().toStdString()});
  ASSERT_TRUE(own.find(key));
  EXPECT_TRUE(own.kept_because(key).contains(file)) << own.kept_because(key).toStdString();
  EXPECT_FALSE(own.remove(key));
  EXPECT_TRUE(own.find(key));
  // After a change and a save, the file belongs to the user.
  own.put(harder_slate());
  ASSERT_TRUE(own.save(key));
  EXPECT_TRUE(QFile::exists(home.filePath(QStringLiteral("slate.toml"))));
  EXPECT_TRUE(own.kept_because(key).isEmpty());
  EXPECT_TRUE(own.remove(key));
  EXPECT_FALSE(QFile::exists(home.filePath(QStringLiteral("slate.toml"))));
  EXPECT_TRUE(QFile::exists(file));
}

TEST(UserMaterials, WhatWasKeptAndCannotBeReadIsToldAndKeptOn) {
  const QTemporaryDir home;
  const QString kept = QString::fromLatin1(material_keys::kUnsaved);
  const auto odd = QStringLiteral("kind = \"surface\"\nid = \"odd\"\n[feel]\nsmell = 1\n");
  const auto taken = QStringLiteral("kind = \"surface\"\nid = \"paper\"\n");
  const QString good = QString::fromStdString(write_material(slate()));
  Settings::the().set(kept, QStringList{odd, good, taken});
  {
    UserMaterials own({home.path().toStdString()});
    const QStringList problems = own.take_problems();
    ASSERT_EQ(problems.size(), 2) << problems.join(QLatin1Char('\n')).toStdString();
    EXPECT_TRUE(problems[0].contains(QStringLiteral("smell"))) << problems[0].toStdString();
    EXPECT_TRUE(problems[1].contains(QStringLiteral("paper"))) << problems[1].toStdString();
    EXPECT_EQ(own.all().size(), 1u);
    own.put(harder_slate());
    own.keep_changes();
    const QStringList now = Settings::the().value(kept).toStringList();
    EXPECT_EQ(now.size(), 3);
    EXPECT_TRUE(now.contains(odd));
    EXPECT_TRUE(now.contains(taken));
    own.revert({true, "slate"});
  }
  EXPECT_EQ(Settings::the().value(kept).toStringList(), (QStringList{odd, taken}));
  forget_unsaved();
}

TEST(MaterialNames, ANameHasNoControlCharacters) {
  const auto label = [](const char* name) {
    return label_of(renamed(slate(), "my-slate", QString::fromUtf8(name)));
  };
  EXPECT_EQ(label(" A\x01 soft\tone \x1b\x7f "), "A soft one");
  EXPECT_EQ(label("\x01\x02"), "My slate") << "what people call that id";
  EXPECT_EQ(material_error(renamed(slate(), "my-slate", QStringLiteral("\x01"))), "");
}

TEST(MaterialNames, ANameBecomesAnId) {
  const auto free = [](const std::string&) { return false; };
  EXPECT_EQ(id_for(QStringLiteral("My soft chalk!"), "x", free), "my-soft-chalk");
  EXPECT_EQ(id_for(QStringLiteral("Bütten, rauh"), "x", free), "butten-rauh");
  EXPECT_EQ(id_for(QStringLiteral("  "), "surface", free), "surface");
  EXPECT_EQ(id_for(QStringLiteral("木"), "surface", free), "surface");
  const auto taken = [](const std::string& id) { return id == "wood" || id == "wood-2"; };
  EXPECT_EQ(id_for(QStringLiteral("Wood"), "x", taken), "wood-3");
  for (const char* name :
       {"A-", "--", "ß9", "0123456789012345678901234567890123456789012345678901"}) {
    EXPECT_TRUE(is_material_id(id_for(QString::fromUtf8(name), "surface", free))) << name;
  }
}

}  // namespace
}  // namespace felt::desktop::user_materials_test
