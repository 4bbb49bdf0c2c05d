#include "felt/io/xopp/xopp_import.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "felt/io/drawing_builder.h"
#include "felt/io/ink_of_points.h"
#include "felt/io/number_list.h"
#include "felt/io/unpack.h"
#include "felt/io/xml/xml_input.h"
#include "felt/stroke/color_text.h"

namespace felt {
namespace {

using Next = NumberList::Next;

/// The newest version of the format that this reader supports completely.
constexpr double kKnownVersion = 5.0;
constexpr double kA4WidthPt = 595.27559, kA4HeightPt = 841.88976;
constexpr double kUsualWidthPt = 1.41;  // the medium pen of Xournal++
constexpr Rgba kWhite{255, 255, 255, 255};

struct ColorName {
  std::string_view name;
  Rgba color;
};
/// Names of colours in files of Xournal. The last five are colours of paper.
constexpr std::array kXoppColors = {ColorName{"black", {0x00, 0x00, 0x00, 255}},
                                    ColorName{"blue", {0x33, 0x33, 0xcc, 255}},
                                    ColorName{"red", {0xff, 0x00, 0x00, 255}},
                                    ColorName{"green", {0x00, 0x80, 0x00, 255}},
                                    ColorName{"gray", {0x80, 0x80, 0x80, 255}},
                                    ColorName{"lightblue", {0x00, 0xc0, 0xff, 255}},
                                    ColorName{"lightgreen", {0x00, 0xff, 0x00, 255}},
                                    ColorName{"magenta", {0xff, 0x00, 0xff, 255}},
                                    ColorName{"orange", {0xff, 0x80, 0x00, 255}},
                                    ColorName{"yellow", {0xff, 0xff, 0x00, 255}},
                                    ColorName{"white", {0xff, 0xff, 0xff, 255}},
                                    ColorName{"pink", {0xff, 0xc0, 0xd4, 255}}};
constexpr std::array kPaperColors = {
    ColorName{"blue", {0xa0, 0xe8, 0xff, 255}}, ColorName{"green", {0x80, 0xff, 0xc0, 255}},
    ColorName{"orange", {0xff, 0xc0, 0x80, 255}}, ColorName{"yellow", {0xff, 0xff, 0x80, 255}}};
constexpr std::uint8_t kHighlighterAlpha = 0x7f;

template <std::size_t n>
std::optional<Rgba> named_color(const std::array<ColorName, n>& names, std::string_view name) {
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const auto& c) { return c.name == name; });
  return found == names.end() ? std::nullopt : std::optional(found->color);
}

class XoppReader {
 public:
  XoppReader(const XmlInput& input, const ImportOptions& options)
      : input_(input), ink_(solid_fit(options.fit)) {}

  Result<Imported> read() {
    const pugi::xml_node root = input_.root();
    if (std::string_view(root.name()) != "xournal") {
      return fail(ErrorCode::kInvalidData,
                  "line " + std::to_string(input_.line_of(root)) +
                      ": not a Xournal++ document: the first element is '" + root.name() + "'");
    }
    double version = 0.0;
    if (single_number(root.attribute("fileversion").value(), version) && version > kKnownVersion) {
      notice(root, "has a newer version than Feltline supports; the known parts were read");
    }
    several_pages_ = false;
    int pages = 0;
    for (const pugi::xml_node& node : root.children("page")) {
      static_cast<void>(node);
      several_pages_ = ++pages > 1;
    }
    for (const pugi::xml_node& node : root.children()) {
      if (node.type() != pugi::node_element) continue;
      const std::string_view name = node.name();
      if (name == "page") {
        read_page(node);
      } else if (name != "title" && name != "preview") {
        notice(node, "is unknown and was skipped");
      }
    }
    finish_page(root);
    if (builder_.layer_count() == 0) builder_.add_layer({});
    if (const int others = input_.other_roots(); others > 0) {
      notice(root, "ends before the file does; the documents after it (" + std::to_string(others) +
                       ") were skipped");
    }
    return Imported{std::move(builder_).build(), std::move(report_)};
  }

 private:
  void notice(const pugi::xml_node& node, std::string what) {
    report_.add(input_.line_of(node), XmlInput::describe(node), std::move(what));
  }

  void read_page(const pugi::xml_node& page) {
    ++page_number_;
    double width_pt = 0.0, height_pt = 0.0;
    if (!single_number(page.attribute("width").value(), width_pt) ||
        !single_number(page.attribute("height").value(), height_pt) || !(width_pt > 0.0) ||
        !(height_pt > 0.0)) {
      notice(page, "has no size; A4 was assumed");
      width_pt = kA4WidthPt;
      height_pt = kA4HeightPt;
    }
    if (page_number_ > 1) top_mm_ = bottom_mm_ + kPageGapMm;
    bottom_mm_ = top_mm_ + height_pt * kMmPerPoint;
    width_mm_ = std::max(width_mm_, width_pt * kMmPerPoint);
    int layer_number = 0;
    for (const pugi::xml_node& node : page.children()) {
      if (node.type() != pugi::node_element) continue;
      const std::string_view name = node.name();
      if (name == "background") {
        read_background(node);
      } else if (name == "layer") {
        read_layer(node, ++layer_number);
      } else {
        notice(node, "is unknown and was skipped");
      }
    }
  }

