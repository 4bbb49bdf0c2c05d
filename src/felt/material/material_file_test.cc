#include "felt/material/material_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <string>

#include "felt/material/custom_relief.h"
#include "felt/material/material_fields.h"

namespace felt::material_file_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const MaterialSource kMine{.name = "my-paper.toml"};

std::string error_of(std::string_view text, const MaterialSource& source = kMine) {
  const Result<AnyMaterial> material = read_material(text, source);
  return material ? "none" : material.error().message;
}

std::string surface_with(const std::string& lines) {
  return "kind = \"surface\"\nid = \"my-paper\"\n" + lines + "\n";
}

std::string medium_with(const std::string& lines) {
  return "kind = \"medium\"\nid = \"my-pen\"\n" + lines + "\n";
}

SurfaceMaterial surface_of(std::string_view text) {
  return std::get<SurfaceMaterial>(read_material(text).value());
}

Medium medium_from(std::string_view text) {
  return std::get<Medium>(read_material(text).value());
}

TEST(MaterialFile, ReadsASurface) {
  const SurfaceMaterial surface = surface_of(R"(# mine
kind = "surface"
id = "my-paper"
label = "Bütten \"rau\""
color = "#FaF0e6"
[feel]
stiffness_n_per_m = 450
[grain]
height_um = 12.5
wavelength_mm = 1
character = "weave"
seed = 4294967295
[sound]
brightness = 0
)");
  SurfaceMaterial wanted;
  wanted.id = "my-paper";
  wanted.label = "Bütten \"rau\"";
  wanted.color_rgb = 0xFAF0E6;
  wanted.stiffness_n_per_m = 450.0;
  wanted.grain_um = 12.5;
  wanted.grain_mm = 1.0;
  wanted.grain_character = HeightCharacter::kWeave;
  wanted.grain_seed = 4294967295U;
  wanted.sound.brightness = 0.0;
  EXPECT_EQ(surface, wanted);
}

TEST(MaterialFile, ReadsAMedium) {
  const Medium medium = medium_from(R"(kind = "medium"
id = "my-pen"
draws = false
[feel]
friction = 1.5
[pairs]
glass = 0.1
canvas = 1
[line]
min_mm = 0.5
max_mm = 0.5
[look]
cut_heavy = -1.5e0
)");
  Medium wanted;
  wanted.id = "my-pen";
  wanted.label = "My pen";
  wanted.draws = false;
  wanted.friction = 1.5;
  wanted.pairs = {{"glass", 0.1}, {"canvas", 1.0}};
  wanted.line.min_mm = wanted.line.max_mm = 0.5;
  wanted.look.cut_heavy = -1.5;
  EXPECT_EQ(medium, wanted);
}

TEST(MaterialFile, SaysWhereWhichWhatAndWhatIsAllowed) {
  EXPECT_EQ(error_of(surface_with("\n\n\n[grain]\nheight_um = 900\nwavelength_mm = 1")),
            "my-paper.toml:7: grain.height_um is 900, it must be 0 to 200 um");
  EXPECT_EQ(error_of(surface_with("color = \"red\"")),
            "my-paper.toml:3: color is \"red\", it must be a colour like \"#1f2933\"");
  EXPECT_EQ(error_of(surface_with("grain.character = \"rouh\"")),
            "my-paper.toml:3: grain.character is \"rouh\", it must be one of grain, rough, weave, "
            "fibres, wood, picture");
  EXPECT_EQ(error_of(surface_with("grain.seed = 1.5")),
            "my-paper.toml:3: grain.seed is 1.5, it must be a whole number from 0 to 4294967295");
  EXPECT_EQ(error_of(medium_with("draws = 1")),
            "my-paper.toml:3: draws is 1, it must be true or false");
  EXPECT_EQ(error_of(medium_with("feel.friction = \"0.3\"")),
            "my-paper.toml:3: feel.friction is \"0.3\", it must be 0 to 1.5");
  EXPECT_EQ(error_of(medium_with("feel.wear = [1]")),
            "my-paper.toml:3: feel.wear is a list, it must be 0 to 1");
  EXPECT_EQ(error_of(medium_with("[pairs]\nglass = 2")),
            "my-paper.toml:4: pairs.glass is 2, it must be 0 to 1.5");
  EXPECT_EQ(error_of(medium_with("[line]\nmin_mm = 3\nmax_mm = 2")),
            "my-paper.toml:5: line.max_mm is 2, it must be at least line.min_mm, 3");
}

