#include "felt/replay/guarded_imports.h"

#include <utility>

#include "felt/base/same_file.h"

namespace felt {

ReadImport guarded_imports(std::string folder, std::vector<std::string> outputs, ReadImport read) {
  return [folder = std::move(folder), outputs = std::move(outputs),
          read = std::move(read)](const std::string& import) -> Result<VisibleInk> {
    const std::string path = import.rfind('/', 0) == 0 ? import : folder + import;
    for (const std::string& output : outputs) {
      if (output.empty() || output == "-" || !is_same_file(path, output)) continue;
      return fail(ErrorCode::kInvalidArgument,
                  path +
                      ": is imported, and the output would overwrite it; nothing was written. "
                      "Choose another file");
    }
    return read(path);
  };
}

}  // namespace felt
