#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "felt/material/material_fields.h"
#include "felt/material/material_file.h"
#include "felt/material/number_text.h"

namespace felt::material_document_test {
namespace {

using ::testing::HasSubstr;

std::string document() {
  std::ifstream file("docs/formats/material.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

template <class Field>
std::string without(const Field& field) {
  const double value = field.fallback();
  if (!field.allows(value)) return "none";
  switch (field.kind) {
    case MaterialFieldKind::kSwitch:
      return value != 0.0 ? "true" : "false";
    case MaterialFieldKind::kChoice:
      return std::string(field.choices[static_cast<std::size_t>(value)]);
    case MaterialFieldKind::kColor:
      return value == 0xFFFFFF ? "#ffffff" : value == 0x202020 ? "#202020" : "another";
    case MaterialFieldKind::kNumber:
    case MaterialFieldKind::kWhole:
      break;
  }
  return number_text(value);
}

/// Returns the table that the document must contain.
template <class Field>
std::string table_of(std::span<const Field> fields) {
  std::string table = "| key | allowed | without it | |\n|---|---|---|---|\n";
  for (const Field& field : fields) {
    table += "| `" + std::string(field.id) + "` | " + allowed_text(field) + " | " + without(field) +
             " | " + std::string(field.help) + " |\n";
  }
  return table;
}

TEST(MaterialDocument, HasEveryFigureWithItsRange) {
  EXPECT_THAT(document(), HasSubstr(table_of(surface_fields())));
  EXPECT_THAT(document(), HasSubstr(table_of(medium_fields())));
}

TEST(MaterialDocument, HasExamplesThatAreMaterials) {
  const std::string text = document();
  std::size_t examples = 0;
  for (std::size_t at = text.find("```toml\n"); at != std::string::npos;
       at = text.find("```toml\n", at + 1)) {
    const std::size_t begin = at + 8, end = text.find("```", begin);
    ASSERT_NE(end, std::string::npos);
    for (const Error& error : material_problems(text.substr(begin, end - begin))) {
      ADD_FAILURE() << error.message;
    }
    ++examples;
  }
  EXPECT_GE(examples, 2u);
}

}  // namespace
}  // namespace felt::material_document_test