TEST(MaterialFile, RefusesWhatIsNoMaterial) {
  EXPECT_THAT(error_of(""), StartsWith("my-paper.toml:1: kind is missing"));
  EXPECT_THAT(error_of("kind = \"surface\""), StartsWith("my-paper.toml:1: id is missing"));
  EXPECT_EQ(error_of("id = \"a\"\nkind = \"paper\""),
            "my-paper.toml:2: kind is \"paper\", it must be \"surface\" or \"medium\"");
  EXPECT_THAT(error_of("kind = \"surface\"\nkind = \"surface\""), StartsWith("my-paper.toml:2: "));
  EXPECT_THAT(error_of(surface_with("a = = 3")), StartsWith("my-paper.toml:3: "));
  for (const char* header : {"[= 1]", "[[= 1]]", " [ ~", "[", "[.a]", "[[", "[]"}) {
    EXPECT_THAT(error_of(surface_with(header)), StartsWith("my-paper.toml:3: ")) << header;
  }
  EXPECT_EQ(error_of(surface_with("label = \"\xE5\"")), "my-paper.toml: is not UTF-8");
  for (const char* stray :
       {"ä = 1", "feel.friction ä= 1", "label = \"a\" ä", "ä", "a = 7'7ɔ = 1"}) {
    EXPECT_THAT(error_of(surface_with(stray)), StartsWith("my-paper.toml:3: ")) << stray;
  }
  for (const char* fine :
       {"label = \"ä\\\"ä\" # ä", "label = 'ä\"ä' # 'ä", "label = \"\"\"ä\"\"\""}) {
    EXPECT_EQ(error_of(surface_with(fine)), "none") << fine;
  }
  for (const char* id : {"", "My", "a b", "a_b", "ä", "../a", "a.b"}) {
    EXPECT_THAT(error_of("kind = \"surface\"\nid = \"" + std::string(id) + "\""),
                HasSubstr("it must be 1 to 64 of a-z, 0-9 and -"))
        << id;
  }
  EXPECT_EQ(error_of("kind = \"surface\"\nid = \"" + std::string(64, 'a') + "\""), "none");
  EXPECT_THAT(error_of("kind = \"surface\"\nid = \"" + std::string(65, 'a') + "\""),
              HasSubstr(":2: id is \"aaa"));
  EXPECT_THAT(error_of(surface_with("label = \"a\\nb\"")), HasSubstr("in one line"));
  EXPECT_THAT(error_of(surface_with("label = \"" + std::string(81, 'a') + "\"")), HasSubstr(":3:"));
}

// Some editors write a byte order mark at the start of a file.
TEST(MaterialFile, ReadsATextWithAByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  const std::string text = surface_with("label = \"Bütten\"\ncolor = \"#d8d4cc\"");
  EXPECT_EQ(surface_of(mark + text), surface_of(text));
  EXPECT_EQ(error_of(mark + surface_with("color = \"red\"")),
            error_of(surface_with("color = \"red\"")));
  EXPECT_EQ(surface_of(mark + mark + text), surface_of(text));
}

TEST(MaterialFile, RefusesUnknownKeysAndSaysWhatThereIs) {
  EXPECT_EQ(
      error_of(surface_with("[grain]\nhight_um = 2")),
      "my-paper.toml:4: grain.hight_um is unknown; [grain] of a surface has picture, heights, "
      "character, height_um, wavelength_mm, seed");
  EXPECT_EQ(error_of(surface_with("friction = 1")),
            "my-paper.toml:3: friction is unknown; a surface has kind, id, label, [grain], color, "
            "[feel], [sound]");
  EXPECT_THAT(error_of(surface_with("[look]")), HasSubstr("look is unknown"));
  EXPECT_THAT(error_of(surface_with("feel = 3")),
              HasSubstr("feel is unknown; [feel] of a surface"));
  EXPECT_EQ(error_of(surface_with("[feel]")), "none");
  EXPECT_THAT(error_of(surface_with("\"feel.friction\" = 0.2")),
              HasSubstr("\"feel.friction\" is unknown"));
  EXPECT_THAT(error_of(medium_with("[pairs]\n\"My surface\" = 0.2")),
              HasSubstr(":4: pairs.My surface"));
  EXPECT_THAT(error_of(medium_with("[[feel]]\nfriction = 0.2")), HasSubstr("unknown"));
}

