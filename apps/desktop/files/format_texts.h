#pragma once

#include <QString>
#include <span>

#include "felt/formats/file_format.h"

namespace felt::desktop {

/// Returns the title of format_traits in the user's language.
QString format_title(FileFormat format);
/// Returns one sentence on what a file of this format keeps of a drawing.
QString format_kept(FileFormat format);

/// Returns all texts of the table, for translators; a test compares them.
std::span<const char* const> format_words();

/// Returns the filters of dialogs that open a drawing: all readable files, each format, all files.
QString open_filters();
/// Returns the filter of dialogs that write one format.
QString save_filter(FileFormat format);

}  // namespace felt::desktop
