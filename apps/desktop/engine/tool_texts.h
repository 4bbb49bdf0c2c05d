#pragma once

#include <QString>
#include <string_view>

namespace felt::desktop {

/// Returns a text of the tools' tables (label, help, hint, choice) in the user's language, or
/// unchanged if it has no translation. Call these functions on Qt's main thread only.
QString translated(std::string_view text);

/// Returns a choice of an option as the user reads it: "On-curve" for "on-curve".
QString choice_text(std::string_view choice);

/// Returns the label of an Edit ("Pull") in the user's language.
QString edit_text(std::string_view label);

}  // namespace felt::desktop
