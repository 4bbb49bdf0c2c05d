#include "desktop/engine/copied_options.h"

#include <string>

#include "felt/tools/tool.h"

namespace felt::desktop {

void copy_options(const Session& from, Session& to, std::int64_t now_ns) {
  const auto copy = [&](const std::string& id) {
    const Result<OptionValue> value = from.option(id), present = to.option(id);
    if (!value || (present && *present == *value)) return;
    static_cast<void>(to.apply({now_ns, SetOption{id, *value}}));
  };
  for (const std::string& id : from.option_ids()) copy(id);
  const std::string tool(from.tool().info().id);
  if (tool != to.tool().info().id) static_cast<void>(to.apply({now_ns, SelectTool{tool}}));
}

}  // namespace felt::desktop
