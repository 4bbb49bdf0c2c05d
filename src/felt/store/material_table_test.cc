// Texts of materials in a .felt file. The table exists only if there are texts.
#include "felt/store/material_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "felt/document/testing/random_document.h"
#include "felt/io/limits.h"
#include "felt/store/felt_salvage.h"

namespace felt::material_table_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::string_view kText = "id = \"mine\"\nlabel = \"Bütten & Co\"\n";

Drawing drawing_with(std::vector<std::string> texts) {
  Drawing drawing;
  testing::RandomEdits edits(4);
  for (int i = 0; i < 6; ++i) EXPECT_TRUE(drawing.document.apply(edits.next(drawing.document)));
  drawing.page.surface = "mine";
  drawing.materials = std::move(texts);
  return drawing;
}

TEST(MaterialTable, ComesBackInItsOrder) {
  const Drawing drawing = drawing_with({"b", std::string(kText), "a\r\n\t"});
  const std::string bytes = felt_bytes(drawing).value();
  EXPECT_EQ(parse_felt(bytes).value().materials, drawing.materials);
  EXPECT_EQ(felt_bytes(parse_felt(bytes).value()).value(), bytes);
}

TEST(MaterialTable, AFileWithoutAnyHasNoSuchTable) {
  EXPECT_THAT(felt_bytes(drawing_with({})).value(), Not(HasSubstr("TABLE material")));
  EXPECT_THAT(felt_bytes(drawing_with({"a"})).value(), HasSubstr(std::string(kMaterialTable)));
}

TEST(MaterialTable, HoldsNoMoreThanItMay) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < limits::kMaxMaterialTexts; ++i) {
    texts.push_back(std::to_string(i) + std::string(limits::kMaxMaterialTextBytes - 2, 'x'));
    texts.back().resize(limits::kMaxMaterialTextBytes, 'y');
  }
  Drawing drawing = drawing_with(texts);
  EXPECT_EQ(parse_felt(felt_bytes(drawing).value()).value().materials, drawing.materials);
  drawing.materials.emplace_back("one more");
  EXPECT_EQ(felt_bytes(drawing).error().code, ErrorCode::kLimitExceeded);
  for (const std::string& bad :
       {std::string(), std::string(limits::kMaxMaterialTextBytes + 1, 'x'), std::string("a\0b", 3),
        std::string("\xff"), std::string("bell \a")}) {
    EXPECT_EQ(felt_bytes(drawing_with({bad})).error().code, ErrorCode::kInvalidData);
  }
}

TEST(MaterialTable, ADamagedTextIsNamedAndTheRestIsSalvaged) {
  const Drawing drawing = drawing_with({"first = 1\n", std::string(kText)});
  std::string bytes = felt_bytes(drawing).value();
  bytes[bytes.find("Bütten")] = 'P';
  EXPECT_THAT(parse_felt(bytes).error().message, HasSubstr("the text of a material is damaged"));
  const Salvaged salvaged = salvage_felt_bytes(bytes).value();
  EXPECT_EQ(salvaged.drawing.materials, std::vector<std::string>{"first = 1\n"});
  EXPECT_EQ(salvaged.drawing.document.stroke_count(), drawing.document.stroke_count());
}

TEST(MaterialTable, IsSalvagedWithoutTheHeadOfTheFile) {
  const Drawing drawing = drawing_with({"b", std::string(kText), "a"});
  std::string bytes = felt_bytes(drawing).value();
  bytes.replace(0, 4096, 4096, '\0');
  const Salvaged salvaged = salvage_felt_bytes(bytes).value();
  EXPECT_EQ(salvaged.drawing.materials, drawing.materials);
  EXPECT_EQ(salvaged.drawing.page, drawing.page);
}

TEST(MaterialTable, AnotherTableOfThatNameIsRefused) {
  std::string bytes = felt_bytes(drawing_with({"a"})).value();
  const std::string ours = "text TEXT NOT NULL, checksum";
  bytes.replace(bytes.find(ours), ours.size(), "test TEXT NOT NULL, checksum");
  EXPECT_THAT(parse_felt(bytes).error().message,
              HasSubstr("the table 'material' has an unexpected definition"));
}

/// Hostile bytes give a result or an error, never a crash, and accepted texts are within the
/// limits.
TEST(MaterialTable, StandsUpToDamage) {
  const std::string bytes = felt_bytes(drawing_with({"first = 1\n", std::string(kText)})).value();
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937 random(seed);
    std::string damaged = bytes;
    for (int i = 0; i < 3; ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
    const auto read = parse_felt(damaged);
    const auto salvaged = salvage_felt_bytes(damaged);
    EXPECT_LE(read ? read->materials.size() : 0u, 2u) << "seed " << seed;
    EXPECT_LE(salvaged ? salvaged->drawing.materials.size() : 0u, 2u) << "seed " << seed;
  }
}

}  // namespace
}  // namespace felt::material_table_test
