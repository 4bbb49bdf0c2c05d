#pragma once

#include <QString>
#include <cstdint>
#include <span>

namespace felt::desktop {

/// The action of a button while it is held. The settings store it by name.
enum class ButtonRole : std::uint8_t {
  kNone,
  kEraser,  ///< selects the eraser while the button is held
  kPull,
  kLasso,
  kPan,    ///< moving the pen pans the view
  kUndo,   ///< undoes one step when the button is pressed
  kPopup,  ///< opens the palette at the pointer (Canvas::popup_wanted)
  kRing,   ///< opens the ring of tools at the pointer (Canvas::ring_wanted)
  kFirstModifier,
  kSecondModifier,
};

/// Returns all roles, in the sequence of the lists in the window.
std::span<const ButtonRole> button_roles() noexcept;
/// Returns the role's name in the settings, such as "eraser".
QString name_of(ButtonRole role);
/// Returns the role with this name, or kNone if no role has this name.
ButtonRole button_role(const QString& name);
/// Returns the label for the user, such as "Erase while held".
QString label_of(ButtonRole role);

}  // namespace felt::desktop
