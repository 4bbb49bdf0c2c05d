#include "felt/material/material_library.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "felt/base/read_file.h"

namespace felt::material_library_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

namespace fs = std::filesystem;

/// A temporary folder of materials, deleted at the end of the test.
class Folder {
 public:
  explicit Folder(const std::string& name)
      : path_(::testing::TempDir() + "materials-" + std::to_string(getpid()) + "-" + name) {
    fs::create_directories(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  void put(const std::string& name, const std::string& text) const {
    std::ofstream(path_ + "/" + name) << text;
  }
  [[nodiscard]] std::string text_of(const std::string& name) const {
    std::ifstream file(path_ + "/" + name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(path_), fs::directory_iterator()));
  }

 private:
  std::string path_;
};

MaterialLibrary load(std::vector<std::string> folders) {
  return load_materials(folders);
}

std::string surface_text(const std::string& id, const std::string& friction = "0.3") {
  return "kind = \"surface\"\nid = \"" + id + "\"\n[feel]\nfriction = " + friction + "\n";
}

std::vector<std::string> ids_of(const MaterialLibrary& library) {
  std::vector<std::string> ids;
  for (const MaterialEntry& entry : library.own) ids.push_back(id_of(entry.material));
  return ids;
}

TEST(BuiltInMaterials, EachTextIsAMaterial) {
  std::size_t surfaces = 0;
  for (const BuiltInText& built_in : built_in_texts()) {
    const Result<AnyMaterial> material =
        read_material(built_in.text, {.name = std::string(built_in.id), .load_picture = {}});
    ASSERT_TRUE(material) << material.error().message;
    EXPECT_EQ(id_of(*material), built_in.id);
    EXPECT_THAT(std::string(built_in.text), StartsWith("# A "));
    surfaces += std::holds_alternative<SurfaceMaterial>(*material) ? 1 : 0;
  }
  EXPECT_EQ(surfaces, surface_materials().size());
  EXPECT_EQ(built_in_texts().size() - surfaces, Materials::built_in().media().size());
  EXPECT_EQ(surface_materials().front().id, "paper");
  EXPECT_EQ(media().front().id, "pencil");
  EXPECT_FALSE(find_medium("eraser")->draws);
}

TEST(BuiltInMaterials, AreAllFilesThatAreInstalled) {
  std::vector<std::string> files, texts;
  for (const char* kind : {"surfaces", "media"}) {
    for (const auto& entry : fs::directory_iterator("share/materials/" + std::string(kind))) {
      files.push_back(entry.path().stem().string());
    }
  }
  for (const BuiltInText& built_in : built_in_texts()) texts.emplace_back(built_in.id);
  EXPECT_THAT(files, ::testing::UnorderedElementsAreArray(texts));
}

TEST(MaterialLibrary, AddsAPersonsOwnToTheBuiltInOnes) {
  const Folder own("own"), shared("shared");
  own.put("a.toml", surface_text("my-paper"));
  own.put("b.toml", "kind = \"medium\"\nid = \"my-pen\"\n");
  own.put("notes.txt", "no material");
  own.put(".hidden.toml", "no material");
  shared.put("c.toml", surface_text("my-paper", "0.9"));
  shared.put("d.toml", surface_text("their-paper"));
  const MaterialLibrary library = load({own.path(), shared.path(), own.path() + "/none", ""});
  EXPECT_THAT(library.problems, ElementsAre());
  EXPECT_THAT(ids_of(library), ElementsAre("my-paper", "my-pen", "their-paper"));
  EXPECT_EQ(library.materials.find_surface("my-paper")->friction, 0.3) << "the first folder's";
  EXPECT_NE(library.materials.find_medium("my-pen"), nullptr);
  EXPECT_EQ(library.materials.surfaces().size(), surface_materials().size() + 2);
  EXPECT_EQ(library.own[2].path, shared.path() + "/d.toml");
}

TEST(MaterialLibrary, NamesABadFileAndLoadsTheOthers) {
  const Folder own("bad");
  own.put("a.toml", surface_text("first", "7"));
  own.put("b.toml", surface_text("paper"));
  own.put("c.toml", surface_text("charcoal"));
  own.put("d.toml", surface_text("good"));
  own.put("e.toml", surface_text("good"));
  own.put("f.toml", std::string(kMaxMaterialBytes + 1, '\n'));
  fs::create_directory(own.path() + "/g.toml");
  const MaterialLibrary library = load({own.path()});
  EXPECT_THAT(ids_of(library), ElementsAre("good"));
  ASSERT_EQ(library.problems.size(), 5u);
  EXPECT_EQ(library.problems[0], own.path() + "/a.toml:4: feel.friction is 7, it must be 0 to 1.5");
  EXPECT_THAT(library.problems[1],
              HasSubstr("b.toml: paper is the id of a surface that is built in"));
  EXPECT_THAT(library.problems[2], HasSubstr("c.toml: charcoal is the id of a medium"));
  EXPECT_THAT(library.problems[3], HasSubstr("e.toml: another file in this folder has the id"));
  EXPECT_THAT(library.problems[4], HasSubstr("f.toml"));
  EXPECT_EQ(*library.materials.find_surface("paper"), *find_surface("paper"));
}

// Reading a pipe could block, and a device may never end. Neither is read as a text, or as the
// picture that a text names.
TEST(MaterialLibrary, WaitsForNoPipe) {
  const Folder own("pipe");
  ASSERT_EQ(::mkfifo((own.path() + "/a.toml").c_str(), 0600), 0);
  ASSERT_EQ(::mkfifo((own.path() + "/pipe.png").c_str(), 0600), 0);
  fs::create_symlink("/dev/zero", own.path() + "/zero.png");
  own.put("b.toml", surface_text("of-pipe") + "[grain]\npicture = \"pipe.png\"\n");
  own.put("c.toml", surface_text("of-zero") + "[grain]\npicture = \"zero.png\"\n");
  own.put("d.toml", surface_text("good"));
  const std::vector<std::string> folders{own.path()};
  const MaterialLibrary library =
      load_materials(folders, [](const std::string& path) -> Result<HeightPicture> {
        const Result<std::string> bytes = read_regular_file(path, 1 << 20);
        if (!bytes) return tl::unexpected(bytes.error());
        return HeightPicture{};
      });
  EXPECT_THAT(ids_of(library), ElementsAre("good"));
  const std::string why = ": not a regular file";
  EXPECT_THAT(
      library.problems,
      ElementsAre(own.path() + "/b.toml:6: grain.picture: " + own.path() + "/pipe.png" + why,
                  own.path() + "/c.toml:6: grain.picture: " + own.path() + "/zero.png" + why));
}

TEST(MaterialLibrary, SavesOverTheFileOfThatIdAndDeletesIt) {
  const Folder own("save");
  const std::string below = own.path() + "/new/materials";
  SurfaceMaterial surface = *find_surface("felt");
  surface.id = "my-felt";
  const Result<std::string> path = save_material(below, surface);
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_EQ(*path, below + "/my-felt.toml");
  EXPECT_EQ(std::get<SurfaceMaterial>(read_material_file(*path).value()), surface);

  own.put("other-name.toml", surface_text("mine"));
  own.put("bad.toml", "kind = 3");
  surface.id = "mine";
  EXPECT_EQ(save_material(own.path(), surface).value(), own.path() + "/other-name.toml");
  EXPECT_EQ(own.text_of("other-name.toml"), write_material(surface));
  surface.id = "bad";
  EXPECT_THAT(save_material(own.path(), surface).error().message, HasSubstr("bad.toml is another"));
  EXPECT_EQ(own.text_of("bad.toml"), "kind = 3");
  EXPECT_EQ(own.files(), 3u) << "nothing half-written stays";

  surface.id = "mine";
  EXPECT_EQ(material_path(own.path(), surface), own.path() + "/other-name.toml");
  EXPECT_TRUE(delete_material(own.path(), surface));
  EXPECT_EQ(own.text_of("other-name.toml"), "");
  EXPECT_EQ(material_path(own.path(), surface), "");
  EXPECT_THAT(delete_material(own.path(), surface).error().message,
              HasSubstr("no custom surface \"mine\""));
  EXPECT_FALSE(delete_material(own.path(), *find_surface("paper")));
  EXPECT_FALSE(delete_material("", surface));
}

TEST(MaterialLibrary, AFileOfTheOtherKindIsNeitherReplacedNorDeleted) {
  const Folder own("kinds");
  own.put("mine.toml", surface_text("mine"));
  Medium medium = *find_medium("chalk");
  medium.id = "mine";
  const Result<std::string> saved = save_material(own.path(), medium);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message, HasSubstr(own.path() + "/mine.toml is a surface"));
  EXPECT_EQ(material_path(own.path(), medium), "");
  EXPECT_FALSE(delete_material(own.path(), medium));
  EXPECT_EQ(own.text_of("mine.toml"), surface_text("mine"));
}

