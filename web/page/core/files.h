#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "felt/document/drawing.h"
#include "felt/formats/file_format.h"
#include "felt/io/import.h"
#include "web/page/core/studio.h"

namespace felt::page {

/// Reads a drawing of any format that the page reads, which the content decides; `name` is used if
/// it does not. The caller has unpacked gzip. Fails if the bytes are no drawing; the message says
/// why.
Result<Imported> read_drawing(std::string_view bytes, const std::string& name);

/// Returns the drawing of a session as it is saved.
Drawing drawing_of(const Studio& studio);

/// Returns a drawing as a file of this format. Fails if the page cannot write it.
Result<std::string> write_drawing(const Drawing& drawing, std::string_view format);

/// Returns what a file of this format lacks of the drawing (lost_objects.h).
std::vector<std::string> losses_of_writing(const Drawing& drawing, std::string_view format);
/// Returns the same for a drawing that is added to another one: only its visible strokes and fills
/// are added.
std::vector<std::string> losses_of_adding(const Drawing& drawing);

/// Returns the base of the autosave: the drawing as a .felt file or, if SQLite is not there, as an
/// .svg file, or a short text if it is empty. The first module requires that it is empty.
std::string base_of(const Studio& studio);
Result<Drawing> drawing_of_base(std::string_view base);

/// Returns false in the first module, with which the page starts. The linker then leaves out the
/// code that only the full module can reach.
bool is_full_module() noexcept;

// The following functions are in full.cc.

Result<Imported> import_as(FileFormat format, std::string_view bytes);
Result<std::string> inkml_of(const Drawing& drawing);
/// Returns a drawing as an .ndjson file. As in the programs, strokes and layers are changed first
/// if the format cannot hold them (plain_edit.h).
Result<std::string> lines_of(const Drawing& drawing);
/// Fails if SQLite is not there (database/database.cc).
Result<std::string> felt_of(const Drawing& drawing);

/// Plays a script as `feltline replay` does with the defaults and this simulated device, or draws a
/// recording unchanged. Returns the document.
struct ReplayChoice {
  bool as_recorded = false;
  bool forces = true;
  std::string device = "touch";
};
Result<Document> replay(std::string_view script, const ReplayChoice& choice);

}  // namespace felt::page
