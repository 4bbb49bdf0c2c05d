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

/// The walk over a file that finds what is painted (read_svg_scene), on a stack of its own.
class SvgWalker {
 public:
  SvgWalker(SvgDocument& document, std::size_t text_size, SvgSceneSink& sink);

  /// Error: the file is one of a newer Feltline.
  Result<void> walk();

 private:
  /// What an element inherits from those around it.
  struct State {
    SvgStyle style;
    Affine to_mm;
    double opacity = 1.0;
    SvgUnits units;
    std::optional<Rect> frame;
    SvgPaint context_fill, context_stroke;  ///< of the use around it
    bool default_is_svg = true;
    bool is_cut = false;  ///< by a clip path or mask
    std::shared_ptr<const SvgVariables> variables;
    SvgLayer layer;
  };
  /// An element whose children are looked at.
  struct Frame {
    pugi::xml_node node, next;
    bool only_one = false;  ///< `next` has no siblings that count: of use and switch
    bool is_use = false;
    bool repeats = false;  ///< inside of a use
    State state;
  };
  /// A shape or group that is being looked at.
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
  void enter_layer(Element& e);
  void visit_shape(Element& e);
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
  std::size_t current_layer_ = 0;
  bool has_layer_ = false;  ///< whether the sink was told one
  bool is_ours_ = false;
};

}  // namespace felt
