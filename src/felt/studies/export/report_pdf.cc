#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "felt/base/utf8.h"
#include "felt/io/unpack.h"
#include "felt/studies/export/report_page.h"

namespace felt {
namespace {

// A4 in points, and its margins.
constexpr double kPageWidth = 595.28, kPageHeight = 841.89;
constexpr double kLeft = (kPageWidth - kReportWidth) / 2.0, kTop = 56.0, kBottom = 56.0;
constexpr double kTextSize = 9.5, kLeading = 13.0;

/// Widths of the characters from space to ~ in Helvetica, in thousandths of the font size (Adobe,
/// "Font Metrics for PDF Core 14 Fonts").
constexpr std::array<std::uint16_t, 95> kHelveticaWidths = {
    278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333,  278, 278, 556, 556, 556,
    556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556, 1015, 667, 667, 722, 722, 667,
    611, 778, 722, 278, 500, 667, 556, 833, 722, 778, 667, 778, 722, 667,  611, 722, 667, 944, 667,
    667, 611, 278, 278, 278, 469, 556, 333, 556, 556, 500, 556, 556, 278,  556, 556, 222, 222, 500,
    222, 833, 556, 556, 556, 556, 333, 500, 278, 556, 500, 722, 500, 500,  500, 334, 260, 334, 584};
constexpr double kOtherWidth = 556.0;

/// Returns a text in the encoding of the font: ISO 8859-1, whose characters WinAnsiEncoding shares.
std::string latin_text(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    std::uint32_t code = 0;
    if (!next_code_point(text, code)) return out + '?';
    const bool is_known = (code >= 0x20 && code < 0x7f) || (code >= 0xa0 && code <= 0xff);
    out += is_known ? static_cast<char>(static_cast<unsigned char>(code)) : '?';
  }
  return out;
}

double width_of(std::string_view latin) {
  double width = 0.0;
  for (const char c : latin) {
    const auto at = static_cast<std::size_t>(static_cast<unsigned char>(c)) - ' ';
    width += at < kHelveticaWidths.size() ? kHelveticaWidths[at] : kOtherWidth;
  }
  return width / 1000.0;
}

std::string pdf_number(double value) {
  std::array<char, 32> text{};
  const double rounded = std::round(value * 100.0) / 100.0 + 0.0;
  auto* const end =
      std::to_chars(text.data(), text.data() + text.size(), rounded, std::chars_format::fixed).ptr;
  return {text.data(), end};
}

std::string pdf_string(std::string_view latin) {
  std::string out = "(";
  for (const char c : latin) {
    if (c == '(' || c == ')' || c == '\\') out += '\\';
    out += c;
  }
  return out + ")";
}

/// The light colours of report_html().
std::uint32_t rgb_of(const ReportInk& ink) {
  static constexpr std::array<std::uint32_t, kReportColors> kConditions = {
      0x0072b2, 0xb34700, 0x007a5a, 0xa8447f, 0x8a6d00, 0x3f7fa8};
  switch (ink.kind) {
    case ReportInk::kText:
      return 0x1b1b1b;
    case ReportInk::kQuiet:
      return 0x595959;
    case ReportInk::kFaint:
      return 0xd9d9d9;
    case ReportInk::kPerson:
      return 0x7f7f7f;
    case ReportInk::kCondition:
      break;
  }
  return kConditions[ink.index % kReportColors];
}

std::string rgb_text(std::uint32_t rgb) {
  std::string out;
  for (const int shift : {16, 8, 0}) {
    out += pdf_number(static_cast<double>(rgb >> shift & 0xff) / 255.0) + ' ';
  }
  return out;
}

/// Lays blocks out on pages. y points down from the top of the page, as in a report.
class PdfPages {
 public:
  PdfPages() { add_page(); }

  [[nodiscard]] const std::vector<std::string>& contents() const noexcept { return contents_; }

