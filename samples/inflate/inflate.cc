// Inflates the first closed stroke of a sketch into a body, like a balloon of that outline.
//
//   cmake -B build && cmake --build build && build/inflate sketch.ndjson > body.obj
//
// A sketch is what `feltline fit` or `feltline replay` writes as .ndjson.

#include <fcntl.h>
#include <unistd.h>
#include <cstdio>

#include "felt/io/ndjson/ndjson_lines.h"
#include "felt/io/ndjson/ndjson_parser.h"
#include "inflated.h"

namespace {

/// The first closed stroke of a file, or why there is none.
felt::Result<felt::Stroke> first_closed_stroke(const char* path) {
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return felt::fail(felt::ErrorCode::kNotFound, "cannot be opened");
  felt::LineReader reader(felt::read_descriptor(file));
  felt::LineBatch lines;
  felt::NdjsonParser parser;
  felt::SketchRecord record;
  felt::Result<felt::Stroke> found =
      felt::fail(felt::ErrorCode::kNotFound, "there is no closed stroke in it");
  while (!found) {
    const auto more = reader.fill(lines, 1 << 16);
    if (!more) found = tl::unexpected(more.error());
    if (!more || !*more) break;
    for (std::size_t i = 0; i < lines.size() && !found; ++i) {
      const auto kind = parser.sketch_stroke(lines.line(i), record);
      if (!kind || *kind != felt::NdjsonKind::kStroke || !record.data.closed) continue;
      felt::Result<felt::Stroke> stroke = felt::Stroke::create(record.data);
      if (stroke) found = std::move(stroke);
    }
  }
  close(file);
  return found;
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: inflate SKETCH.ndjson > BODY.obj\n");
    return 2;
  }
  const felt::Result<felt::Stroke> stroke = first_closed_stroke(words[1]);
  const felt::Result<Mesh> mesh =
      stroke ? inflated(*stroke) : felt::Result<Mesh>(tl::unexpected(stroke.error()));
  if (!mesh) {
    std::fprintf(stderr, "inflate: %s: %s\n", words[1], mesh.error().message.c_str());
    return 1;
  }
  const std::string text = obj_text(*mesh);
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
}
