#include <array>
#include <charconv>
#include <cmath>

#include "felt/studies/export/report_page.h"

namespace felt {
namespace {

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
)";

// The colours of the conditions: Okabe, Ito, "Color universal design", 2008, darker or lighter
// where the contrast with the page would be below 3:1.
constexpr const char* kStyle = R"(<style>
:root { color-scheme: light dark; --page: #ffffff; --text: #1b1b1b; --quiet: #595959;
  --faint: #d9d9d9; --person: #7f7f7f; --c0: #0072b2; --c1: #b34700; --c2: #007a5a;
  --c3: #a8447f; --c4: #8a6d00; --c5: #3f7fa8; }
@media (prefers-color-scheme: dark) { :root { --page: #161616; --text: #ececec; --quiet: #b5b5b5;
  --faint: #3c3c3c; --person: #8c8c8c; --c0: #56b4e9; --c1: #f0894a; --c2: #2fc79a;
  --c3: #e08fc0; --c4: #e3c53d; --c5: #9fcbe8; } }
body { max-width: 46rem; margin: 2rem auto; padding: 0 1rem; background: var(--page);
  color: var(--text); font: 1rem/1.5 system-ui, sans-serif; }
h1, h2 { line-height: 1.25; } h2 { margin-top: 2.5rem; }
table { border-collapse: collapse; margin: 1rem 0; font-variant-numeric: tabular-nums;
  display: block; overflow-x: auto; }
caption, figcaption { text-align: left; font-weight: 600; padding: .25rem 0; }
th, td { text-align: right; padding: .2rem .8rem .2rem 0; border-bottom: 1px solid var(--faint); }
td { white-space: nowrap; } th:first-child, td:first-child { text-align: left; } th { font-weight: 600; }
figure { margin: 1.5rem 0; } svg { width: 100%; height: auto; }
svg text { font-family: system-ui, Helvetica, Arial, sans-serif; }
</style>
)";

std::string html_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

/// Returns a length with at most two decimals.
std::string svg_number(double value) {
  std::array<char, 32> text{};
  const double rounded = std::round(value * 100.0) / 100.0;
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), rounded + 0.0).ptr};
}

std::string css_color(const ReportInk& ink) {
  switch (ink.kind) {
    case ReportInk::kText:
      return "var(--text)";
    case ReportInk::kQuiet:
      return "var(--quiet)";
    case ReportInk::kFaint:
      return "var(--faint)";
    case ReportInk::kPerson:
      return "var(--person)";
    case ReportInk::kCondition:
      break;
  }
  return "var(--c" + std::to_string(ink.index % kReportColors) + ")";
}

/// Appends the marks of a figure as elements of SVG.
struct SvgMarks {
  std::string& out;

  void operator()(const ReportLine& line) const {
    out += "<polyline fill=\"none\" stroke=\"" + css_color(line.ink) + "\" stroke-width=\"" +
           svg_number(line.width) + "\" stroke-linejoin=\"round\"";
    if (line.is_dashed) out += " stroke-dasharray=\"3 2\"";
    out += " points=\"";
    for (const Point p : line.points) {
      if (out.back() != '"') out += ' ';
      out += svg_number(p.x) + "," + svg_number(p.y);
    }
    out += "\"/>\n";
  }
  void operator()(const ReportDot& dot) const {
    out += "<circle cx=\"" + svg_number(dot.center.x) + "\" cy=\"" + svg_number(dot.center.y) +
           "\" r=\"" + svg_number(dot.radius) + "\" fill=\"" + css_color(dot.ink) + "\"/>\n";
  }
  void operator()(const ReportWords& words) const {
    static constexpr std::array<const char*, 3> kAnchors = {"start", "middle", "end"};
    out += "<text x=\"" + svg_number(words.at.x) + "\" y=\"" + svg_number(words.at.y) +
           "\" font-size=\"" + svg_number(words.size) + "\" text-anchor=\"" +
           kAnchors[static_cast<std::size_t>(words.align)] + "\" fill=\"" + css_color(words.ink) +
           "\">" + html_text(words.text) + "</text>\n";
  }
};

/// Appends the blocks of a report as elements of HTML.
struct HtmlBlocks {
  std::string& out;
  int& figures;

  void operator()(const ReportTitle& title) const { element("h1", title.text); }
  void operator()(const ReportHeading& heading) const { element("h2", heading.text); }
  void operator()(const ReportText& text) const { element("p", text.text); }
  void operator()(const ReportTable& table) const {
    out += "<table>\n<caption>" + html_text(table.title) + "</caption>\n";
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      out += "<tr>";
      for (std::size_t i = 0; i < table.rows[row].size(); ++i) {
        const bool is_heading = row == 0 || i == 0;
        const std::string scope = row == 0 ? " scope=\"col\"" : " scope=\"row\"";
        out += (is_heading ? "<th" + scope + ">" : "<td>") + html_text(table.rows[row][i]) +
               (is_heading ? "</th>" : "</td>");
      }
      out += "</tr>\n";
    }
    out += "</table>\n";
  }
  void operator()(const ReportFigure& figure) const {
    const std::string id = "figure" + std::to_string(++figures);
    out += "<figure>\n<svg role=\"img\" viewBox=\"0 0 " + svg_number(kReportWidth) + " " +
           svg_number(figure.height) + "\" aria-labelledby=\"" + id + "-title " + id +
           "-description\">\n<title id=\"" + id + "-title\">" + html_text(figure.title) +
           "</title>\n<desc id=\"" + id + "-description\">" + html_text(figure.description) +
           "</desc>\n";
    for (const ReportMark& mark : figure.marks) std::visit(SvgMarks{out}, mark);
    out += "</svg>\n<figcaption>" + html_text(figure.title) + "</figcaption>\n</figure>\n";
  }

  void element(const std::string& name, std::string_view text) const {
    out += "<" + name + ">" + html_text(text) + "</" + name + ">\n";
  }
};

}  // namespace

std::string report_html(const Report& report) {
  std::string out = kHead;
  for (const ReportBlock& block : report) {
    if (const auto* title = std::get_if<ReportTitle>(&block)) {
      out += "<title>" + html_text(title->text) + "</title>\n";
    }
  }
  out += std::string(kStyle) + "</head>\n<body>\n<main>\n";
  int figures = 0;
  for (const ReportBlock& block : report) std::visit(HtmlBlocks{out, figures}, block);
  return out + "</main>\n</body>\n</html>\n";
}

}  // namespace felt
