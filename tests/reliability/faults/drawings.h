#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "felt/document/edit.h"
#include "felt/store/felt_file.h"

namespace felt::faults {

/// Drawings that are all different, the same in each process.
const Drawing& drawing_of(std::uint32_t generation);

/// The edits that lead from the generation before to this one; its page and material change too.
const std::vector<Edit>& edits_to(std::uint32_t generation);

/// The generation that this drawing is; -1 where it is none.
int generation_of(const Drawing& drawing);

/// The generation of the drawing that lies at `path`; -1 where there is no file, -2 where it is not
/// one of drawing_of(0..most): damaged, or something that nobody drew. `why` says more.
int generation_at(const std::string& path, std::uint32_t most, std::string& why);

}  // namespace felt::faults
