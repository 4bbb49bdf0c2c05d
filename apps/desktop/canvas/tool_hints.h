#pragma once

#include <QString>
#include <string_view>

namespace felt::desktop {

/// One line for the status line while the pen hovers: what the tool in hand does, and what its two
/// modifiers (kFirstModifier: Shift, kSecondModifier: Ctrl) change. Translated. A tool that this
/// table does not know yet says nothing of modifiers, but its `help`.
QString tool_hint(std::string_view tool_id, std::string_view help, std::string_view mode = {});

}  // namespace felt::desktop
