#include "felt/tools/tool.h"

#include <algorithm>

namespace felt {

ToolUse Tool::use() const {
  const ToolInfo& tool = info();
  const Result<OptionValue> mode = option("mode");
  const auto* word = mode ? std::get_if<std::string>(&*mode) : nullptr;
  ToolUse found;
  for (const ToolUse& use : tool.uses) {
    if (!use.mode.empty() && (!word || *word != use.mode)) continue;
    found = use;
    break;
  }
  if (found.hint.empty()) found.hint = tool.help;
  return found;
}

std::optional<ToolSize> Tool::size() const {
  const std::string_view id = use().size;
  if (id.empty()) return std::nullopt;
  for (const OptionSpec& spec : info().options) {
    const Result<OptionValue> value = option(id);
    if (spec.id != id || spec.kind != OptionKind::kNumber || !value) continue;
    return ToolSize{std::get<double>(*value), spec.min, spec.max};
  }
  return std::nullopt;
}

std::vector<std::pair<std::string_view, double>> Tool::options_for_size(double mm) const {
  const std::optional<ToolSize> now = size();
  if (!now) return {};
  return {{use().size, std::clamp(mm, now->min_mm, now->max_mm)}};
}

}  // namespace felt
