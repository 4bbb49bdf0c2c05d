// Inflates the first closed stroke of a sketch into a body, like a balloon of that outline.
//
//   cmake -B build && cmake --build build && build/inflate sketch.felt > body.obj
//
// A sketch is a file of any format that Feltline reads.

#include <cstdio>

#include "felt/formats/drawing_reader.h"
#include "inflated.h"

namespace {

/// Returns the lowest closed stroke of a drawing, or an error if there is none.
felt::Result<felt::Stroke> first_closed_stroke(const char* path) {
  const felt::Result<felt::Imported> opened = felt::read_drawing(path);
  if (!opened) return tl::unexpected(opened.error());
  const felt::Document& document = opened->drawing.document;
  for (const felt::Layer& layer : document.layers()) {
    for (const felt::StrokeId id : layer.strokes) {
      if (document.find(id)->data().closed) return *document.find(id);
    }
  }
  return felt::fail(felt::ErrorCode::kNotFound, std::string(path) + ": it has no closed stroke");
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: inflate SKETCH > BODY.obj\n");
    return 2;
  }
  const felt::Result<felt::Stroke> stroke = first_closed_stroke(words[1]);
  const felt::Result<Mesh> mesh =
      stroke ? inflated(*stroke) : felt::Result<Mesh>(tl::unexpected(stroke.error()));
  if (!mesh) {
    std::fprintf(stderr, "inflate: %s\n", mesh.error().message.c_str());
    return 1;
  }
  const std::string text = obj_text(*mesh);
  return std::fwrite(text.data(), 1, text.size(), stdout) == text.size() ? 0 : 1;
}
