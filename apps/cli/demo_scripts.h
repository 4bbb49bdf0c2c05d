#pragma once

#include <span>
#include <string_view>

namespace felt::cli {

/// An act of the demonstration: a script of a tool's folder, kept in the program so that it needs
/// no file. The name is that of the file, "1-pencil"; they are in its order.
struct DemoScript {
  std::string_view name;
  std::string_view text;
};

std::span<const DemoScript> demo_scripts() noexcept;

}  // namespace felt::cli
