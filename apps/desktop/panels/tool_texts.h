#pragma once

#include <QString>
#include <span>
#include <string_view>

namespace felt::desktop {

/// A text of the tools' tables (label, help, choice) in the person's language; as it is where
/// there is no translation. Qt's main thread, as all of these.
QString translated(std::string_view text);

/// A choice of an option as a person reads it: "On-curve" for "on-curve".
QString choice_text(std::string_view choice);

/// The label of an Edit ("Pull") in the person's language.
QString edit_text(std::string_view label);

/// All texts that translated() is asked for, as lupdate finds them; a test holds them against the
/// tables.
std::span<const char* const> tool_texts();
/// Likewise of edit_text().
std::span<const char* const> edit_texts();

}  // namespace felt::desktop
