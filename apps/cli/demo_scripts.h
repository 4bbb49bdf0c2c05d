#pragma once

#include <span>
#include <string_view>

namespace felt::cli {

/// An act of the demonstration: a script from a tool's folder. It is compiled into the program, so
/// that the file is not needed. Its name is that of the file, for example "1-pencil". Acts are
/// sorted by number.
struct DemoScript {
  std::string_view name;
  std::string_view text;
};

std::span<const DemoScript> demo_scripts() noexcept;

/// The two key drawings of a fish, as SVG, that swims at the end of the demonstration.
std::span<const std::string_view, 2> demo_fish() noexcept;

/// The pen strokes of share/samples/cat.ndjson.
std::string_view sample_cat() noexcept;

}  // namespace felt::cli
