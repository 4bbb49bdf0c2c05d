// Replaces full.cc in the small module, with which the page starts.

#include "felt/formats/line_drawing.h"
#include "web/page/core/files.h"

namespace felt::page {
namespace {

tl::unexpected<Error> not_loaded() {
  return fail(ErrorCode::kUnsupported, "needs the full module");
}

}  // namespace

bool is_full_module() noexcept {
  return false;
}

Result<Imported> import_as(FileFormat format, std::string_view bytes) {
  if (format == FileFormat::kNdjson) return import_lines(bytes);
  return not_loaded();
}

Result<std::string> inkml_of(const Drawing&) {
  return not_loaded();
}

Result<Document> replay(std::string_view, const ReplayChoice&) {
  return not_loaded();
}

}  // namespace felt::page