  void operator()(const ReportTitle& title) { paragraph(title.text, 17.0, 22.0, kBold, 6.0); }
  void operator()(const ReportHeading& heading) {
    need(90.0);
    y_ += 8.0;
    paragraph(heading.text, 12.5, 16.0, kBold, 4.0);
  }
  void operator()(const ReportText& text) {
    paragraph(text.text, kTextSize, kLeading, kPlain, 6.0);
  }
  void operator()(const ReportTable& table) {
    if (table.rows.empty()) return;
    need(kLeading * std::min(12.0, static_cast<double>(table.rows.size()) + 2.0));
    paragraph(table.title, kTextSize, kLeading, kBold, 2.0);
    const std::vector<double> ends = column_ends(table);
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      need(kLeading);
      for (std::size_t i = 0; i < table.rows[row].size(); ++i) {
        const ReportAlign align = i == 0 ? ReportAlign::kLeft : ReportAlign::kRight;
        words({{i == 0 ? 0.0 : ends[i], y_ + kLeading - 4.0},
               table.rows[row][i],
               align,
               {},
               table_size_},
              row == 0 ? kBold : kPlain);
      }
      y_ += kLeading;
      line({{{0.0, y_}, {ends.back(), y_}}, {ReportInk::kFaint}, 0.5});
    }
    y_ += 10.0;
  }
  void operator()(const ReportFigure& figure) {
    need(figure.height + kLeading + 4.0);
    top_ = y_;
    for (const ReportMark& mark : figure.marks) std::visit(*this, mark);
    top_ = 0.0;
    y_ += figure.height + 2.0;
    paragraph(figure.title, kTextSize, kLeading, kBold, 10.0);
  }

  void operator()(const ReportLine& mark) { line(mark); }
  void operator()(const ReportDot& dot) {
    // Four cubic curves; with this length of their handles they are 0.03 % off a circle.
    constexpr double kHandle = 0.5523;
    const auto at = [&](double x, double y) {
      return place(dot.center + dot.radius * Vec{x, y}) + ' ';
    };
    out() += rgb_text(rgb_of(dot.ink)) + "rg " + at(1, 0) + "m " + at(1, kHandle) + at(kHandle, 1) +
             at(0, 1) + "c " + at(-kHandle, 1) + at(-1, kHandle) + at(-1, 0) + "c " +
             at(-1, -kHandle) + at(-kHandle, -1) + at(0, -1) + "c " + at(kHandle, -1) +
             at(1, -kHandle) + at(1, 0) + "c f\n";
  }
  void operator()(const ReportWords& mark) { words(mark, kPlain); }

 private:
  enum Font : std::uint8_t { kPlain, kBold };

  std::string& out() { return contents_.back(); }
  void add_page() {
    contents_.emplace_back("1 j 1 J\n");
    y_ = 0.0;
  }
  /// Continues on a new page if less than `height` is left on this one.
  void need(double height) {
    if (y_ > 0.0 && y_ + height > kPageHeight - kTop - kBottom) add_page();
  }
  [[nodiscard]] std::string place(Point p) const {
    return pdf_number(kLeft + p.x) + ' ' + pdf_number(kPageHeight - kTop - top_ - p.y);
  }

  void line(const ReportLine& mark) {
    if (mark.points.size() < 2) return;
    out() += rgb_text(rgb_of(mark.ink)) + "RG " + pdf_number(mark.width) +
             (mark.is_dashed ? " w [3 2] 0 d\n" : " w [] 0 d\n");
    for (std::size_t i = 0; i < mark.points.size(); ++i) {
      out() += place(mark.points[i]) + (i == 0 ? " m\n" : " l\n");
    }
    out() += "S\n";
  }

  void words(const ReportWords& mark, Font font) {
    const std::string latin = latin_text(mark.text);
    // Helvetica-Bold is about 6 % wider.
    const double width = mark.size * width_of(latin) * (font == kBold ? 1.06 : 1.0);
    Point at = mark.at;
    if (mark.align == ReportAlign::kMiddle) at.x -= 0.5 * width;
    if (mark.align == ReportAlign::kRight) at.x -= width;
    out() += "BT " + rgb_text(rgb_of(mark.ink)) + "rg /F" + std::to_string(font + 1) + " " +
             pdf_number(mark.size) + " Tf " + place(at) + " Td " + pdf_string(latin) + " Tj ET\n";
  }

