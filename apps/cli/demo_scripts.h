#pragma once

#include <span>
#include <string_view>

namespace felt::cli {

/// An act of the demonstration: a script from a tool's folder, compiled into the program so that it
/// needs no file. The name is that of the file, "1-pencil". Acts are sorted by name.
struct DemoScript {
  std::string_view name;
  std::string_view text;
};

std::span<const DemoScript> demo_scripts() noexcept;

}  // namespace felt::cli
