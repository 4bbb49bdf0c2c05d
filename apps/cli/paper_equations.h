#pragma once

#include <string>
#include <vector>

#include "felt/base/result.h"
#include "paper_figures.h"

namespace felt::cli {

/// An equation of the paper, and what this program computes with it. All texts are Markdown.
struct PaperEquation {
  std::string number;   ///< "(7)"
  std::string printed;  ///< as the paper prints it
  std::string read;     ///< as Feltline reads it
  std::string errata;   ///< "E1, E2": headings of docs/design/errata.md
  std::string result;   ///< one sentence with the main numbers
  std::string numbers;  ///< a table with further numbers; may be empty
};

/// Returns equations 1 to 7: curves, fitting and pulling.
Result<std::vector<PaperEquation>> paper_geometry();

/// Returns equations 8 to 11, the forces. The numbers of equation 10 are those of this head.
Result<std::vector<PaperEquation>> paper_forces(const HeldHead& head);

/// Returns a table in Markdown. Each row needs a cell for each column.
std::string markdown_table(const std::vector<std::string>& columns,
                           const std::vector<std::vector<std::string>>& rows);

/// Returns the document with all equations and the captions of the figures. `law` is the form of
/// the forces in the figures.
Result<std::string> paper_document(LawForm law, const PaperFigures& figures);

}  // namespace felt::cli
