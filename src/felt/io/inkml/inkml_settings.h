#pragma once

/// The settings of traces in an InkML file: brushes, formats, transforms, contexts. Private to this
/// layer.

#include <map>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "felt/geometry/affine.h"
#include "felt/io/import.h"
#include "felt/io/inkml/inkml_format.h"
#include "felt/io/xml/xml_input.h"
#include "felt/stroke/stroke.h"

namespace felt::inkml {

/// The colour and size that a pen draws with.
struct Brush {
  Rgba color{};
  std::optional<double> width_mm;
  bool ignores_pressure = false;
};

/// An input device.
struct Source {
  int format = -1;
  std::vector<Resolution> resolutions;
};

/// The settings of a trace: indices into the tables of Settings, -1 if unspecified.
struct Context {
  int format = -1, source = -1, brush = -1, transform = -1, canvas = -1;

  /// Returns `more`; settings that `more` does not specify are copied from this context.
  [[nodiscard]] Context overlaid(const Context& more) const noexcept;
};

/// All definitions of a file so far, by their ids.
class Settings {
 public:
  /// Notices go to `report`.
  Settings(const XmlInput& input, ImportReport& report) : input_(input), report_(report) {}

  /// If the element is a definition, stores it, sets `defined` to a context with only that setting,
  /// and returns true.
  bool define(const pugi::xml_node& node, Context& defined);

  /// Resolves the attributes contextRef, brushRef, traceFormatRef, ... of an element.
  Context referred(const pugi::xml_node& node);

  /// Returns the format of a context; X and Y if the context has no format.
  [[nodiscard]] const Format& format(const Context& context) const;
  [[nodiscard]] const std::vector<Resolution>& resolutions(const Context& context) const;
  [[nodiscard]] const Brush* brush(const Context& context) const;
  /// Returns the map from the values of a trace to coordinates on its canvas, or null if both are
  /// the same.
  [[nodiscard]] const Affine* transform(const Context& context) const;
  /// Returns the format of the canvas, or null.
  [[nodiscard]] const Format* canvas_format(const Context& context) const;

 private:
  using Ids = std::map<std::string, int, std::less<>>;

  void notice(const pugi::xml_node& node, std::string what);
  int find(const pugi::xml_node& node, const char* attribute, const Ids& ids);
  static void remember(const pugi::xml_node& node, Ids& ids, int index);
  Context read_context(const pugi::xml_node& node);
  int read_brush(const pugi::xml_node& node);
  void read_property(const pugi::xml_node& node, Brush& brush);
  void read_color(const pugi::xml_node& node, Brush& brush);
  int add_format(const pugi::xml_node& node);
  int read_source(const pugi::xml_node& node);
  int read_canvas(const pugi::xml_node& node);
  int read_transform(const pugi::xml_node& node);
  std::optional<Affine> read_mapping(const pugi::xml_node& node);

  const XmlInput& input_;
  ImportReport& report_;
  std::vector<Format> formats_;
  std::vector<Source> sources_;
  std::vector<Brush> brushes_;
  std::vector<Affine> transforms_;
  std::vector<int> canvases_;  // the format of each canvas, or -1
  std::vector<Context> contexts_;
  std::vector<Affine> mappings_;
  Ids format_ids_, source_ids_, brush_ids_, transform_ids_, canvas_ids_, context_ids_, mapping_ids_;
  const Format default_format_ = default_format();
  const std::vector<Resolution> no_resolutions_;
};

}  // namespace felt::inkml