TEST(MaterialFile, RefusesDuplicates) {
  EXPECT_THAT(error_of(medium_with("[pairs]\nglass = 0.1\nglass = 0.1")), HasSubstr(":5: "));
  EXPECT_THAT(error_of(surface_with("[feel]\nfriction = 0.1\n[feel]\ndamping_n_s_per_m = 1")),
              HasSubstr(":5: "));
}

TEST(MaterialFile, TellsAllThatIsWrongInItsOrder) {
  const auto problems = material_problems(
      "kind = \"surface\"\n[feel]\nfriction = 2\nspring = 1\ndamping_n_s_per_m = -1", kMine);
  std::vector<std::string> places;
  for (const Error& error : problems) places.push_back(error.message.substr(13, 3));
  EXPECT_THAT(places, ElementsAre(":1:", ":3:", ":4:", ":5:"));
  EXPECT_TRUE(material_problems(surface_with("")).empty());
  std::string many = surface_with("");
  for (int i = 0; i < 1000; ++i) many += "k" + std::to_string(i) + " = 1\n";
  EXPECT_EQ(material_problems(many).size(), 20u);
}

TEST(MaterialFile, IsBoundedInLengthAndDepth) {
  std::string text = surface_with("");
  text.resize(kMaxMaterialBytes, '\n');
  EXPECT_EQ(error_of(text), "none");
  EXPECT_EQ(error_of(text + "\n"), "my-paper.toml: is longer than 64 KiB");
  EXPECT_EQ(error_of(surface_with("# " + std::string(498, 'x'))), "none");
  EXPECT_EQ(error_of(surface_with("# " + std::string(499, 'x'))),
            "my-paper.toml:3: is longer than 500 bytes");
  std::string deep;
  for (int i = 0; i < 240; ++i) deep += "a.";
  EXPECT_THAT(error_of(surface_with(deep + "a = 1")), HasSubstr("nested too deeply"));
  EXPECT_THAT(error_of(surface_with("[" + deep + "a]\n" + deep + "b = 1")),
              HasSubstr("nested too deeply"));
  EXPECT_THAT(error_of(surface_with("a = " + std::string(200, '[') + std::string(200, ']'))),
              StartsWith("my-paper.toml:3: "));
  EXPECT_THAT(error_of(surface_with("a = {b = {c = {d = {e = 1}}}}")),
              HasSubstr("nested too deeply"));
}

TEST(MaterialFile, TakesNoNumberThatIsNone) {
  for (const char* number : {"nan", "inf", "-inf", "+nan", "1e999", "-1e-300"}) {
    EXPECT_THAT(error_of(surface_with("feel.friction = " + std::string(number))),
                StartsWith("my-paper.toml:3: "))
        << number;
  }
}

template <class Material>
std::string text_with(const Material& material, std::string_view id, double value) {
  Material changed = material;
  for (const auto& field : [] {
         if constexpr (std::is_same_v<Material, Medium>) {
           return medium_fields();
         } else {
           return surface_fields();
         }
       }()) {
    if (field.id == id) field.set(changed, value);
  }
  return write_material(changed);
}

