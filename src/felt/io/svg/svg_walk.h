#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "felt/io/svg/svg_document.h"
#include "felt/io/svg/svg_scene.h"
#include "felt/io/svg/svg_style.h"

namespace felt {

/// Walks through the elements of a file with an explicit stack and passes the painted content to a
/// sink. Implements read_svg_scene().
class SvgWalker {
 public:
  SvgWalker(SvgDocument& document, std::size_t text_size, SvgSceneSink& sink);

  /// Walks the whole file. Fails if a newer Feltline wrote it.
  Result<void> walk();

 private:
  /// State that an element inherits from its ancestors.
  struct State {
    SvgStyle style;
    Affine to_mm;
    double opacity = 1.0;  ///< without that of the group
    SvgUnits units;
    std::size_t group = 0;  ///< number of the outermost transparent group, or 0
    double group_opacity = 1.0;
    std::optional<SvgFrame> frame;
    SvgPaint context_fill, context_stroke;  ///< paints of the enclosing use
    bool default_is_svg = true;
    bool is_cut = false;  ///< an ancestor has a clip path or mask
    std::shared_ptr<const SvgVariables> variables;
    SvgLayer layer;
  };
  /// An element while its children are visited.
  struct Frame {
    pugi::xml_node node, next;
    bool only_one = false;  ///< visit only `next`, not its siblings (for use and switch)
    bool is_use = false;
    bool repeats = false;  ///< the element is inside a use
    State state;
  };
  /// The shape or group that is being processed.
  struct Element {
    pugi::xml_node node;
    std::string_view name;
    SvgDeclared declared;
    State state;
  };

  Result<void> begin();
  void place_page(const std::optional<Rect>& box, SvgRoot& root, State& state) const;
  bool within_budget(const pugi::xml_node& node, bool repeats);
  void visit(const pugi::xml_node& node, const Frame& from);
  bool resolve(Element& e);
  void dispatch(Element& e, const Frame& from);
  void push(const Element& e, const Frame& from);
  void visit_svg(Element& e, const Frame& from);
  void visit_symbol(Element& e, const Frame& from);
  void enter_viewport(Element& e, const Rect& place, bool clips);
  void visit_switch(Element& e, const Frame& from);
  void visit_use(Element& e, const Frame& from);
  [[nodiscard]] static BlendMode blend_of(const Element& e);
  [[nodiscard]] BlendMode blend_of_layer(const Element& e);
  [[nodiscard]] bool is_layer(const Element& e) const;
  [[nodiscard]] bool has_layers(const Element& e) const;
  void enter_layer(Element& e);
  void enter_layer_group(Element& e);
  void enter_blended(Element& e);
  void visit_shape(Element& e);
  void visit_image(const Element& e);
  void begin_content(const Element& e);
  void read_colors(Element& e);
  void apply_opacity(Element& e);
  void apply_transform(Element& e);
  void notice_effects(Element& e);
  void draw_line(const Element& e, SvgShape& shape);
  std::optional<Rgba> paint_color(const SvgPaint& paint, const Element& e, double opacity);
  std::optional<SvgVariableWidth> variable_width(const Element& e) const;
  void emit(Element& e, std::vector<SvgContour> contours);
  bool is_paper(const Element& e) const;
  void notice(const pugi::xml_node& node, std::string what);
  [[nodiscard]] bool passes_conditions(const pugi::xml_node& node) const;

  SvgDocument& document_;
  SvgSceneSink& sink_;
  std::vector<Frame> stack_;
  std::string clean_style_;
  std::size_t segments_left_;
  std::int64_t repeats_left_, repeat_bytes_left_;
  std::size_t layers_ = 0;
  std::optional<Vec> root_size_px_;  ///< if the file gives it
  std::size_t groups_ = 0;
  std::size_t blended_groups_ = 0;
  std::size_t current_layer_ = 0;
  bool has_layer_ = false;  ///< a layer was passed to the sink
  bool is_ours_ = false;
};

}  // namespace felt