  /// Breaks a text into lines. A word that is wider than the page gets a line of its own.
  void paragraph(std::string_view text, double size, double leading, Font font, double after) {
    std::string row;
    const auto flush = [&] {
      need(leading);
      words({{0.0, y_ + size}, row, ReportAlign::kLeft, {}, size}, font);
      y_ += leading;
      row.clear();
    };
    while (!text.empty()) {
      const std::size_t end = std::min(text.find(' '), text.size());
      const std::string longer = row + (row.empty() ? "" : " ") + std::string(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
      if (!row.empty() && helvetica_width(longer) * size * 1.06 > kReportWidth) {
        const std::string word = longer.substr(row.size() + 1);
        flush();
        row = word;
      } else {
        row = longer;
      }
    }
    flush();
    y_ += after;
  }

  /// Returns where the columns of a table end, and sets the font size so that it fits.
  std::vector<double> column_ends(const ReportTable& table) {
    std::vector<double> ends;
    for (const auto& row : table.rows) {
      for (std::size_t i = 0; i < row.size(); ++i) {
        if (ends.size() <= i) ends.push_back(0.0);
        ends[i] = std::max(ends[i], 1.06 * helvetica_width(row[i]) + (i == 0 ? 0.0 : 1.4));
      }
    }
    double sum = 0.0;
    for (double& end : ends) end = sum += end;
    table_size_ = std::min(9.0, kReportWidth / std::max(sum, 1.0));
    for (double& end : ends) end *= table_size_;
    return ends;
  }

  std::vector<std::string> contents_;
  double y_ = 0.0;    // below the top margin
  double top_ = 0.0;  // of the figure in progress
  double table_size_ = 9.0;
};

}  // namespace

double helvetica_width(std::string_view text) {
  return width_of(latin_text(text));
}

std::string report_pdf(const Report& report) {
  PdfPages pages;
  std::string title;
  for (const ReportBlock& block : report) {
    if (const auto* found = std::get_if<ReportTitle>(&block)) title = found->text;
    std::visit(pages, block);
  }
  const std::size_t count = pages.contents().size();
  constexpr std::size_t kFirstPage = 6;
  std::vector<std::string> objects = {
      "<< /Type /Catalog /Pages 2 0 R /Lang (en) /ViewerPreferences << /DisplayDocTitle true >> >>",
      "", "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica /Encoding /WinAnsiEncoding >>",
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica-Bold /Encoding /WinAnsiEncoding >>",
      "<< /Title " + pdf_string(latin_text(title)) + " /Producer (Feltline) >>"};
  std::string kids;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string number = std::to_string(kFirstPage + 2 * i);
    kids += number + " 0 R ";
    objects.push_back("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 595.28 841.89] /Contents " +
                      std::to_string(kFirstPage + 2 * i + 1) +
                      " 0 R /Resources << /Font << /F1 3 0 R /F2 4 0 R >> >> >>");
    const std::string packed = zlib_packed(pages.contents()[i]);
    objects.push_back("<< /Filter /FlateDecode /Length " + std::to_string(packed.size()) +
                      " >>\nstream\n" + packed + "\nendstream");
  }
  objects[1] = "<< /Type /Pages /Count " + std::to_string(count) + " /Kids [" + kids + "] >>";

  std::string out = "%PDF-1.4\n%\xe2\xe3\xcf\xd3\n", places;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    std::array<char, 24> place{};
    std::snprintf(place.data(), place.size(), "%010zu 00000 n \n", out.size());
    places += place.data();
    out += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
  }
  const std::string size = std::to_string(objects.size() + 1);
  const std::string start = std::to_string(out.size());
  return out + "xref\n0 " + size + "\n0000000000 65535 f \n" + places + "trailer\n<< /Size " +
         size + " /Root 1 0 R /Info 5 0 R >>\nstartxref\n" + start + "\n%%EOF\n";
}

}  // namespace felt
