/// Reads any bytes as a palette. The reader must not crash and must keep its limits. An accepted
/// palette must be unchanged after writing and reading it.

#include <cstdint>
#include <string>
#include <string_view>

#include "felt/base/check.h"
#include "felt/io/gpl_palette.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace felt;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Result<Palette> read = read_gpl("fuzz", text);
  if (!read) {
    FELT_CHECK(read.error().message.starts_with("fuzz:"));
    return 0;
  }
  FELT_CHECK(read->colors.size() <= PaletteLimits::kMaxColors);
  FELT_CHECK(read->columns <= PaletteLimits::kMaxColumns);
  for (const NamedColor& entry : read->colors) {
    FELT_CHECK(entry.name.size() <= PaletteLimits::kMaxNameBytes && entry.color.a == 255);
  }
  const Result<Palette> again = read_gpl("again", write_gpl(*read));
  FELT_CHECK(again.has_value() && *again == *read);
  return 0;
}
