#include "felt/io/svg/svg_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "felt/io/limits.h"
#include "felt/io/svg/svg_elements.h"
#include "felt/io/svg/svg_scan.h"
#include "felt/io/svg/svg_walk.h"

namespace felt {
namespace {

/// Returns a side of the page: as given, as a fraction of the view box, or the whole view box.
std::optional<double> page_side(std::string_view text, std::optional<double> box_px) {
  text = svg_trimmed(text);
  if (const std::optional<double> mm = svg_paper_mm(text)) {
    return *mm > 0.0 ? mm : std::nullopt;
  }
  if (!box_px) return std::nullopt;
  SvgUnits of_box;
  of_box.view_width = *box_px;
  const double px = svg_length(text, SvgAxis::kX, of_box).value_or(*box_px);
  return px > 0.0 ? std::optional(px * kSvgMmPerPx) : std::nullopt;
}

/// Returns true if the file says that it has no width or height, so that it shows nothing.
bool has_no_size(const pugi::xml_node& root) {
  const auto is_zero = [&](const char* name) {
    return svg_paper_mm(root.attribute(name).value()) == 0.0;
  };
  return is_zero("width") || is_zero("height");
}

}  // namespace

/// Computes the transform from the outermost user units to the page. In our files, the user units
/// are millimetres on the page, whichever part of the page the file shows.
void SvgWalker::place_page(const std::optional<Rect>& box, SvgRoot& root, State& state) const {
  const bool has_size = root.width_mm && root.height_mm;
  if (!box || !has_size) {
    state.to_mm = scaling(kSvgMmPerPx);
    return;
  }
  Affine m = svg_view_transform(*box, *root.width_mm, *root.height_mm,
                                document_.root().attribute("preserveAspectRatio").value());
  root.begins_at_zero = !root.is_ours || (box->x0 == 0.0 && box->y0 == 0.0);
  // If another program cropped our page to its content, it moved the origin of the view box.
  const bool was_cut = !root.begins_at_zero && !root.page.empty() && root.page != "none";
  if (root.is_ours && !was_cut) m = {m.a, m.b, m.c, m.d, 0.0, 0.0};
  if (root.is_ours && std::fabs(m.a - 1.0) < 1e-9 && std::fabs(m.d - 1.0) < 1e-9) m.a = m.d = 1.0;
  if (was_cut) root.begins_at_zero = true;
  state.to_mm = m;
}

Result<void> SvgWalker::begin() {
  Element e{document_.root(), "svg", {}, {}};
  const pugi::xml_node node = e.node;
  SvgRoot root;
  const std::string_view version = document_.ours(node, "version");
  root.is_ours = is_ours_ = !version.empty();
  if (root.is_ours && version != "1" && version != kSvgVersion) {
    return fail(ErrorCode::kUnsupported, "was written by a newer Feltline (version '" +
                                             std::string(version.substr(0, 100)) +
                                             "'; this version reads 1 and 2)");
  }
  root.page = document_.ours(node, "page");
  root.surface = document_.ours(node, "surface");
  for (std::size_t i = 1; i <= limits::kMaxMaterialTexts; ++i) {
    const auto text = document_.ours(node, ("material" + std::to_string(i)).c_str());
    if (!text.empty()) root.materials.push_back(text);
  }
  const std::optional<Rect> box = svg_view_box(node.attribute("viewBox").value());
  root.width_mm =
      page_side(node.attribute("width").value(), box ? std::optional(box->width()) : std::nullopt);
  root.height_mm = page_side(node.attribute("height").value(),
                             box ? std::optional(box->height()) : std::nullopt);
  SvgUnits& units = e.state.units;
  units.view_width = box ? box->width() : root.width_mm.value_or(0.0) / kSvgMmPerPx;
  units.view_height = box ? box->height() : root.height_mm.value_or(0.0) / kSvgMmPerPx;
  units.root_width = units.view_width;
  units.root_height = units.view_height;
  if (root.width_mm && root.height_mm) {
    root_size_px_ = Vec{*root.width_mm / kSvgMmPerPx, *root.height_mm / kSvgMmPerPx};
  }
  place_page(box, root, e.state);
  sink_.root(root);
  if (!resolve(e)) return {};
  if (e.state.variables) document_.style_sheet().set_root_variables(*e.state.variables);
  if (const auto color = svg_color(e.declared[SvgProperty::kBackgroundColor]); color) {
    sink_.paper(*color);
  }
  e.state.units.root_font_size = e.state.style.font_size;
  if (has_no_size(node)) {
    notice(node, "has a width or height of 0, so nothing of it is visible");
    return {};
  }
  push(e, Frame());
  return {};
}

Result<void> read_svg_scene(std::string_view text, SvgSceneSink& sink) {
  Result<std::unique_ptr<SvgDocument>> document = SvgDocument::parse(text);
  if (!document) return tl::unexpected(document.error());
  if (const std::int64_t rules = (*document)->style_sheet().left_out(); rules > 0) {
    sink.notice(
        0, "style",
        std::to_string(rules) + " rules of style sheets are not supported and were ignored");
  }
  if ((*document)->names_outer_style()) {
    sink.notice(0, "xml-stylesheet", "refers to a style sheet in another file, which was not read");
  }
  if (auto ok = SvgWalker(**document, text.size(), sink).walk(); !ok) return ok;
  sink.end();
  return {};
}

std::string svg_element_text(std::string_view element, std::string_view id) {
  std::string text(element);
  if (!id.empty()) text += " '" + std::string(id) + "'";
  return text;
}

}  // namespace felt
