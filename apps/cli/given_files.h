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

/// Throws a UsageError if an output is the same file as an input or another output, even under
/// another name, because writing it would destroy the other. "-" is stdin or stdout. Prints a
/// notice if an output has hard links, because only this name will refer to the new file. Call it
/// before opening any file.
void check_given_files(const std::vector<std::string>& inputs,
                       const std::vector<GivenOutput>& outputs, Console& console);

}  // namespace felt::cli
