#pragma once

#include <string>
#include <vector>

#include "console.h"

namespace felt::cli {

/// An output as the command line names it.
struct GivenOutput {
  std::string option;  ///< "-o", "--forces"
  std::string path;    ///< "" if it was not given
};

/// Throws a UsageError if an output is one of the inputs, or another output, under whatever name:
/// writing it would destroy the other one. "-" is stdin or stdout. Gives a notice for an output
/// that has hard links: the new file gets this name only. Call before anything is opened.
void check_given_files(const std::vector<std::string>& inputs,
                       const std::vector<GivenOutput>& outputs, Console& console);

}  // namespace felt::cli
