#include "felt/io/inkml/inkml_writer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "felt/io/inkml/inkml_model.h"
#include "felt/io/limits.h"
#include "felt/io/xml/xml_text.h"
#include "felt/stroke/color_text.h"
#include "felt/stroke/edit/corner_trips.h"
#include "felt/stroke/outline/outline.h"

namespace felt {
namespace {

// Appends a length in mm, rounded to the grid, so that a reader computes the same trace_sum.
void append_step(std::string& out, double mm) {
  const double on_grid = std::round(mm * inkml::kStepsPerMm) / inkml::kStepsPerMm;
  std::array<char, 40> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(),
                                 on_grid == 0.0 ? 0.0 : on_grid, std::chars_format::fixed)
                       .ptr;
  out.append(text.data(), end);
}

/// Part 0 is the head with the definitions. The other parts contain the strokes. The first part of
/// a layer also contains the start tag of the layer, and the last part its end tag.
class InkmlParts final : public DrawingParts {
 public:
  explicit InkmlParts(const Drawing& drawing)
      : drawing_(drawing),
        document_(drawing.document),
        names_(drawing),
        ranges_(stroke_ranges(drawing.document, LayerChoice::kAll)) {}

  Result<void> begin(const std::optional<Rgba>& paper) {
    head_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ink xmlns=\"";
    head_ += inkml::kInkmlNamespace;
    head_ += "\" xmlns:felt=\"";
    head_ += inkml::kFeltNamespace;
    head_ += '"';
    if (auto ok = inkml::append_page(head_, drawing_, paper); !ok) return ok;
    head_ += ">\n";
    add_definitions();
    return {};
  }

  [[nodiscard]] std::size_t count() const override { return ranges_.size() + 1; }

  Result<void> make(std::size_t i, DrawingPart& out) const override {
    out.clear();
    if (i == 0) {
      out.bytes = head_;
      return {};
    }
    const StrokeRange& range = ranges_[i - 1];
    const Layer& layer = document_.layers()[range.layer];
    if (range.first == 0) {
      if (auto ok = append_layer(out.bytes, layer); !ok) return ok;
    }
    Buffers buffers;
    for (std::size_t k = range.first; k < range.last; ++k) {
      const StrokeId id = layer.strokes[k];
      const std::string number = std::to_string(range.before + (k - range.first) + 1);
      if (auto ok = append(out.bytes, id, number, buffers); !ok) {
        return tl::unexpected(with_context(ok.error(), "stroke " + number));
      }
    }
    if (range.last == layer.strokes.size()) out.bytes += "</traceGroup>\n";
    return {};
  }

  std::string tail() override { return "</ink>\n"; }

 private:
  struct Buffers {
    std::vector<Dab> dabs{};
    std::vector<WidePoint> trace{};
  };

  void add_definitions() {
    head_ +=
        "<definitions>\n<context xml:id=\"mm\">\n<inkSource xml:id=\"felt\">\n<traceFormat>\n"
        "<channel name=\"X\" type=\"decimal\" units=\"mm\"/>\n"
        "<channel name=\"Y\" type=\"decimal\" units=\"mm\"/>\n"
        "<channel name=\"W\" type=\"decimal\" units=\"mm\"/>\n</traceFormat>\n</inkSource>\n"
        "</context>\n";
    for (const Layer& layer : document_.layers()) {
      for (const StrokeId id : layer.strokes) add_brush(document_.find(id)->color());
    }
    head_ += "</definitions>\n";
  }

  void add_brush(Rgba color) {
    const std::array key = {color.r, color.g, color.b, color.a};
    const auto [place, is_new] = brushes_.emplace(key, static_cast<int>(brushes_.size()) + 1);
    if (!is_new) return;
    head_ += "<brush xml:id=\"b" + std::to_string(place->second) +
             "\">\n<brushProperty name=\"color\" value=\"" +
             color_to_text({color.r, color.g, color.b, 255}) + "\"/>\n";
    if (color.a != 255) {
      head_ += "<brushProperty name=\"transparency\" value=\"" + std::to_string(255 - color.a) +
               "\"/>\n";
    }
    head_ += "</brush>\n";
  }