/// Sets each field to the ends of its range, and beyond.
template <class Material, class Field>
void check_ranges(const Material& any, std::span<const Field> fields) {
  std::set<std::string_view> ids;
  for (const Field& field : fields) {
    SCOPED_TRACE(field.id);
    EXPECT_TRUE(ids.insert(field.id).second);
    EXPECT_FALSE(field.label.empty() || field.help.empty());
    EXPECT_EQ(field.help.back(), '.');
    if (field.kind != MaterialFieldKind::kNumber) continue;
    EXPECT_LT(field.min, field.max);
    for (const double good : {field.min, field.max}) {
      EXPECT_EQ(error_of(text_with(any, field.id, good)), "none") << good;
    }
    for (const double bad :
         {std::nextafter(field.min, -1e9), std::nextafter(field.max, 1e9),
          std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      EXPECT_THAT(error_of(text_with(any, field.id, bad)),
                  HasSubstr(std::string(field.id) + " is "))
          << bad;
    }
  }
}

TEST(MaterialFile, KeepsEveryFigureInItsRange) {
  SurfaceMaterial surface = *find_surface("paper");
  Medium medium = *find_medium("pencil");
  medium.line.min_mm = 0.05;
  medium.line.max_mm = 20.0;
  check_ranges(surface, surface_fields());
  check_ranges(medium, medium_fields());
}

template <class Material, class Field>
void shuffle(Material& material, std::span<const Field> fields, std::mt19937_64& random) {
  for (const Field& field : fields) {
    const double share = std::uniform_real_distribution(0.0, 1.0)(random);
    double value = field.min + share * (field.max - field.min);
    if (field.kind == MaterialFieldKind::kSwitch) value = share < 0.5 ? 0.0 : 1.0;
    if (field.kind == MaterialFieldKind::kColor) value = std::floor(share * 0x1000000);
    if (field.kind == MaterialFieldKind::kWhole) value = std::floor(value);
    if (field.kind == MaterialFieldKind::kChoice) {
      value = std::floor(share * static_cast<double>(field.choices.size() - 1));
    }
    field.set(material,
              std::clamp(value, field.kind == MaterialFieldKind::kNumber ? field.min : value,
                         field.kind == MaterialFieldKind::kNumber ? field.max : value));
  }
}

TEST(MaterialFile, WritesWhatItReads) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    SurfaceMaterial surface{.id = "s-" + std::to_string(seed), .label = "\"\\ ü # ' = ["};
    shuffle(surface, surface_fields(), random);
    const std::string text = write_material(surface);
    ASSERT_EQ(error_of(text), "none") << text;
    EXPECT_EQ(surface_of(text), surface) << text;
    EXPECT_EQ(write_material(surface_of(text)), text);

    Medium medium{.id = "m-" + std::to_string(seed), .label = "M"};
    shuffle(medium, medium_fields(), random);
    medium.line.max_mm = std::max(medium.line.max_mm, medium.line.min_mm);
    for (const char* id : {"glass", "canvas", "1-2"}) {
      medium.pairs.push_back({id, std::uniform_real_distribution(0.0, 1.5)(random)});
    }
    EXPECT_EQ(medium_from(write_material(medium)), medium) << write_material(medium);
    EXPECT_EQ(material_error(medium), "");
  }
}

TEST(MaterialFile, ReadsTheFormerKeys) {
  Medium medium{.id = "soft", .label = "Soft"};
  medium.line.tilt_width = 3.5;
  medium.line.tilt_tone = 0.25;
  const std::string text = write_material(medium);
  std::string old = text;
  for (std::size_t at = 0; (at = old.find("tilt_", at)) != std::string::npos;)
    old.replace(at, 5, "lean_");
  ASSERT_NE(old, text);
  EXPECT_EQ(medium_from(old), medium);

  EXPECT_THAT(error_of("kind = \"medium\"\nid = \"m\"\nline.tilt_tone = 1\nline.lean_tone = 1\n"),
              HasSubstr("line.lean_tone is unknown"));
}

TEST(MaterialFile, ReadsTheFormerKindOfASurface) {
  const std::string text = write_material(*find_surface("wood"));
  std::string old = text;
  old.replace(old.find("kind = \"surface\""), 16, "kind = \"sheet\"");
  ASSERT_NE(old, text);
  EXPECT_EQ(surface_of(old), surface_of(text));
}

TEST(MaterialFile, WritesEveryBuiltInMaterial) {
  for (const SurfaceMaterial& surface : surface_materials()) {
    EXPECT_EQ(surface_of(write_material(surface)), surface) << write_material(surface);
  }
  for (const Medium& medium : Materials::built_in().media()) {
    EXPECT_EQ(medium_from(write_material(medium)), medium) << write_material(medium);
  }
}

TEST(MaterialFile, SaysWhatATextOfItWouldBeRefusedFor) {
  SurfaceMaterial surface = *find_surface("paper");
  EXPECT_EQ(material_error(surface), "");
  surface.friction = 3.0;
  EXPECT_THAT(material_error(surface), HasSubstr("feel.friction is 3, it must be 0 to 1.5"));
  Medium medium = *find_medium("chalk");
  medium.label = "a\nb";
  EXPECT_THAT(material_error(medium), HasSubstr("label"));
  medium.label = "a";
  medium.pairs = {{"glass", 0.1}, {"glass", 0.2}};
  EXPECT_NE(material_error(medium), "");
}

/// A picture with a hill at its side.
HeightPicture hill(int width, int height) {
  HeightPicture picture{.width = width, .height = height, .heights = {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double dx = (x + 0.5) / width - 0.3, dy = (y + 0.5) / height - 0.6;
      picture.heights.push_back(static_cast<float>(1.0 / (1.0 + 40.0 * (dx * dx + dy * dy))));
    }
  }
  return picture;
}

