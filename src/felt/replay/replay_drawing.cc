#include "felt/replay/replay_drawing.h"

#include <variant>

#include "felt/formats/drawing_materials.h"
#include "felt/material/material_file.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

/// Returns the ids of the media whose text is in a drawing, even if the drawing has no ink in them.
std::vector<std::string> media_of(const Drawing& drawing) {
  std::vector<std::string> ids;
  for (const std::string& text : drawing.materials) {
    const Result<AnyMaterial> material = read_material(text);
    if (material && std::holds_alternative<Medium>(*material)) ids.push_back(id_of(*material));
  }
  return ids;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> options_of(const Drawing& drawing,
                                                            const Materials& known) {
  std::vector<std::pair<std::string, std::string>> options;
  if (known.find_surface(drawing.page.surface)) {
    options.emplace_back("surface.material", drawing.page.surface);
  }
  if (drawing.color != Rgba{}) options.emplace_back("ink.color", color_to_text(drawing.color));
  return options;
}

Drawing drawing_after(Drawing drawing, const Session& session, Document document) {
  const Materials& known = session.materials();
  const std::string& surface = session.surface().id;
  // An unknown id is kept unless the user selected a surface. The session replaced the unknown
  // surface by the first one, so any other surface means that the user selected it.
  const std::string& old = drawing.page.surface;
  const bool stays = !old.empty() && !known.find_surface(old) && surface == known.surfaces()[0].id;
  if (!stays) drawing.page.surface = surface;
  drawing.document = std::move(document);
  drawing.color = session.ink_color();
  drawing.layer = session.layer();
  drawing.materials =
      texts_of_used(drawing.document, drawing.page.surface, known, media_of(drawing));
  return drawing;
}

Document seen_document(const Session& session) {
  Document seen = session.document();
  // An invalid preview is a bug of the tool. The commit will report it.
  if (session.preview()) (void)seen.apply(*session.preview_with_fills());
  return seen;
}

}  // namespace felt