  /// Appends the attributes of a layer or of a group of layers.
  template <class State>
  static void append_look(std::string& out, const State& state, const std::string& prefix) {
    const auto attribute = [&](const char* name, std::string_view value) {
      out += " felt:" + prefix + name + "=\"";
      out += value;
      out += '"';
    };
    if (!state.visible) attribute("visible", "false");
    if (state.locked) attribute("locked", "true");
    if (state.opacity < 1.0) {
      std::array<char, 32> number{};
      const auto end = std::to_chars(number.begin(), number.end(), state.opacity).ptr;
      attribute("opacity", std::string(number.data(), end));
    }
    if (state.blend != BlendMode::kNormal) attribute("blend", blend_mode_name(state.blend));
  }

  static Result<void> append_layer(std::string& out, const Layer& layer) {
    if (layer.name.size() > limits::kMaxNameBytes) {
      return fail(ErrorCode::kLimitExceeded,
                  "a layer's name of more than 4096 bytes cannot be written");
    }
    out += "<traceGroup contextRef=\"#mm\" felt:layer=\"";
    if (auto ok = append_xml_attribute(out, layer.name); !ok) {
      return tl::unexpected(with_context(ok.error(), "a layer's name"));
    }
    out += '"';
    append_look(out, layer.state(), "");
    if (layer.group) {
      out += " felt:group=\"" + std::to_string(layer.group->id.value) + "\" felt:group-name=\"";
      if (auto ok = append_xml_attribute(out, layer.group->name); !ok) {
        return tl::unexpected(with_context(ok.error(), "the name of a group of layers"));
      }
      out += '"';
      append_look(out, *layer.group, "group-");
    }
    out += ">\n";
    return {};
  }

  Result<void> append(std::string& out, StrokeId id, const std::string& number,
                      Buffers& buffers) const {
    const Stroke& stroke = *document_.find(id);
    const Rgba c = stroke.color();
    auto& [dabs, trace] = buffers;
    trace.clear();
    // Other programs would draw the trips into flat ends and corners as lines.
    const std::optional<Stroke> plain = without_corner_trips(stroke);
    flatten(plain ? *plain : stroke, kTraceToleranceMm, dabs);
    for (const Dab& dab : dabs) trace.push_back({dab.center, 2.0 * dab.radius_mm});
    out += "<trace xml:id=\"t" + number + "\" brushRef=\"#b" +
           std::to_string(brushes_.at({c.r, c.g, c.b, c.a})) + '"';
    const auto [name, own_number] = names_.of(id);
    if (auto ok = inkml::append_model(out, name, own_number, stroke, trace); !ok) return ok;
    out += '>';
    for (std::size_t i = 0; i < trace.size(); ++i) {
      if (i > 0) out += ", ";
      append_step(out, trace[i].position.x);
      out += ' ';
      append_step(out, trace[i].position.y);
      out += ' ';
      append_step(out, trace[i].width_mm);
    }
    out += "</trace>\n";
    return {};
  }

  const Drawing& drawing_;
  const Document& document_;
  XmlStrokeNames names_;
  std::vector<StrokeRange> ranges_;
  std::string head_;
  std::map<std::array<std::uint8_t, 4>, int> brushes_;
};

}  // namespace

Result<std::unique_ptr<DrawingParts>> inkml_parts(const Drawing& drawing,
                                                  const std::optional<Rgba>& paper) {
  auto parts = std::make_unique<InkmlParts>(drawing);
  if (auto ok = parts->begin(paper); !ok) return tl::unexpected(ok.error());
  return parts;
}

Result<std::string> inkml_text(const Drawing& drawing) {
  const Result<std::unique_ptr<DrawingParts>> parts = inkml_parts(drawing);
  if (!parts) return tl::unexpected(parts.error());
  return bytes_of(**parts);
}

}  // namespace felt
