#pragma once

#include <QString>
#include <span>

#include "felt/formats/file_format.h"

namespace felt::desktop {

/// What format_traits says, in the person's language.
QString format_title(FileFormat format);
/// One sentence: what a file of this format keeps of a drawing.
QString format_kept(FileFormat format);

/// All texts of the table, for translators; a test compares them.
std::span<const char* const> format_words();

/// For dialogs that open a drawing: all that is read, each format, all files.
QString open_filters();
/// For dialogs that write one format.
QString save_filter(FileFormat format);

}  // namespace felt::desktop
