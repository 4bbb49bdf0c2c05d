/// Reads any bytes as drawings of Quick, Draw! (a public data set of sketches). The reader must not
/// crash and must finish in bounded time. Accepted drawings must keep the invariants of the model.

#include <cstdint>
#include <string_view>

#include "felt/base/check.h"
#include "felt/io/quickdraw/quickdraw_import.h"
#include "felt/io/testing/test_drawings.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace felt;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Result<Imported> drawing = import_quickdraw(text);
  if (!drawing) {
    FELT_CHECK(!drawing.error().message.empty());
    return 0;
  }
  FELT_CHECK(drawing->drawing.document.layers().size() <=
             static_cast<std::size_t>(kMaxQuickdrawDrawings));
  for (const Stroke& stroke : testing::strokes_in(drawing->drawing.document)) {
    FELT_CHECK(check_invariants(stroke.data()));
  }
  return 0;
}
