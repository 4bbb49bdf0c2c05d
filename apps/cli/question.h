#pragma once

#include <string>

namespace felt::cli {

/// Asks the person at the terminal, on stderr; true only for a "y" or "yes". False where stdin is
/// no terminal: nobody is there to ask.
bool ask(const std::string& question);

/// Is somebody there to ask?
bool somebody_is_there();

/// Returns true if Enter was pressed at the terminal since the last call.
bool enter_pressed();

}  // namespace felt::cli
