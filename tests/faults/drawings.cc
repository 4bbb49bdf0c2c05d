#include "tests/faults/drawings.h"

#include <deque>
#include <filesystem>

#include "felt/document/random_document.h"

namespace felt::faults {

namespace fs = std::filesystem;

const StoredDrawing& drawing_of(std::uint32_t generation) {
  static std::deque<StoredDrawing> drawings;
  static felt::testing::RandomEdits edits(7);
  while (drawings.size() <= generation) {
    StoredDrawing next = drawings.empty() ? StoredDrawing{} : drawings.back();
    for (int i = 0; i < 4; ++i) static_cast<void>(next.document.apply(edits.next(next.document)));
    next.page.width_mm = 100.0 + static_cast<double>(drawings.size());
    next.material = "paper";
    drawings.push_back(std::move(next));
  }
  return drawings[generation];
}

int generation_at(const std::string& path, std::uint32_t most, std::string& why) {
  if (!fs::exists(path)) {
    why = path + " is gone";
    return -1;
  }
  const Result<StoredDrawing> drawing = read_felt(path);
  if (!drawing) {
    why = drawing.error().message;
    return -2;
  }
  for (std::uint32_t generation = 0; generation <= most; ++generation) {
    if (*drawing == drawing_of(generation)) return static_cast<int>(generation);
  }
  why = path + " holds a drawing that nobody saved";
  return -2;
}

}  // namespace felt::faults
