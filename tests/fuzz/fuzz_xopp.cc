/// Reads any bytes, compressed or not, as a document of Xournal++. The reader must not crash and
/// must finish in bounded time. Accepted documents must keep the invariants of the model. The
/// mutator changes the XML and compresses it again. Sometimes it damages the compressed bytes
/// instead.

#include <array>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "felt/base/check.h"
#include "felt/io/testing/test_drawings.h"
#include "felt/io/unpack.h"
#include "felt/io/xopp/xopp_import.h"
#include "xml_mutator.h"

namespace {

constexpr std::array<std::string_view, 34> kWords = {
    "xournal",
    "page",
    "layer",
    "stroke",
    "background",
    "text",
    "image",
    "teximage",
    "title",
    "preview",
    "pen",
    "highlighter",
    "eraser",
    "black",
    "blue",
    "#ffffffff",
    "#0000ff7f",
    "solid",
    "pdf",
    "pixmap",
    "plain",
    "lined",
    "butt",
    "square",
    "dash",
    "dot",
    "1.41",
    "1 2 3 4",
    "0 0 100 0 100 100 0 0",
    "200 358 200 358",
    "595.27559",
    "841.88976",
    "<stroke tool=\"pen\" color=\"black\" width=\"1 2 3\">0 0 9 0 9 9</stroke>\n",
    "<layer name=\"x\"></layer>\n"};

/// Largest uncompressed size. It is small because mutated files are small.
constexpr felt::UnpackLimits kSmall{.bytes = 1 << 20};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace felt;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Result<Imported> drawing = import_xopp(bytes);
  if (!drawing) {
    FELT_CHECK(!drawing.error().message.empty());
    return 0;
  }
  for (const Stroke& stroke : testing::strokes_in(drawing->drawing.document)) {
    FELT_CHECK(check_invariants(stroke.data()));
  }
  if (!is_gzip(bytes) && !is_zip(bytes)) {
    FELT_CHECK(import_xopp(gzip(bytes))->drawing == drawing->drawing);
  }
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned seed) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  std::minstd_rand random(seed);
  const bool packed = felt::is_gzip(bytes);
  const felt::Result<std::string> inside =
      packed ? felt::gunzip(bytes, kSmall) : felt::Result<std::string>(bytes);
  if (felt::is_zip(bytes) || !inside || (packed && random() % 8 == 0)) {
    for (auto n = 1 + random() % 3; n > 0 && !bytes.empty(); --n) {
      bytes[random() % bytes.size()] = static_cast<char>(random() & 0xff);
    }
  } else {
    bytes = felt::fuzz::XmlMutator(seed, kWords).mutated(*inside);
    if (packed) bytes = felt::gzip(bytes);
  }
  const std::size_t length = std::min(bytes.size(), max_size);
  std::memcpy(data, bytes.data(), length);
  return length;
}
