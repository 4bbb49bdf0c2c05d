#include "felt/io/svg_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <utility>
#include <vector>

#include "felt/base/read_file.h"
#include "felt/io/limits.h"
#include "felt/io/svg_text.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

constexpr std::size_t kMaxSvgBytes = std::size_t{1} << 30;
constexpr std::string_view kInkscapeNamespace = "http://www.inkscape.org/namespaces/inkscape";

tl::unexpected<Error> bad(std::string what) {
  return fail(ErrorCode::kInvalidData, std::move(what));
}

/// Takes numbers, words and signs off the front of an attribute. Spaces separate.
class Words {
 public:
  explicit Words(std::string_view text) noexcept : text_(text) {}

  bool number(double& value) noexcept {
    skip_spaces();
    const char* begin = text_.data();
    const auto [end, error] = std::from_chars(begin, begin + text_.size(), value);
    if (error != std::errc() || !(std::abs(value) <= limits::kMaxSketchNumber)) return false;
    text_.remove_prefix(static_cast<std::size_t>(end - begin));
    return true;
  }
  bool take(std::string_view word) noexcept {
    skip_spaces();
    if (text_.substr(0, word.size()) != word) return false;
    text_.remove_prefix(word.size());
    return true;
  }
  /// x,y
  bool pair(double& a, double& b) noexcept { return number(a) && take(",") && number(b); }
  bool at_end() noexcept {
    skip_spaces();
    return text_.empty();
  }

 private:
  void skip_spaces() noexcept {
    const std::size_t begin = text_.find_first_not_of(" \t\r\n");
    text_.remove_prefix(begin == std::string_view::npos ? text_.size() : begin);
  }

  std::string_view text_;
};

/// Names of attributes in the prefixes that this file gives to the namespaces.
struct Names {
  std::string felt, inkscape;  ///< "felt:", "inkscape:"; empty where there is none
};

std::string prefix_of(const pugi::xml_node& root, std::string_view space) {
  for (const pugi::xml_attribute& a : root.attributes()) {
    const std::string_view name = a.name();
    if (name.substr(0, 6) == "xmlns:" && a.value() == space) {
      return std::string(name.substr(6)) + ":";
    }
  }
  return {};
}

class Reader {
 public:
  explicit Reader(Names names) : names_(std::move(names)) {}

  /// Looks at every element, without recursion: nesting is up to the file.
  Result<SvgDrawing> read(const pugi::xml_node& root) {
    SvgDrawing drawing;
    if (auto ok = read_area(root, drawing.area); !ok) return tl::unexpected(ok.error());
    pugi::xml_node node = root.first_child();
    while (node) {
      const Result<bool> inside = element(node, drawing);
      if (!inside) return tl::unexpected(inside.error());
      if (*inside && node.first_child()) {
        node = node.first_child();
        continue;
      }
      while (node != root && !node.next_sibling()) node = node.parent();
      if (node == root) break;
      node = node.next_sibling();
    }
    return drawing;
  }

 private:
  [[nodiscard]] pugi::xml_attribute ours(const pugi::xml_node& node, const char* name) const {
    return node.attribute((names_.felt + name).c_str());
  }

  /// "the path 'stroke7'"
  static std::string named(const pugi::xml_node& node) {
    return std::string("the ") + node.name() + " '" + node.attribute("id").value() + "'";
  }

  static Result<void> read_area(const pugi::xml_node& root, Rect& area) {
    Words words(root.attribute("viewBox").value());
    double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
    if (!words.number(x) || !words.number(y) || !words.number(width) || !words.number(height) ||
        !words.at_end() || !(width >= 0.0) || !(height >= 0.0)) {
      return bad("svg: its viewBox is not four numbers");
    }
    area = {x, y, x + width, y + height};
    return {};
  }

  /// True: go on inside.
  Result<bool> element(const pugi::xml_node& node, SvgDrawing& drawing) {
    if (node.type() != pugi::node_element) return false;
    const std::string_view name = node.name();
    // What other programs add for themselves is no ink.
    if (name == "defs" || name == "metadata" || name == "title" || name == "desc" ||
        name.find(':') != std::string_view::npos) {
      return false;
    }
    if (node.attribute("transform")) {
      return bad(named(node) +
                 " was moved by another program (it has a transform), which is not read yet");
    }
    if (name == "g") return true;
    if (name == "rect" && std::string_view(node.attribute("id").value()) == "paper") {
      return read_color(node, drawing.paper).map([] { return false; });
    }
    if (name != "path" || !ours(node, "widths")) {
      return fail(ErrorCode::kUnsupported,
                  named(node) + " is not of Feltline; shapes of other programs are not read yet");
    }
    return read_stroke(node, drawing.sketch).map([] { return false; });
  }