TEST(MaterialLibrary, SavesNothingThatItWouldNotRead) {
  const Folder own("refuse");
  SurfaceMaterial surface = *find_surface("felt");
  EXPECT_THAT(save_material(own.path(), surface).error().message, HasSubstr("for example my-felt"));
  surface.id = "../felt";
  EXPECT_FALSE(save_material(own.path(), surface));
  surface.id = "mine";
  surface.friction = 2.0;
  EXPECT_THAT(save_material(own.path(), surface).error().message, HasSubstr("feel.friction is 2"));
  surface.friction = 0.2;
  EXPECT_THAT(save_material("", surface).error().message, HasSubstr("XDG_DATA_HOME"));
  EXPECT_EQ(own.files(), 0u);
}

/// Sets an environment variable and restores it afterwards.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old;
    value ? setenv(name, value, 1) : unsetenv(name);
  }
  ~Variable() { old_ ? setenv(name_, old_->c_str(), 1) : unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
  std::optional<std::string> old_;
};

TEST(MaterialLibrary, LooksWhereTheStandardSays) {
  const Variable home("HOME", "/h");
  {
    const Variable data("XDG_DATA_HOME", "/d"), dirs("XDG_DATA_DIRS", "/a/:relative::/b");
    EXPECT_THAT(material_folders(), ElementsAre("/d/feltline/materials", "/a/feltline/materials",
                                                "/b/feltline/materials"));
  }
  const Variable data("XDG_DATA_HOME", "not/absolute"), dirs("XDG_DATA_DIRS", nullptr);
  EXPECT_THAT(material_folders(),
              ElementsAre("/h/.local/share/feltline/materials",
                          "/usr/local/share/feltline/materials", "/usr/share/feltline/materials"));
  const Variable homeless("HOME", nullptr);
  EXPECT_EQ(material_folders().front(), "");
}

}  // namespace
}  // namespace felt::material_library_test
