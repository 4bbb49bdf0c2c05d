#include "felt/formats/lost_objects.h"

#include <algorithm>

#include "felt/formats/format_traits.h"
#include "felt/io/import.h"
#include "felt/io/xml/xml_text.h"
#include "felt/stroke/edit/corner_trips.h"

namespace felt {
namespace {

/// The kinds of objects that a format keeps, or that are no loss because it is a picture.
struct Kept {
  Kept(FileFormat format, bool compact) {
    const FormatTraits& traits = traits_of(format);
    const bool is_picture = traits.picture && (!traits.layers || compact);
    fills = format == FileFormat::kFelt || traits.picture;
    pictures = format == FileFormat::kFelt || (traits.picture && !compact);
    blends = fills || format == FileFormat::kInkml;
    is_layered_picture = is_picture || blends;
    motion = format == FileFormat::kFelt || is_picture;
    media = format != FileFormat::kXopp;
    materials = media && format != FileFormat::kNdjson;
    sharp_ends = blends;
  }
  bool fills, pictures;
  bool blends;              ///< also the opacity of layers
  bool is_layered_picture;  ///< groups, locks and names are kept or not seen
  bool motion;              ///< timings, body edits, guides and symmetry groups
  bool media, materials;
  bool sharp_ends;  ///< flat ends and pointed corners
};

void add_group(const LayerGroup& group, bool has_layers, LostObjects& lost) {
  if (has_layers) ++lost.groups;
  if (group.blend != BlendMode::kNormal) ++lost.blends;
  if (group.opacity < 1.0) ++lost.opacities;
}

/// Adds what is lost of the look of a layer in a format that only has lines.
void add_look(const Layer& layer, bool has_layers, LostObjects& lost) {
  if (layer.blend != BlendMode::kNormal) ++lost.blends;
  if (layer.opacity < 1.0) ++lost.opacities;
  if (has_layers && (layer.own_locked || (layer.group && layer.group->locked))) ++lost.locks;
}

/// Counts the strokes whose medium is not the one that a reader gives to lines of other programs.
std::size_t media_of(const Document& document, const Layer& layer) {
  std::size_t count = 0;
  for (const StrokeId id : layer.strokes) {
    if (document.find(id)->medium() != kSolidMedium) ++count;
  }
  return count;
}

/// Counts the strokes with flat ends or pointed corners.
std::size_t sharp_ends_of(const Document& document, const Layer& layer) {
  return static_cast<std::size_t>(
      std::count_if(layer.strokes.begin(), layer.strokes.end(),
                    [&](StrokeId id) { return has_corner_trips(*document.find(id)); }));
}

/// Counts the names of strokes that a file of this format has not got.
std::size_t names_of(const Drawing& drawing, FileFormat format, bool compact) {
  const bool is_xml = (format == FileFormat::kSvg && !compact) || format == FileFormat::kInkml;
  if (!is_xml && format != FileFormat::kXopp) return 0;
  const StrokeNames names = used_names(drawing);
  return static_cast<std::size_t>(std::count_if(names.begin(), names.end(), [&](const auto& named) {
    return !is_xml || xml_stroke_name(drawing, named.first) != named.second;
  }));
}

}  // namespace

LostObjects lost_objects(const Drawing& drawing, FileFormat format, bool compact) {
  const Document& document = drawing.document;
  const Kept kept(format, compact);
  const bool has_layers = traits_of(format).layers;
  const bool is_picture = traits_of(format).picture;
  const LayerGroup* last = nullptr;
  LostObjects lost;
  if (!kept.motion) {
    lost.body_edits = document.body_edits().size();
    lost.guides = document.guides().size();
    lost.symmetries = document.symmetries().size();
  }
  lost.names = names_of(drawing, format, compact);
  if (!kept.materials) lost.materials = drawing.materials.size();
  std::size_t merged = 0;
  bool is_named = false;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible && !is_picture) {
      if (!has_layers) lost.hidden_strokes += layer.strokes.size();
      if (format == FileFormat::kXopp) lost.shown_strokes += layer.strokes.size();
    }
    if (!layer.visible && !has_layers) continue;
    ++merged;
    is_named = is_named || layer.name != "Ink";
    if (!kept.fills) lost.fills += layer.fills.size();
    if (!kept.pictures && layer.picture) ++lost.pictures;
    if (!kept.motion && layer.timing) ++lost.timings;
    if (!kept.media) lost.media += media_of(document, layer);
    if (!kept.sharp_ends) lost.sharp_ends += sharp_ends_of(document, layer);
    const bool begins_group = layer.group && (!last || last->id != layer.group->id);
    last = layer.group.get();
    if (kept.is_layered_picture) continue;
    add_look(layer, has_layers, lost);
    if (begins_group) add_group(*layer.group, has_layers, lost);
  }
  if (!has_layers && !is_picture && (merged > 1 || is_named)) lost.layers = merged;
  return lost;
}

std::vector<std::string> loss_texts(const LostObjects& lost) {
  struct Loss {
    std::size_t count;
    const char *of_one, *of_many;  // "#" stands for the number
    const char* reason;
  };
  const char* const none = ", because the format has none";
  const Loss losses[] = {
      {lost.hidden_strokes, "# stroke of hidden layers was left out",
       "# strokes of hidden layers were left out", ""},
      {lost.shown_strokes, "# stroke of hidden layers is visible in the output",
       "# strokes of hidden layers are visible in the output",
       ", because .xopp does not support hidden layers"},
      {lost.fills, "# fill was left out", "# fills were left out",
       ", because the format has only lines"},
      {lost.pictures, "# picture was left out", "# pictures were left out", none},
      {lost.blends, "the blend mode of # layer or group became normal",
       "the blend modes of # layers or groups became normal", none},
      {lost.opacities, "the opacity of # layer or group became that of each stroke",
       "the opacity of # layers or groups became that of each stroke",
       ", because the format has none; strokes show through where they cross"},
      {lost.groups, "# group of layers was dissolved", "# groups of layers were dissolved", none},
      {lost.layers, "the name of # layer was left out", "# layers became one list of strokes",
       none},
      {lost.locks, "# locked layer became unlocked", "# locked layers became unlocked",
       ", because the format has no locks"},
      {lost.timings, "the timing of # key drawing was left out",
       "the timings of # key drawings were left out", none},
      {lost.body_edits, "# edit of the body was left out", "# edits of the body were left out",
       none},
      {lost.guides, "# guide was left out", "# guides were left out", none},
      {lost.symmetries, "# symmetry group was dissolved", "# symmetry groups were dissolved",
       ", because the format has none; the strokes stay"},
      {lost.sharp_ends, "# stroke with flat ends or pointed corners became round",
       "# strokes with flat ends or pointed corners became round",
       ", because the format has only round ones"},
      {lost.media, "the medium of # stroke became a plain pen",
       "the media of # strokes became a plain pen", none},
      {lost.materials, "# custom material was left out", "# custom materials were left out", none},
      {lost.names, "the name of # stroke became a number", "the names of # strokes became numbers",
       ", because the format cannot hold them"},
  };
  std::vector<std::string> texts;
  for (const Loss& loss : losses) {
    if (loss.count == 0) continue;
    std::string text = loss.count == 1 ? loss.of_one : loss.of_many;
    text.replace(text.find('#'), 1, std::to_string(loss.count));
    texts.push_back(text + loss.reason);
  }
  return texts;
}

}  // namespace felt
