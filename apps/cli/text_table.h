#pragma once

#include <string>
#include <vector>

namespace felt::cli {

/// The style of text on stdout, which depends on whether it is for a user at a terminal or for
/// another program.
struct TextStyle {
  bool is_terminal = false;
  bool emphasis = false;  ///< bold headings; never with NO_COLOR, on a dumb terminal or in a pipe
  std::size_t width = 0;  ///< columns at which lines wrap; 0: unlimited

  /// Returns the style of this program's stdout.
  static TextStyle of_stdout();
};

/// Returns a heading in this style.
std::string heading(const std::string& text, const TextStyle& style);

/// Wraps text at spaces into lines of at most `width` columns; if `width` is 0, there is only one
/// line. All lines except the first are indented by `indent` columns.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

/// A table of text with aligned columns, each as wide as needed. Numbers are right-aligned.
class TextTable {
 public:
  enum class Align { kLeft, kRight };
  struct Column {
    std::string name;
    Align align = Align::kLeft;
  };

  explicit TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {}

  /// Adds a row with one cell for each column. The text must be ASCII.
  void add_row(std::vector<std::string> cells);
  /// Returns the whole table below a line of column names. The last column wraps if the width of
  /// the style is too small.
  [[nodiscard]] std::string text(const TextStyle& style) const;

 private:
  [[nodiscard]] std::vector<std::size_t> widths() const;
  [[nodiscard]] std::string line(const std::vector<std::string>& cells,
                                 const std::vector<std::size_t>& widths, std::size_t room) const;

  std::vector<Column> columns_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace felt::cli
