// Any bytes must give an error with a message, or a drawing that is equal after writing it as SVG
// and reading it. Half of the mutations follow the grammar of SVG: they copy, move, wrap and repeat
// elements, and give attributes values of the right kind (path data, transforms, colours, lengths,
// style sheets, Feltline's own attributes). Pictures may be in the file, or in one of two files
// next to it; JPEG pictures are "converted".
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <pugixml.hpp>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "felt/base/atomic_file.h"
#include "felt/base/base64.h"
#include "felt/document/visible_strokes.h"
#include "felt/io/svg/svg_import.h"
#include "felt/io/svg/svg_writer.h"

// Only the libFuzzer program defines this function; the replay program does not mutate inputs.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                              std::size_t max_size);

namespace {

void must(bool condition) {
  if (!condition) std::abort();
}

/// A PNG picture of 2 x 1 pixels.
constexpr const char* kPng =
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAADklEQVR42mP4z8AAQv8BD/kD/"
    "Zh51wAAAAAASUVORK5C"
    "YII=";

/// A folder with the pictures "a.png" and "b/a.jpg". It is removed when the program ends.
class PictureFolder {
 public:
  PictureFolder() {
    must(::mkdtemp(path_.data()) != nullptr);
    std::filesystem::create_directory(path_ + "/b");
    must(felt::write_file(path_ + "/a.png", felt::base64_bytes(kPng).value()).has_value());
    must(felt::write_file(path_ + "/b/a.jpg", "\xff\xd8\xff").has_value());
  }
  ~PictureFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  PictureFolder(const PictureFolder&) = delete;
  PictureFolder& operator=(const PictureFolder&) = delete;

  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  std::string path_ = (std::filesystem::temp_directory_path() / "felt-fuzz-XXXXXX").string();
};

/// Returns options to import a file of the folder, as a program with a window sets them.
const felt::ImportOptions& import_options() {
  static const PictureFolder folder;
  static const felt::ImportOptions options = [] {
    felt::ImportOptions o;
    o.folder = folder.path();
    o.to_png = [](std::string_view, std::int64_t max_pixels) -> felt::Result<std::string> {
      if (max_pixels < 2) return felt::fail(felt::ErrorCode::kLimitExceeded, "too large");
      return felt::base64_bytes(kPng).value();
    };
    return o;
  }();
  return options;
}

/// Returns true if the document is so small that its outlines are computed quickly, and so near
/// that a page around its ink has the same size when it is read again.
bool is_handy(const felt::Document& document) {
  std::size_t segments = 0;
  for (const felt::Layer& layer : document.layers()) {
    for (const felt::StrokeId id : layer.strokes) {
      segments += static_cast<std::size_t>(document.find(id)->segment_count());
    }
  }
  const felt::Rect r = felt::ink_bounds(document, felt::LayerChoice::kAll);
  const double farthest = r.empty() ? 0.0 : std::max({-r.x0, -r.y0, r.x1, r.y1});
  return segments < 200 && farthest < 1e4;
}

using Random = std::mt19937;

template <class List>
const char* one_of(const List& list, Random& random) {
  return list[random() % std::size(list)];
}

std::string number(Random& random) {
  constexpr std::array<const char*, 10> kOdd{"0",    "-0", "1e9", "-1e9", "1e400",
                                             "1e-9", ".5", "1e",  "0.05", "999999999999"};
  if (random() % 8 == 0) return one_of(kOdd, random);
  return std::to_string(static_cast<int>(random() % 4000) - 1000) +
         (random() % 2 == 0 ? "e-1" : "");
}

std::string numbers(Random& random, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += number(random) + (random() % 3 == 0 ? "," : " ");
  return text;
}

std::string path_data(Random& random) {
  constexpr std::array<const char*, 20> kCommands{"M", "m", "L", "l", "H", "h", "V", "v", "C", "c",
                                                  "S", "s", "Q", "q", "T", "t", "A", "a", "Z", "z"};
  std::string text = "M" + numbers(random, 2);
  for (std::size_t n = random() % 8; n > 0; --n) {
    text += one_of(kCommands, random) + numbers(random, random() % 8);
  }
  return text;
}

std::string transform(Random& random) {
  constexpr std::array<const char*, 7> kNames{"matrix", "translate", "scale", "rotate",
                                              "skewX",  "skewY",     "none"};
  std::string text;
  for (std::size_t n = 1 + random() % 3; n > 0; --n) {
    text += std::string(one_of(kNames, random)) + "(" + numbers(random, random() % 7) + ") ";
  }
  return text;
}

std::string length(Random& random) {
  constexpr std::array<const char*, 10> kUnits{"",   "px", "mm", "%",   "em",
                                               "in", "pt", "vw", "rem", "?"};
  return number(random) + one_of(kUnits, random);
}

std::string color(Random& random) {
  constexpr std::array<const char*, 12> kColors{
      "none",    "red",         "#abc",         "#12345678", "rgb(1,2,3)",      "hsl(9,9%,9%)",
      "url(#a)", "url(#b) red", "currentColor", "inherit",   "rgba(1,2,3,50%)", "hsla(1turn"};
  return one_of(kColors, random);
}

std::string style_sheet(Random& random) {
  constexpr std::array<const char*, 14> kParts{
      "*",         " path",    ">g",           "+rect", "~use",       "#a",
      ".b",        "[x^='y']", ":first-child", ",",     "{fill:red}", "{stroke:blue!important}",
      "@media x{", "/* */"};
  std::string text;
  for (std::size_t n = random() % 12; n > 0; --n) text += one_of(kParts, random);
  return text;
}

std::string knots(Random& random) {
  std::string text;
  for (std::size_t n = random() % 5; n > 0; --n) {
    text += number(random) + "," + number(random) + (random() % 2 == 0 ? " | " : " ");
  }
  return text;
}

std::string fill_pieces(Random& random) {
  std::string text = number(random);
  for (std::size_t loops = random() % 4; loops > 0; --loops) {
    text += ';';
    for (std::size_t n = random() % 4; n > 0; --n) {
      text += random() % 3 == 0 ? "-" : numbers(random, 2 + random() % 2);
      if (n > 1) text += ',';
    }
  }
  return text;
}

std::string picture_name(Random& random) {
  constexpr std::array<const char*, 8> kNames{
      "a.png",   "./a.png",  "%61.png",  "b/../a.png",
      "b/a.jpg", "none.png", "../a.png", "data:image/jpeg;base64,/9j/4AAQSkZJRg=="};
  if (random() % 2 == 0) return std::string("data:image/png;base64,") + kPng;
  return one_of(kNames, random);
}

std::string style(Random& random) {
  std::string text;
  if (random() % 2 == 0) text += "mix-blend-mode:multiply;";
  if (random() % 2 == 0) text += "opacity:0.5;";
  if (random() % 2 == 0) text += "fill:" + color(random) + ";stroke-width:" + length(random);
  return text;
}

/// Returns a random value of the kind that the attribute `name` needs.
std::string value_for(const std::string& name, Random& random) {
  constexpr std::array<const char*, 4> kIds{"a", "b", "c", ""};
  constexpr std::array<const char*, 8> kWords{"smooth corner", "true", "none",  "layer",
                                              "visible",       "1",    "round", "powerstroke"};
  if (name == "d" || name == "inkscape:original-d") return path_data(random);
  if (name == "points" || name == "viewBox" || name == "stroke-dasharray" || name == "felt:tones") {
    return numbers(random, random() % 9);
  }
  if (name == "transform") return transform(random);
  if (name == "fill" || name == "stroke" || name == "color") return color(random);
  if (name == "id" || name == "class") return one_of(kIds, random);
  if (name == "href" && random() % 2 == 0) return picture_name(random);
  if (name == "preserveAspectRatio") return random() % 2 == 0 ? "none" : "xMinYMax slice";
  if (name == "href" || name == "inkscape:path-effect") {
    return std::string("#") + one_of(kIds, random);
  }
  if (name == "style") return style(random);
  if (name == "mix-blend-mode") return random() % 4 == 0 ? "screen" : "multiply";
  if (name == "opacity" && random() % 2 == 0) return "0.5";
  if (name == "inkscape:groupmode" && random() % 4 != 0) return "layer";
  if (name == "felt:fill") return fill_pieces(random);
  if (name == "fill-rule") return random() % 2 == 0 ? "evenodd" : "nonzero";
  if (name == "offset_points" || name == "felt:widths") return knots(random);
  return random() % 2 == 0 ? length(random) : std::string(one_of(kWords, random));
}

constexpr std::array<const char*, 18> kElements{"g",        "path",
                                                "rect",     "circle",
                                                "ellipse",  "line",
                                                "polyline", "polygon",
                                                "svg",      "use",
                                                "defs",     "symbol",
                                                "switch",   "linearGradient",
                                                "stop",     "inkscape:path-effect",
                                                "style",    "image"};
constexpr std::array<const char*, 46> kAttributes{"d",
                                                  "points",
                                                  "x",
                                                  "y",
                                                  "width",
                                                  "height",
                                                  "rx",
                                                  "ry",
                                                  "r",
                                                  "cx",
                                                  "cy",
                                                  "x1",
                                                  "y2",
                                                  "transform",
                                                  "transform-origin",
                                                  "viewBox",
                                                  "preserveAspectRatio",
                                                  "fill",
                                                  "stroke",
                                                  "stroke-width",
                                                  "stroke-dasharray",
                                                  "stroke-dashoffset",
                                                  "stroke-linecap",
                                                  "opacity",
                                                  "display",
                                                  "visibility",
                                                  "id",
                                                  "class",
                                                  "style",
                                                  "href",
                                                  "inkscape:original-d",
                                                  "inkscape:path-effect",
                                                  "inkscape:groupmode",
                                                  "offset_points",
                                                  "effect",
                                                  "felt:widths",
                                                  "felt:tones",
                                                  "felt:joints",
                                                  "felt:closed",
                                                  "felt:fill",
                                                  "fill-rule",
                                                  "fill-opacity",
                                                  "opacity",
                                                  "preserveAspectRatio",
                                                  "mix-blend-mode",
                                                  "inkscape:groupmode"};

std::vector<pugi::xml_node> elements_of(const pugi::xml_document& document) {
  std::vector<pugi::xml_node> open{document.document_element()}, all;
  while (!open.empty() && all.size() < 1000) {
    const pugi::xml_node node = open.back();
    open.pop_back();
    all.push_back(node);
    for (const pugi::xml_node child : node.children()) {
      if (child.type() == pugi::node_element) open.push_back(child);
    }
  }
  return all;
}

void set_attribute(pugi::xml_node node, Random& random) {
  const std::string name = one_of(kAttributes, random);
  pugi::xml_attribute attribute = node.attribute(name.c_str());
  if (!attribute) attribute = node.append_attribute(name.c_str());
  attribute.set_value(value_for(name, random).c_str());
  pugi::xml_node root = node.root().find_child(
      [](pugi::xml_node child) { return child.type() == pugi::node_element; });
  if (name.starts_with("inkscape:") && !root.attribute("xmlns:inkscape")) {
    root.append_attribute("xmlns:inkscape") = "http://www.inkscape.org/namespaces/inkscape";
  }
}

void mutate(pugi::xml_document& document, Random& random) {
  const std::vector<pugi::xml_node> all = elements_of(document);
  pugi::xml_node node = all[random() % all.size()], other = all[random() % all.size()];
  const pugi::xml_node root = document.document_element();
  switch (random() % 8) {
    case 0:
      if (node != root) node.parent().remove_child(node);
      break;
    case 1:
      if (all.size() < 300) other.append_copy(node);
      break;
    case 2: {
      pugi::xml_node made = node.append_child(one_of(kElements, random));
      for (std::size_t n = random() % 5; n > 0; --n) set_attribute(made, random);
      if (std::strcmp(made.name(), "style") == 0) made.text().set(style_sheet(random).c_str());
      break;
    }
    case 3:
      node.set_name(one_of(kElements, random));
      if (node == root) node.set_name("svg");
      break;
    case 4:
      if (node.first_attribute()) node.remove_attribute(node.first_attribute());
      break;
    default:
      set_attribute(node, random);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const felt::Result<felt::Imported> read = felt::import_svg(bytes, import_options());
  if (!read) {
    must(!read.error().message.empty());
    return 0;
  }
  for (const felt::ImportNotice& notice : read->report.notices()) must(!notice.what.empty());
  if (!is_handy(read->drawing.document)) return 0;
  const felt::Result<std::string> text = felt::svg_text(read->drawing, {});
  must(text.has_value());
  const felt::Result<felt::Imported> again = felt::import_svg(*text);
  must(again.has_value());
  must(again->drawing == read->drawing);
  must(again->report.empty());
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t max_size, unsigned int seed) {
  Random random(seed);
  pugi::xml_document document;
  const bool is_xml = static_cast<bool>(document.load_buffer(data, size));
  if (is_xml && document.document_element() && random() % 4 != 0) {
    for (std::size_t n = 1 + random() % 4; n > 0; --n) mutate(document, random);
    std::ostringstream out;
    document.save(out, "", pugi::format_raw);
    const std::string text = out.str();
    if (text.size() <= max_size && !text.empty()) {
      std::memcpy(data, text.data(), text.size());
      return text.size();
    }
  }
  return LLVMFuzzerMutate != nullptr ? LLVMFuzzerMutate(data, size, max_size) : size;
}
