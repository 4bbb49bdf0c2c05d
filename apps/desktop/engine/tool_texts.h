#pragma once

#include <QString>
#include <string_view>

namespace felt::desktop {

/// Returns a text of the tools' tables (label, help, hint, choice) in the user's language, or
/// unchanged if it has no translation. Call the functions of this header only in Qt's main thread.
QString translated(std::string_view text);

/// Returns the text that the user sees for a choice of an option: "On-curve" for "on-curve".
QString choice_text(std::string_view choice);

/// Returns the label of an Edit ("Pull") in the user's language.
QString edit_text(std::string_view label);

}  // namespace felt::desktop
