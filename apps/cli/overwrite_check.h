#pragma once

#include <string>
#include <vector>

#include "console.h"

namespace felt::cli {

/// An output on the command line.
struct GivenOutput {
  std::string option;  ///< "-o", "--forces"
  std::string path;    ///< empty if the option was not given
};

/// Throws a UsageError if an output and an input, or two outputs, are the same file, even under
/// different names, because writing the output would overwrite that file. "-" is stdin or stdout.
/// Prints a notice if an output file has further hard links, because those links will still refer
/// to the old file. Call it before opening any file.
void check_no_overwrite(const std::vector<std::string>& inputs,
                        const std::vector<GivenOutput>& outputs, Console& console);

}  // namespace felt::cli