  void read_background(const pugi::xml_node& node) {
    const std::string_view type = node.attribute("type").value();
    const std::string_view style = node.attribute("style").value();
    if (type != "solid") {
      notice(node, "of type '" + std::string(type) + "' is a picture and was skipped");
      return;
    }
    if (!style.empty() && style != "plain") {
      notice(node, "of style '" + std::string(style) + "': its lines were skipped");
    }
    const std::string_view text = node.attribute("color").value();
    std::optional<Rgba> color = named_color(kPaperColors, text);
    if (!color) color = color_of(text);
    if (!color) {
      notice(node, "has an unknown colour; white was used");
      color = kWhite;
    }
    if (!paper_) {
      paper_ = color;
    } else if (*paper_ != *color) {
      notice(node, "has a different colour from the first page; the first page's colour was used");
    }
  }

  void read_layer(const pugi::xml_node& node, int number) {
    std::string label = node.attribute("name").value();
    if (label.size() > limits::kMaxNameBytes) {
      notice(node, "has a name of more than 4096 bytes, which was skipped");
      label.clear();
    }
    if (label.empty()) label = "Layer " + std::to_string(number);
    if (several_pages_) label = "Page " + std::to_string(page_number_) + ": " + label;
    std::vector<Stroke> strokes;
    for (const pugi::xml_node& child : node.children()) {
      if (child.type() != pugi::node_element) continue;
      const std::string_view name = child.name();
      if (name == "stroke") {
        read_stroke(child, strokes);
      } else if (name == "text" || name == "link") {
        notice(child, "is text, not a stroke, and was skipped");
      } else if (name == "image" || name == "teximage") {
        notice(child, "is a picture and was skipped");
      } else {
        notice(child, "is unknown and was skipped");
      }
    }
    // If there are several pages, a page without ink gets no layer.
    if (several_pages_ && strokes.empty()) return;
    const std::size_t layer = builder_.add_layer({std::move(label)});
    for (Stroke& stroke : strokes) builder_.add(layer, std::move(stroke));
  }

  static std::optional<Rgba> color_of(std::string_view text) {
    if (const std::optional<Rgba> color = named_color(kXoppColors, text)) return color;
    return color_from_text(text);
  }

  void read_stroke(const pugi::xml_node& node, std::vector<Stroke>& strokes) {
    read_points(node);
    if (line_.empty()) {
      notice(node, "has no points and was skipped");
      return;
    }
    read_widths(node);
    Result<StrokeData> data = ink_.of_line(line_);
    if (!data) {
      notice(node, data.error().message);
      return;
    }
    data->color = stroke_color(node);
    note_what_is_lost(node);
    Result<Stroke> stroke = Stroke::create(*std::move(data));
    if (!stroke) {
      notice(node, "was skipped: " + stroke.error().message);
      return;
    }
    strokes.push_back(*std::move(stroke));
  }

  Rgba stroke_color(const pugi::xml_node& node) {
    const std::string_view text = node.attribute("color").value();
    std::optional<Rgba> color = color_of(text);
    if (!color) {
      notice(node, "has an unknown colour; black was used");
      color = Rgba{};
    }
    const bool says_alpha = text.size() == 9;
    if (!says_alpha && std::string_view(node.attribute("tool").value()) == "highlighter") {
      color->a = kHighlighterAlpha;
    }
    return *color;
  }

  void note_what_is_lost(const pugi::xml_node& node) {
    const std::string_view tool = node.attribute("tool").value();
    const std::string_view style = node.attribute("style").value();
    const std::string_view cap = node.attribute("capStyle").value();
    if (tool == "eraser") {
      notice(node, "of the white-out eraser was read as ink of its colour");
    } else if (tool != "pen" && tool != "highlighter") {
      notice(node, "of an unknown tool was read as a pen's");
    }
    if (!style.empty() && style != "plain") notice(node, "is no longer dashed");
    if (node.attribute("fill")) notice(node, "lost the fill of its area");
    if (cap == "butt" || cap == "square") notice(node, "got round ends");
  }

  /// Reads the points of a stroke, in mm on the page, without widths.
  void read_points(const pugi::xml_node& node) {
    line_.clear();
    const std::string text = xml_text_of(node);
    NumberList numbers(text);
    double x = 0.0, y = 0.0;
    Next x_is = numbers.next(x), y_is = x_is;
    for (; x_is == Next::kNumber; x_is = numbers.next(x)) {
      y_is = numbers.next(y);
      if (y_is != Next::kNumber) break;
      line_.push_back({{x * kMmPerPoint, top_mm_ + y * kMmPerPoint}, 0.0});
    }
    if (x_is == Next::kBad || y_is == Next::kBad) {
      notice(node, "contains something that is not a number; only the points before it were read");
    } else if (x_is == Next::kNumber) {
      notice(node, "has a last point without y, which was skipped");
    }
  }

