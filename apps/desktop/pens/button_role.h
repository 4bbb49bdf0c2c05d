#pragma once

#include <QString>
#include <cstdint>
#include <span>

namespace felt::desktop {

/// What a button does while it is held; the settings store it by name.
enum class ButtonRole : std::uint8_t {
  kNone,
  kEraser,  ///< borrows the tool
  kPull,
  kLasso,
  kPan,   ///< moving the pen pans the view
  kUndo,  ///< once, when it is pressed
  kFirstModifier,
  kSecondModifier,
};

/// Returns all roles, in the order of lists.
std::span<const ButtonRole> button_roles() noexcept;
/// Returns the name in the settings: "eraser".
QString name_of(ButtonRole role);
/// Returns the role of that name, or kNone if there is none.
ButtonRole button_role(const QString& name);
/// Returns the label for the user: "Erase while held".
QString label_of(ButtonRole role);

}  // namespace felt::desktop
