#pragma once

#include <QString>
#include <cstdint>
#include <span>

namespace felt::desktop {

/// What a button does for as long as it is held; the settings keep it by name.
enum class ButtonRole : std::uint8_t {
  kNone,
  kEraser,  ///< borrows the tool
  kPull,
  kLasso,
  kPan,   ///< moving the pen moves the sheet
  kUndo,  ///< once, when it is pressed
  kFirstModifier,
  kSecondModifier,
};

/// All of them, in the order of lists.
std::span<const ButtonRole> button_roles() noexcept;
/// "eraser"
QString name_of(ButtonRole role);
/// kNone where there is none of that name.
ButtonRole button_role(const QString& name);
/// For people: "Erase while held".
QString label_of(ButtonRole role);

}  // namespace felt::desktop
