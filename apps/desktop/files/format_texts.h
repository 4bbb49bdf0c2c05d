#pragma once

#include <QString>
#include <span>

#include "felt/formats/file_format.h"

namespace felt::desktop {

/// Returns the format's title from format_traits in the user's language.
QString format_title(FileFormat format);
/// Returns one sentence about the parts of a drawing that a file of this format keeps.
QString format_kept(FileFormat format);

/// Returns all texts of the table, for translators. A test compares them with the table.
std::span<const char* const> format_words();

/// Returns the filters of dialogs that open a drawing: all readable files, each format, all files.
QString open_filters();
/// Returns the filter of dialogs that write one format.
QString save_filter(FileFormat format);

}  // namespace felt::desktop
