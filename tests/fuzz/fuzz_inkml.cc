/// Reads any bytes as InkML. The reader must not crash and must finish in bounded time. An accepted
/// drawing must keep the invariants of the model and be unchanged after writing and reading it.

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "felt/base/check.h"
#include "felt/io/inkml/inkml_import.h"
#include "felt/io/inkml/inkml_writer.h"
#include "felt/io/testing/test_drawings.h"
#include "xml_mutator.h"

namespace {

constexpr std::array<std::string_view, 48> kWords = {
    "ink",
    "trace",
    "traceGroup",
    "traceView",
    "traceFormat",
    "channel",
    "context",
    "definitions",
    "brush",
    "canvas",
    "canvasTransform",
    "mapping",
    "affine",
    "inkSource",
    "channelProperties",
    "intermittentChannels",
    "annotation",
    "X",
    "Y",
    "F",
    "T",
    "W",
    "S",
    "E",
    "#c1",
    "#t1",
    "#b1",
    "integer",
    "decimal",
    "boolean",
    "mm",
    "1/cm",
    "himetric",
    "penUp",
    "begin",
    "end",
    "identity",
    "affine",
    "-ve",
    "resolution",
    "width",
    "color",
    "transparency",
    "#ff0000",
    "true",
    "<trace>1 2,3 4</trace>",
    "<trace brushRef=\"#b1\" contextRef=\"#c1\">0 0 0,'1'1'1,\"2\"0*,?*?</trace>",
    "<traceGroup contextRef=\"#c1\">"};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace felt;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Result<Imported> first = import_inkml(text);
  if (!first) {
    FELT_CHECK(!first.error().message.empty());
    return 0;
  }
  for (const Stroke& stroke : testing::strokes_in(first->drawing.document)) {
    FELT_CHECK(check_invariants(stroke.data()));
  }
  const Result<std::string> written = inkml_text(first->drawing);
  if (!written) {
    FELT_CHECK(!written.error().message.empty());
    return 0;
  }
  const Result<Imported> second = import_inkml(*written);
  FELT_CHECK(second.has_value());
  FELT_CHECK(second->drawing == first->drawing);
  FELT_CHECK(second->report.empty());
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::string changed = felt::fuzz::XmlMutator(seed, kWords).mutated(text);
  const std::size_t length = std::min(changed.size(), max_size);
  std::memcpy(data, changed.data(), length);
  return length;
}
