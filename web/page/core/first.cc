// The first module, with which the page starts, has this in place of full.cc and
// felt/tools/all_tools.cc: it draws with the pencil until the full module is loaded.

#include "felt/tools/pencil/pencil_tool.h"
#include "felt/tools/tool.h"
#include "web/page/core/files.h"

namespace felt {

std::vector<std::unique_ptr<Tool>> make_tools() {
  std::vector<std::unique_ptr<Tool>> tools;
  tools.push_back(make_pencil());
  return tools;
}

bool page::is_full_module() noexcept {
  return false;
}

}  // namespace felt