  /// Reads the widths: one for the whole stroke, then one for each piece between two points. The
  /// width at a point is the mean of the widths of the two pieces that meet there, so the width
  /// profile passes through the middle of each step.
  void read_widths(const pugi::xml_node& node) {
    const std::string_view text = node.attribute("width").value();
    double nominal_pt = 0.0;
    NumberList numbers(text);
    Next next = numbers.next(nominal_pt);
    if (next != Next::kNumber || !(nominal_pt > 0.0)) {
      notice(node, "has no width; the default width was used");
      nominal_pt = kUsualWidthPt;
      next = Next::kEnd;
    }
    pieces_.clear();
    if (next != Next::kEnd) read_pieces(numbers);
    if (pieces_.empty()) {  // MrWriter stores widths as pressures
      NumberList pressures(node.attribute("pressures").value());
      read_pieces(pressures);
    }
    mend_pieces(node);
    if (pieces_.size() + 1 < line_.size()) {
      if (!pieces_.empty()) notice(node, "has too few widths; a single width was used");
      pieces_.clear();
    }
    for (std::size_t i = 0; i < line_.size(); ++i) {
      line_[i].width_mm = kMmPerPoint * (pieces_.empty() ? nominal_pt : width_at(i, nominal_pt));
    }
  }

  /// Appends the widths of a list to pieces_. A word that is not a positive number is 0: unknown.
  void read_pieces(NumberList& list) {
    double width_pt = 0.0;
    for (Next next = list.next(width_pt); next != Next::kEnd; next = list.next(width_pt)) {
      const bool is_known = next == Next::kNumber && width_pt > 0.0;
      pieces_.push_back(is_known ? width_pt : 0.0);
      if (next == Next::kBad) list.skip();
    }
  }

  /// Gives the pieces without a width the width of the nearest piece before them that has one, or
  /// after them at the start. If no piece has one, the stroke has a single width.
  void mend_pieces(const pugi::xml_node& node) {
    const auto unknown = std::count(pieces_.begin(), pieces_.end(), 0.0);
    if (unknown == 0) return;
    const auto known =
        std::find_if(pieces_.begin(), pieces_.end(), [](double w) { return w > 0.0; });
    if (known == pieces_.end()) {
      notice(node, "has no known widths of its pieces; a single width was used");
      pieces_.clear();
      return;
    }
    notice(node, "has widths that are not positive numbers (" + std::to_string(unknown) +
                     "); those of the pieces beside them were used");
    double width_pt = *known;
    for (double& piece : pieces_) {
      if (piece > 0.0) width_pt = piece;
      piece = width_pt;
    }
  }

  [[nodiscard]] double width_at(std::size_t i, double nominal_pt) const {
    if (line_.size() == 1) return nominal_pt;
    const std::size_t last = line_.size() - 2;
    if (i == 0) return pieces_.front();
    return i > last ? pieces_[last] : 0.5 * (pieces_[i - 1] + pieces_[i]);
  }

  void finish_page(const pugi::xml_node& root) {
    if (page_number_ == 0) {
      notice(root, "has no page");
      return;
    }
    Page page;
    const auto within = [](double v) { return std::clamp(v, Page::kMinMm, Page::kMaxMm); };
    page.width_mm = within(width_mm_);
    page.height_mm = within(bottom_mm_);
    page.paper = paper_.value_or(kWhite);
    if (width_mm_ > Page::kMaxMm || bottom_mm_ > Page::kMaxMm) {
      notice(root, "is larger than a page can be (5000 mm); the rest lies outside the page");
    }
    builder_.drawing().page = page;
    builder_.drawing().has_page = true;
  }

  const XmlInput& input_;
  InkOfPoints ink_;
  DrawingBuilder builder_;
  ImportReport report_;
  bool several_pages_ = false;
  int page_number_ = 0;
  double top_mm_ = 0.0, bottom_mm_ = 0.0, width_mm_ = 0.0;
  std::optional<Rgba> paper_;
  std::vector<WidePoint> line_;  // buffers of one stroke
  std::vector<double> pieces_;
};

/// Returns the XML of a document, unpacked if necessary.
Result<std::string> unpacked(std::string_view bytes) {
  if (is_gzip(bytes)) return gunzip(bytes);
  if (!is_zip(bytes)) return std::string(bytes);
  const Result<std::string> kind = file_in_zip(bytes, "mimetype");
  if (!kind) return kind;
  if (kind->find("application/xournal++") == std::string::npos) {
    return fail(ErrorCode::kInvalidData, "is a zip archive, but not by Xournal++");
  }
  return file_in_zip(bytes, "content.xml");
}

}  // namespace

Result<Imported> import_xopp(std::string_view bytes, const ImportOptions& options) {
  if (bytes.size() > limits::kMaxImportBytes) {
    return fail(ErrorCode::kLimitExceeded, "is larger than 256 MiB");
  }
  Result<std::string> text = unpacked(bytes);
  if (!text) return tl::unexpected(text.error());
  const Result<XmlInput> input = XmlInput::parse(*text);
  if (!input) return tl::unexpected(input.error());
  *text = {};
  return XoppReader(*input, options).read();
}

}  // namespace felt
