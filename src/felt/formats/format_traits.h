#pragma once

#include <span>
#include <string>
#include <string_view>

#include "felt/base/result.h"
#include "felt/formats/file_format.h"

namespace felt {

/// What a format can hold and what the program does with it: the one table behind help texts, file
/// dialogs and docs/formats/README.md.
struct FormatTraits {
  FileFormat format{};
  std::string_view name{};                          ///< "svg": what --to takes
  std::string_view title{};                         ///< "SVG drawing"
  std::span<const std::string_view> endings{};      ///< ".svg"; the first is the usual one
  std::span<const std::string_view> media_types{};  ///< "image/svg+xml"; the first is the usual one
  bool reads = false;
  bool writes = false;
  bool layers = false;    ///< holds layers, hidden ones as well; else only what is seen is written
  bool page = false;      ///< says the size and colour of the sheet
  bool lossless = false;  ///< strokes, layers and sheet come back as they were, number for number
  bool picture = false;   ///< written for the eye: `dpi`, grain and area count
  std::string_view widths{};  ///< what becomes of widths that vary, a clause
  std::string_view taken{};   ///< what is read of files of others; "" where nothing is
  std::string_view kept{};    ///< one sentence: what a file of this format keeps of a drawing
};

/// All formats, the richest first.
std::span<const FormatTraits> format_table() noexcept;

/// The row of a format.
const FormatTraits& traits_of(FileFormat format) noexcept;

/// The format that --to calls `name`, in either case, with or without a dot before it. Error: lists
/// those there are.
Result<FileFormat> format_of_name(std::string_view name);

/// "felt, svg and png": the names of formats that are read, or written, for messages and help.
std::string readable_names();
std::string writable_names();

/// The table of docs/formats/README.md in Markdown, a row a line.
std::string format_table_markdown();

}  // namespace felt
