#pragma once

#include "felt/document/document.h"
#include "felt/document/edit.h"
#include "felt/formats/file_format.h"

namespace felt {

/// Returns the edit after which a format can hold the strokes of a drawing. For formats that have
/// only round ends and corners and no translucent layers (.ndjson, .xopp), it removes the trips
/// into flat ends and corners (without_corner_trips), and applies the opacity of layers and groups
/// to their strokes and fills. The edit is empty if nothing changes.
Edit plain_edit(const Document& document, FileFormat format);

}  // namespace felt
