// Any bytes must give an error with a message, or a drawing that is equal after writing and
// reading. If the bytes begin like a .felt file, they are read as a file. Otherwise they are read
// as a stroke and as an edit, with a correct checksum so that the fuzzer reaches the code after
// that check.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

#include "felt/autosave/edit_blob.h"
#include "felt/store/crc32c.h"
#include "felt/store/felt_file.h"
#include "felt/store/felt_recording.h"
#include "felt/store/felt_salvage.h"
#include "felt/store/stroke_blob.h"
#include "felt_mutator.h"

namespace {

void must(bool condition) {
  if (!condition) std::abort();
}

void try_file(std::string_view bytes) {
  if (const auto salvaged = felt::salvage_felt_bytes(bytes)) {
    must(felt::felt_bytes(salvaged->drawing).has_value());
  }
  const felt::Result<felt::Drawing> drawing = felt::parse_felt(bytes);
  if (!drawing) return must(!drawing.error().message.empty());
  const std::string written = felt::felt_bytes(*drawing).value();
  const felt::Drawing again = felt::parse_felt(written).value();
  must(again.document == drawing->document && again.palette == drawing->palette &&
       again.page == drawing->page && again.view == drawing->view);
  must(felt::felt_bytes(again).value() == written);
  if (const auto all = felt::recordings_of(again)) {
    for (std::size_t i = 0; i < all->size(); ++i) static_cast<void>(read_recording(again, i));
  }
}

void try_stroke(std::string bytes) {
  const std::uint32_t crc = felt::crc32c(bytes);
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>((crc >> (8 * i)) & 0xff);
  const felt::Result<felt::Stroke> stroke = felt::read_stroke_blob(bytes);
  if (!stroke) return must(!stroke.error().message.empty());
  std::string again;
  must(felt::append_stroke_blob(again, *stroke).has_value());
  must(felt::read_stroke_blob(again).value() == *stroke);
}

void try_edit(std::string_view bytes) {
  felt::Document document;
  if (const auto edit = felt::read_edit_blob(bytes, document)) {
    static_cast<void>(document.apply(*edit));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try_file(bytes);
  try_stroke(std::string(bytes));
  try_edit(bytes);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  const std::string changed = felt::fuzz::FeltMutator(seed).mutated(bytes);
  const std::size_t length = std::min(changed.size(), max_size);
  std::memcpy(data, changed.data(), length);
  return length;
}
