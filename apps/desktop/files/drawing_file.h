#pragma once

#include <QString>

#include "felt/base/result.h"
#include "felt/document/document.h"
#include "felt/document/sheet_page.h"

namespace felt::desktop {

/// What a file of a drawing holds.
struct Drawing {
  Document document;
  SheetPage page;
};

/// Reads a drawing: .felt, or a sketch (.ndjson). Error: names the file, the place and the reason.
Result<Drawing> read_drawing(const QString& path);

/// Writes it whole or not at all, and durably, in the format of the name's ending.
Result<void> write_drawing(const QString& path, const Drawing& drawing);

}  // namespace felt::desktop
