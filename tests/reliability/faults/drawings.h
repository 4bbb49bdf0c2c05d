#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/document/edit.h"
#include "felt/store/felt_file.h"

namespace felt::faults {

/// Returns the drawing of a generation. Each generation has a different drawing, and every process
/// computes the same ones.
const Drawing& drawing_of(std::uint32_t generation);

/// Returns the edits that change the document of the previous generation into this one. The page
/// differs too, but no edit describes that.
const std::vector<Edit>& edits_to(std::uint32_t generation);

/// Returns the generation of `drawing`, or -1 if it equals no drawing_of().
int generation_of(const Drawing& drawing);

/// Returns the generation of the drawing in the file `path`. Returns -1 if the file is missing, and
/// -2 if it is damaged or is none of drawing_of(0..most); `why` then holds the reason.
int generation_at(const std::string& path, std::uint32_t largest, std::string& why);

}  // namespace felt::faults
