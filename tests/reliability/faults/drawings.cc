#include "tests/reliability/faults/drawings.h"

#include <cstdlib>
#include <deque>
#include <filesystem>

#include "felt/document/testing/random_document.h"

namespace felt::faults {

namespace fs = std::filesystem;

namespace {

constexpr int kEdits = 4;
// Page width of generation 0. Each generation is 1 mm wider, so the width identifies it.
constexpr double kFirstWidthMm = 100.0;

struct Generation {
  Drawing drawing;
  std::vector<Edit> edits;
};

const Generation& at(std::uint32_t generation) {
  static std::deque<Generation> all;
  static felt::testing::RandomEdits random(7);
  while (all.size() <= generation) {
    Generation next;
    if (!all.empty()) next.drawing = all.back().drawing;
    for (int i = 0; i < kEdits; ++i) {
      next.edits.push_back(random.next(next.drawing.document));
      if (!next.drawing.document.apply(next.edits.back())) std::abort();
    }
    next.drawing.page.width_mm = kFirstWidthMm + static_cast<double>(all.size());
    next.drawing.page.surface = "paper";
    all.push_back(std::move(next));
  }
  return all[generation];
}

}  // namespace

const Drawing& drawing_of(std::uint32_t generation) {
  return at(generation).drawing;
}

const std::vector<Edit>& edits_to(std::uint32_t generation) {
  return at(generation).edits;
}

int generation_of(const Drawing& drawing) {
  const double number = drawing.page.width_mm - kFirstWidthMm;
  if (!(number >= 0.0 && number < 1e4)) return -1;
  const int generation = static_cast<int>(number);
  return drawing == drawing_of(static_cast<std::uint32_t>(generation)) ? generation : -1;
}

int generation_at(const std::string& path, std::uint32_t largest, std::string& why) {
  if (!fs::exists(path)) {
    why = path + " is gone";
    return -1;
  }
  const Result<Drawing> drawing = read_felt(path);
  if (!drawing) {
    why = drawing.error().message;
    return -2;
  }
  const int found = generation_of(*drawing);
  if (found >= 0 && found <= static_cast<int>(largest)) return found;
  why = path + " holds a drawing that nobody saved: page " +
        std::to_string(drawing->page.width_mm) + " mm wide, " +
        std::to_string(drawing->document.stroke_count()) + " strokes";
  return -2;
}

}  // namespace felt::faults
