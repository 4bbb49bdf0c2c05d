#include <fmt/core.h>

#include <memory>

#include "commands.h"
#include "felt/io/ndjson/json_text.h"
#include "felt/session/surface_options.h"
#include "felt/tools/tool.h"
#include "known_materials.h"
#include "print.h"
#include "text_table.h"

namespace felt::cli {
namespace {

std::string default_of(const OptionSpec& option) {
  switch (option.kind) {
    case OptionKind::kSwitch:
      return option.fallback != 0.0 ? "on" : "off";
    case OptionKind::kChoice:
      return std::string(option.choices[static_cast<std::size_t>(option.fallback)]);
    case OptionKind::kNumber:
      break;
  }
  return json_number(option.fallback);
}

std::string choices_of(const OptionSpec& option, const Materials& known) {
  std::string text;
  for (const std::string& choice : choices_with(option, known)) {
    text += (text.empty() ? "" : "|") + choice;
  }
  return text;
}

std::string allowed_of(const OptionSpec& option, const Materials& known) {
  if (option.kind == OptionKind::kSwitch) return "on|off";
  if (option.kind == OptionKind::kChoice) return choices_of(option, known);
  return json_number(option.min) + ".." + json_number(option.max) +
         (option.unit.empty() ? "" : " " + std::string(option.unit));
}

/// Minimum number of columns at which the description of an option is beside it; on a narrower
/// terminal it is below.
constexpr std::size_t kWideEnough = 110;
constexpr std::size_t kHelpIndent = 6;

void print_options(std::string_view owner, std::span<const OptionSpec> options,
                   const Materials& known, const TextStyle& style) {
  const bool is_narrow = style.width > 0 && style.width < kWideEnough;
  const auto cells = [owner, &known](const OptionSpec& option) {
    return std::vector<std::string>{fmt::format("  {}.{}", owner, option.id), default_of(option),
                                    allowed_of(option, known)};
  };
  if (is_narrow) {
    print("\n");
    for (const OptionSpec& option : options) {
      const std::vector<std::string> row = cells(option);
      print("{} = {}    {}\n", row[0], row[1], row[2]);
      print("{}{}\n", std::string(kHelpIndent, ' '),
            wrapped(std::string(option.help), style.width - kHelpIndent, kHelpIndent));
    }
    return;
  }
  TextTable table({{"  option"}, {"default"}, {"allowed"}, {"what it does"}});
  for (const OptionSpec& option : options) {
    std::vector<std::string> row = cells(option);
    row.emplace_back(option.help);
    table.add_row(std::move(row));
  }
  print("\n{}", table.text(style));
}

void print_text(const ToolInfo& tool, const Materials& known, const TextStyle& style) {
  const std::string shortcut = tool.shortcut ? fmt::format("  [{}]", tool.shortcut) : "";
  print("{}{}\n{}\n", heading(std::string(tool.id), style), shortcut,
        wrapped(std::string(tool.help), style.width, 0));
  if (!tool.options.empty()) print_options(tool.id, tool.options, known, style);
}

std::string option_json(const OptionSpec& option, const Materials& known) {
  JsonObject object;
  object.add_text("id", option.id);
  object.add_text("label", option.label);
  object.add_text("unit", option.unit);
  switch (option.kind) {
    case OptionKind::kNumber:
      object.add_text("kind", "number");
      object.add_number("min", option.min);
      object.add_number("max", option.max);
      object.add_number("default", option.fallback);
      break;
    case OptionKind::kSwitch:
      object.add_text("kind", "switch");
      object.add_raw("default", option.fallback != 0.0 ? "true" : "false");
      break;
    case OptionKind::kChoice: {
      std::vector<std::string> choices;
      for (const std::string& choice : choices_with(option, known)) {
        choices.push_back(json_string(choice));
      }
      object.add_text("kind", "choice");
      object.add_raw("choices", json_array(choices));
      object.add_text("default", default_of(option));
      break;
    }
  }
  object.add_text("help", option.help);
  return object.text();
}

std::string options_json(std::span<const OptionSpec> options, const Materials& known) {
  std::vector<std::string> objects;
  objects.reserve(options.size());
  for (const OptionSpec& option : options) objects.push_back(option_json(option, known));
  return json_array(objects);
}

std::string tool_json(const ToolInfo& tool, const Materials& known) {
  JsonObject object;
  object.add_text("id", tool.id);
  object.add_text("label", tool.label);
  object.add_text("help", tool.help);
  object.add_text("shortcut", tool.shortcut ? std::string(1, tool.shortcut) : "");
  object.add_raw("options", options_json(tool.options, known));
  return object.text();
}

void print_tools(bool as_json, const Materials& known) {
  const std::vector<std::unique_ptr<Tool>> tools = make_tools();
  if (as_json) {
    std::vector<std::string> objects;
    objects.reserve(tools.size());
    for (const auto& tool : tools) objects.push_back(tool_json(tool->info(), known));
    print("{{\"tools\":{},\"surface\":{}}}\n", json_array(objects),
          options_json(SurfaceOptions::table(), known));
    return;
  }
  const TextStyle style = TextStyle::of_stdout();
  for (const auto& tool : tools) {
    if (tool != tools.front()) print("\n");
    print_text(tool->info(), known, style);
  }
  print(
      "\n{}\n"
      "The surface of the page. The option ink.color sets the colour of new ink: \"#rrggbb\".\n",
      heading("surface", style));
  print_options("surface", SurfaceOptions::table(), known, style);
}

}  // namespace

void add_tools_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand("tools", "List the tools and their options");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "One line of JSON");
  command->footer(
      examples("feltline tools\n"
               "feltline tools --json | jq '.tools[].options[].id'"));
  command->callback([json, &console] { print_tools(*json, known_materials(console).materials); });
}

}  // namespace felt::cli