  static Result<void> read_color(const pugi::xml_node& node, Rgba& color) {
    const std::optional<Rgba> fill = color_from_text(node.attribute("fill").value());
    if (!fill) return bad(named(node) + ": fill: is no colour of the form #rrggbb");
    color = *fill;
    const pugi::xml_attribute opacity = node.attribute("fill-opacity");
    if (!opacity) return {};
    double share = 0.0;
    Words words(opacity.value());
    if (!words.number(share) || !words.at_end() || !(share >= 0.0) || share > 1.0) {
      return bad(named(node) + ": fill-opacity: is no number from 0 to 1");
    }
    color.a = static_cast<std::uint8_t>(std::lround(share * 255.0));
    return {};
  }

  Result<void> read_stroke(const pugi::xml_node& node, Sketch& sketch) const {
    StrokeData d;
    const std::string id = ours(node, "id").value();
    d.material = ours(node, "material").value();
    if (id.size() > limits::kMaxNameBytes || d.material.size() > limits::kMaxNameBytes) {
      return fail(ErrorCode::kLimitExceeded, named(node) + ": has a name of more than 4096 bytes");
    }
    const std::string_view closed = ours(node, "closed").value();
    if (closed != "true" && closed != "false") {
      return bad(named(node) + ": closed: is neither true nor false");
    }
    d.closed = closed == "true";
    if (auto ok = read_color(node, d.color); !ok) return ok;
    const char* line = node.attribute((names_.inkscape + "original-d").c_str()).value();
    if (!read_center_line(line, d)) {
      return bad(named(node) + ": original-d: is no centre line that Feltline wrote");
    }
    if (!read_joints(ours(node, "joints").value(), d)) {
      return bad(named(node) + ": joints: are not all smooth or corner");
    }
    if (!read_widths(ours(node, "widths").value(), d)) {
      return bad(named(node) + ": widths: are not all u,W");
    }
    Result<Stroke> stroke = Stroke::create(std::move(d));
    if (!stroke) return tl::unexpected(with_context(stroke.error(), named(node)));
    sketch.push_back({id, *std::move(stroke)});
    return {};
  }

  static bool read_center_line(std::string_view text, StrokeData& d) {
    Words words(text);
    Point p;
    if (!words.take("M") || !words.pair(p.x, p.y)) return false;
    d.points.push_back(p);
    if (!words.take("C")) return false;
    bool closes = false;
    while (!words.at_end()) {
      if (words.take("Z")) {
        closes = true;
        break;
      }
      if (!words.pair(p.x, p.y)) return false;
      d.points.push_back(p);
    }
    return words.at_end() && closes == d.closed;
  }

  static bool read_joints(std::string_view text, StrokeData& d) {
    Words words(text);
    while (!words.at_end()) {
      if (words.take("smooth")) {
        d.joints.push_back(JointKind::kSmooth);
      } else if (words.take("corner")) {
        d.joints.push_back(JointKind::kCorner);
      } else {
        return false;
      }
    }
    return true;
  }

  static bool read_widths(std::string_view text, StrokeData& d) {
    Words words(text);
    WidthKnot knot;
    while (!words.at_end()) {
      if (!words.pair(knot.u, knot.width_mm)) return false;
      d.widths.push_back(knot);
    }
    return true;
  }

  Names names_;
};

/// "line 12" of a place in a text.
std::string line_of(std::string_view text, std::ptrdiff_t at) {
  std::size_t line = 1;
  const auto end = std::min(text.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(at, 0)));
  for (const char c : text.substr(0, end)) line += c == '\n' ? 1 : 0;
  return "line " + std::to_string(line);
}

}  // namespace

Result<SvgDrawing> parse_svg(std::string_view text) {
  if (text.size() > kMaxSvgBytes) {
    return fail(ErrorCode::kLimitExceeded, "is larger than 1 GiB");
  }
  pugi::xml_document document;
  const pugi::xml_parse_result parsed =
      document.load_buffer(text.data(), text.size(), pugi::parse_default, pugi::encoding_utf8);
  if (!parsed) return bad(line_of(text, parsed.offset) + ": is no XML: " + parsed.description());
  const pugi::xml_node root = document.document_element();
  if (std::string_view(root.name()) != "svg") return bad("is no SVG");
  Names names{prefix_of(root, kSvgNamespace), prefix_of(root, kInkscapeNamespace)};
  if (names.felt.empty() || names.inkscape.empty()) {
    return fail(ErrorCode::kUnsupported,
                "is an SVG of another program; Feltline reads only those that it wrote");
  }
  const std::string_view version = root.attribute((names.felt + "version").c_str()).value();
  if (version != "1") {
    return fail(ErrorCode::kUnsupported, "was written by a newer Feltline (version '" +
                                             std::string(version) + "', this one knows 1)");
  }
  return Reader(std::move(names)).read(root);
}

Result<SvgDrawing> read_svg(const std::string& path) {
  const Result<std::string> text = read_file(path, kMaxSvgBytes);
  if (!text) return tl::unexpected(text.error());
  Result<SvgDrawing> drawing = parse_svg(*text);
  if (drawing) return drawing;
  return tl::unexpected(with_context(drawing.error(), path == "-" ? "stdin" : path));
}

}  // namespace felt
