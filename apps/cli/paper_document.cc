#include <fmt/core.h>

#include <utility>

#include "paper_equations.h"

namespace felt::cli {
namespace {

constexpr const char* kIntroduction =
    "# The paper, reproduced\n"
    "C. Raymaekers, G. Vansichem, F. Van Reeth, *Improving Sketching by Utilizing Haptic "
    "Feedback*, "
    "AAAI Spring Symposium, 2002.\n\n"
    "`feltline paper` made this folder and computed every number in it with the functions that "
    "draw, "
    "pull and push back. *As printed* is the equation as the paper has it, *as read* the "
    "interpretation that Feltline uses; the errata (E1, E2, ...) are explained in "
    "docs/design/errata.md. B1 to B4 are the control points of a segment, t is its parameter and V "
    "the vector from the curve to the pen.\n";

std::string cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|' || c == '<' || c == '*' || c == '_') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

}  // namespace

std::string markdown_table(const std::vector<std::string>& columns,
                           const std::vector<std::vector<std::string>>& rows) {
  std::string text = "|", rule = "|";
  for (const std::string& column : columns) {
    text += " " + cell(column) + " |";
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  for (const std::vector<std::string>& row : rows) {
    text += "|";
    for (const std::string& value : row) text += " " + cell(value) + " |";
    text += "\n";
  }
  return text;
}

Result<std::string> paper_document(LawForm law, const PaperFigures& figures) {
  Result<std::vector<PaperEquation>> equations = paper_geometry();
  if (!equations) return tl::unexpected(equations.error());
  const Result<std::vector<PaperEquation>> forces = paper_forces(figures.head);
  if (!forces) return tl::unexpected(forces.error());
  equations->insert(equations->end(), forces->begin(), forces->end());

  std::string text = kIntroduction;
  std::vector<std::vector<std::string>> rows;
  for (const PaperEquation& e : *equations) {
    rows.push_back({e.number, e.printed, e.read, e.errata, e.result});
  }
  text += "\n## Equations\n" +
          markdown_table({"no.", "as printed", "as read", "errata", "numbers"}, rows);
  text +=
      fmt::format("\n## Figures\nThe forces in the figures are {}.\n",
                  law == LawForm::kPaper ? "those of equations 8 to 11 as printed (`--law paper`)"
                                         : "those as read (`--law felt`)");
  for (std::size_t i = 0; i < figures.figures.size(); ++i) {
    text += fmt::format("\n![Figure {0}](figure-{0}.svg)\n\n*Figure {0}.* {1}\n", i + 1,
                        figures.figures[i].caption);
  }
  for (const PaperEquation& e : *equations) {
    if (!e.numbers.empty()) text += "\n## Equation " + e.number + "\n" + e.numbers;
  }
  return text;
}

}  // namespace felt::cli
