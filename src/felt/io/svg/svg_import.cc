#include "felt/io/svg/svg_import.h"

#include <utility>

#include "felt/io/limits.h"
#include "felt/io/svg/svg_ink.h"
#include "felt/io/svg/svg_scene.h"
#include "felt/io/unpack.h"

namespace felt {

Result<Imported> import_svg(std::string_view bytes, const ImportOptions& options) {
  std::string unpacked;
  if (is_gzip(bytes)) {
    Result<std::string> text = gunzip(bytes);
    if (!text) return tl::unexpected(text.error());
    unpacked = *std::move(text);
    bytes = unpacked;
  }
  if (bytes.size() > limits::kMaxImportBytes) {
    return fail(ErrorCode::kLimitExceeded, "is larger than 256 MiB");
  }
  SvgInk ink(options);
  if (auto ok = read_svg_scene(bytes, ink); !ok) return tl::unexpected(ok.error());
  return ink.take();
}

}  // namespace felt
