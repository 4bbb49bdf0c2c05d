#pragma once

#include <span>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/formats/file_format.h"

namespace felt {

/// The features that a format supports, and whether Feltline reads and writes it. Help texts, file
/// dialogs and docs/formats/README.md all use this table.
struct FormatTraits {
  FileFormat format{};
  std::string_view name{};                          ///< "svg": the value of --to
  std::string_view title{};                         ///< "SVG drawing"
  std::span<const std::string_view> endings{};      ///< ".svg"; the first is the usual one
  std::span<const std::string_view> media_types{};  ///< "image/svg+xml"; the first is the usual one
  bool reads = false;
  bool writes = false;
  bool layers = false;        ///< holds all layers, even hidden ones; otherwise only visible ink is
                              ///< written
  bool page = false;          ///< holds the size and colour of the page
  bool lossless = false;      ///< strokes, layers and page are read back exactly as they were
  bool picture = false;       ///< a picture: WriteOptions::dpi, grain and area have an effect
  std::string_view widths{};  ///< how varying widths are stored, as a clause
  std::string_view taken{};   ///< what is read from files of other programs; "" if nothing
  std::string_view kept{};    ///< what a file of this format keeps of a drawing, as a sentence
};

/// Returns the rows of all formats. The format that can hold the most comes first.
std::span<const FormatTraits> format_table() noexcept;

/// Returns the row of a format.
const FormatTraits& traits_of(FileFormat format) noexcept;

/// Returns the format that has this ending (a value of --to), in upper or lower case, with or
/// without its dot. Fails if no format has it; the message lists the formats that can be written.
Result<FileFormat> format_of_name(std::string_view name);

/// Return the names of the formats that can be read or written, for messages and help, such as
/// "felt, svg or png".
std::string readable_names();
std::string writable_names();

/// Returns the table of docs/formats/README.md in Markdown, one row per line.
std::string format_table_markdown();

}  // namespace felt
