#include "desktop/files/drawing_file.h"

namespace felt::desktop {

Result<Drawing> read_drawing(const QString& path) {
  return fail(ErrorCode::kUnsupported, path.toStdString() + ": not yet");
}

Result<void> write_drawing(const QString& path, const Drawing&) {
  return fail(ErrorCode::kUnsupported, path.toStdString() + ": not yet");
}

}  // namespace felt::desktop
