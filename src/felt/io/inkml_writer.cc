#include "felt/io/inkml_writer.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "felt/io/inkml_model.h"
#include "felt/io/limits.h"
#include "felt/io/xml_text.h"
#include "felt/stroke/color_text.h"
#include "felt/stroke/flatten.h"

namespace felt {
namespace {

class InkmlText {
 public:
  Result<std::string> write(const LayeredSketch& drawing) {
    out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ink xmlns=\"";
    out_ += inkml::kInkmlNamespace;
    out_ += "\" xmlns:felt=\"";
    out_ += inkml::kFeltNamespace;
    out_ += '"';
    if (auto ok = inkml::append_sheet(out_, drawing); !ok) return tl::unexpected(ok.error());
    out_ += ">\n";
    definitions(drawing);
    for (const SketchLayer& layer : drawing.layers) {
      if (auto ok = add(layer); !ok) return tl::unexpected(ok.error());
    }
    out_ += "</ink>\n";
    return std::move(out_);
  }

 private:
  void definitions(const LayeredSketch& drawing) {
    out_ +=
        "<definitions>\n<context xml:id=\"mm\">\n<inkSource xml:id=\"felt\">\n<traceFormat>\n"
        "<channel name=\"X\" type=\"decimal\" units=\"mm\"/>\n"
        "<channel name=\"Y\" type=\"decimal\" units=\"mm\"/>\n"
        "<channel name=\"W\" type=\"decimal\" units=\"mm\"/>\n</traceFormat>\n</inkSource>\n"
        "</context>\n";
    for (const SketchLayer& layer : drawing.layers) {
      for (const SketchStroke& s : layer.strokes) add_brush(s.stroke.color());
    }
    out_ += "</definitions>\n";
  }

  void add_brush(Rgba color) {
    const std::array key = {color.r, color.g, color.b, color.a};
    const auto [place, is_new] = brushes_.emplace(key, static_cast<int>(brushes_.size()) + 1);
    if (!is_new) return;
    out_ += "<brush xml:id=\"b" + std::to_string(place->second) +
            "\">\n<brushProperty name=\"color\" value=\"" +
            color_to_text({color.r, color.g, color.b, 255}) + "\"/>\n";
    if (color.a != 255) {
      out_ += "<brushProperty name=\"transparency\" value=\"" + std::to_string(255 - color.a) +
              "\"/>\n";
    }
    out_ += "</brush>\n";
  }

  Result<void> add(const SketchLayer& layer) {
    if (layer.name.size() > limits::kMaxNameBytes) {
      return fail(ErrorCode::kLimitExceeded,
                  "a layer's name of more than 4096 bytes cannot be written");
    }
    out_ += "<traceGroup contextRef=\"#mm\" felt:layer=\"";
    if (auto ok = append_xml_attribute(out_, layer.name); !ok) {
      return tl::unexpected(with_context(ok.error(), "a layer's name"));
    }
    out_ += '"';
    if (!layer.visible) out_ += " felt:visible=\"false\"";
    if (layer.locked) out_ += " felt:locked=\"true\"";
    out_ += ">\n";
    for (const SketchStroke& s : layer.strokes) {
      if (auto ok = add(s); !ok) {
        return tl::unexpected(with_context(ok.error(), "stroke " + std::to_string(trace_count_)));
      }
    }
    out_ += "</traceGroup>\n";
    return {};
  }

  Result<void> add(const SketchStroke& s) {
    ++trace_count_;
    const Rgba c = s.stroke.color();
    trace_.clear();
    flatten(s.stroke, kTraceToleranceMm, dabs_);
    for (const Dab& dab : dabs_) trace_.push_back({dab.center, 2.0 * dab.radius_mm});
    out_ += "<trace xml:id=\"t" + std::to_string(trace_count_) + "\" brushRef=\"#b" +
            std::to_string(brushes_.at({c.r, c.g, c.b, c.a})) + '"';
    if (auto ok = inkml::append_model(out_, s, trace_); !ok) return ok;
    out_ += '>';
    for (std::size_t i = 0; i < trace_.size(); ++i) {
      if (i > 0) out_ += ", ";
      append_step(trace_[i].position.x);
      out_ += ' ';
      append_step(trace_[i].position.y);
      out_ += ' ';
      append_step(trace_[i].width_mm);
    }
    out_ += "</trace>\n";
    return {};
  }

  // On the grid, so that the sum of what is read is that of what was written.
  void append_step(double mm) {
    const double on_grid = std::round(mm * inkml::kStepsPerMm) / inkml::kStepsPerMm;
    std::array<char, 40> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(),
                                   on_grid == 0.0 ? 0.0 : on_grid, std::chars_format::fixed)
                         .ptr;
    out_.append(text.data(), end);
  }

  std::string out_;
  std::map<std::array<std::uint8_t, 4>, int> brushes_;
  std::vector<Dab> dabs_;
  std::vector<WidePoint> trace_;
  std::int64_t trace_count_ = 0;
};

}  // namespace

Result<std::string> inkml_text(const LayeredSketch& drawing) {
  return InkmlText().write(drawing);
}

}  // namespace felt
