#include "felt/io/svg_servers.h"

#include <string>

#include "felt/io/svg_document.h"
#include "felt/io/svg_scan.h"
#include "felt/io/svg_style.h"

namespace felt {
namespace {

constexpr int kMostLinks = 16;
/// Among which the first stop has to be: every shape may ask again.
constexpr int kMostChildren = 100;

Rgba stop_color(SvgDocument& document, const pugi::xml_node& stop, Rgba current) {
  SvgDeclared declared;
  std::string clean;
  static_cast<void>(svg_declared(stop, document.sheet(), clean, declared));
  const std::string_view text = declared[SvgProperty::kStopColor];
  Rgba color{0, 0, 0, 255};
  if (svg_same_word(text, "currentColor")) {
    color = svg_color(declared[SvgProperty::kColor]).value_or(current);
  } else if (const std::optional<Rgba> said = svg_color(text)) {
    color = *said;
  }
  return svg_faded(color, svg_share(declared[SvgProperty::kStopOpacity]).value_or(1.0));
}

}  // namespace

SvgServerColor svg_server_color(SvgDocument& document, std::string_view id, Rgba current) {
  SvgServerColor result;
  for (int links = 0; links < kMostLinks; ++links) {
    const pugi::xml_node node = document.find(id);
    const std::string_view name = document.svg_name(node, true);
    if (name == "pattern" || name == "hatch" || name == "mesh" || name == "meshgradient") {
      result.paints = true;
      result.color = Rgba{128, 128, 128, 255};
      return result;
    }
    if (name != "linearGradient" && name != "radialGradient") return result;
    result.paints = result.is_gradient = true;
    int children = 0;
    for (const pugi::xml_node child : node.children()) {
      if (++children > kMostChildren) break;
      if (document.svg_name(child, true) != "stop") continue;
      result.color = stop_color(document, child, current);
      return result;
    }
    const std::string_view next = svg_href(node);
    if (next.empty() || next.front() != '#') return result;
    id = next.substr(1);
  }
  return result;
}

}  // namespace felt