TEST(MaterialFile, KeepsAReliefOfOnesOwn) {
  SurfaceMaterial surface{.id = "mine", .label = "Mine", .grain_um = 20.0, .grain_mm = 1.25};
  surface.grain_character = HeightCharacter::kPicture;
  surface.picture = custom_relief(hill(300, 200)).value();
  const std::string text = write_material(surface);
  EXPECT_LT(text.size(), kMaxMaterialBytes);
  const SurfaceMaterial again = surface_of(text);
  EXPECT_EQ(again, surface);
  EXPECT_EQ(again.picture, surface.picture) << "the same object";
  EXPECT_EQ(write_material(again), text);
}

TEST(MaterialFile, ReadsAPictureBesideTheText) {
  std::string asked;
  MaterialSource source = kMine;
  source.load_picture = [&](const std::string& file) -> Result<HeightPicture> {
    asked = file;
    if (file == "no.png") return fail(ErrorCode::kNotFound, "no.png: there is no such file");
    return hill(64, 64);
  };
  const std::string text =
      surface_with("[grain]\npicture = \"hill.png\"\nheight_um = 5\nwavelength_mm = 1");
  const auto material = read_material(text, source);
  ASSERT_TRUE(material) << material.error().message;
  const auto& surface = std::get<SurfaceMaterial>(*material);
  EXPECT_EQ(asked, "hill.png");
  ASSERT_TRUE(surface.picture);
  EXPECT_EQ(surface.grain_character, HeightCharacter::kPicture);
  EXPECT_EQ(surface_of(write_material(surface)), surface) << "and needs no file any more";

  EXPECT_EQ(error_of(surface_with("grain.picture = \"no.png\""), source),
            "my-paper.toml:3: grain.picture: no.png: there is no such file");
  EXPECT_THAT(error_of(text), HasSubstr("files are not read here"));
  for (const char* away : {"../a.png", "/etc/passwd", "a\\\\b.png", "..", ""}) {
    EXPECT_THAT(error_of(surface_with("grain.picture = \"" + std::string(away) + "\""), source),
                HasSubstr("beside this file"))
        << away;
  }
  EXPECT_THAT(error_of(surface_with("grain.character = \"picture\""), source),
              HasSubstr("are missing"));
  EXPECT_THAT(error_of(surface_with("grain.heights = \"AAAA\""), source), HasSubstr("128 x 128"));
  EXPECT_THAT(error_of(surface_with("grain.heights = \"*\""), source), HasSubstr("base64"));
}

TEST(OwnRelief, HasTheShapeOfThePicture) {
  for (const int side : {3, 100, 128, 1000}) {
    const auto relief = custom_relief(hill(side, side)).value();
    const HeightField whole = height_field_of(hill(side, side)).value();
    double alike = 0.0, ours = 0.0, theirs = 0.0;
    for (int i = 0; i < 4096; ++i) {
      const Point at{0.625 * (i % 64), 0.625 * static_cast<double>(i / 64)};
      const double a = relief->at(at).height_mm, b = whole.at(at).height_mm;
      alike += a * b;
      ours += a * a;
      theirs += b * b;
    }
    EXPECT_GT(alike / std::sqrt(ours * theirs), side < 128 ? 0.97 : 0.99) << side;
  }
  EXPECT_FALSE(custom_relief(HeightPicture{.width = 2, .height = 2, .heights = {0, 0, 0, 0}}));
  EXPECT_FALSE(custom_relief(HeightPicture{.width = 2, .height = 2, .heights = {0, 1}}));
}

TEST(OwnRelief, OfAnotherMakeIsLookedAt) {
  const HeightField field = height_field_of(hill(128, 128)).value();
  const std::string text = custom_relief_text(field);
  const auto relief = custom_relief(text).value();
  EXPECT_EQ(custom_relief_text(*relief), text);
}

TEST(Materials, NamesWhatTheBuiltInOnesDoNotHave) {
  Materials materials = Materials::built_in();
  EXPECT_TRUE(not_built_in(materials).empty());
  Medium mine = *find_medium("chalk");
  mine.id = "my-chalk";
  materials.put(mine);
  SurfaceMaterial paper = *find_surface("paper");
  paper.friction = 0.3;
  put(materials, paper);
  const std::vector<AnyMaterial> own = not_built_in(materials);
  ASSERT_EQ(own.size(), 2u);
  EXPECT_EQ(id_of(own[0]), "paper");
  EXPECT_EQ(kind_of(own[0]), "surface");
  EXPECT_EQ(id_of(own[1]), "my-chalk");
  EXPECT_EQ(label_of(own[1]), "Chalk");
}

}  // namespace
}  // namespace felt::material_file_test
