#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "felt/geometry/point.h"

namespace felt {

/// A report as a list of blocks. report_html() and report_pdf() write the same report. Lengths are
/// in points (1/72 inch).

/// What a mark stands for. The writers choose the colour, so that HTML can have a light and a dark
/// theme.
struct ReportInk {
  enum Kind : std::uint8_t {
    kText,       ///< text, axes and means
    kQuiet,      ///< labels of axes
    kFaint,      ///< grid lines
    kPerson,     ///< one participant
    kCondition,  ///< colour `index` of a palette
  };
  Kind kind = kText;
  std::size_t index = 0;
  friend bool operator==(const ReportInk&, const ReportInk&) = default;
};
inline constexpr std::size_t kReportColors = 6;

/// Lines through points.
struct ReportLine {
  std::vector<Point> points;
  ReportInk ink;
  double width = 0.75;
  bool is_dashed = false;
};
/// A filled circle.
struct ReportDot {
  Point center;
  double radius = 2.0;
  ReportInk ink;
};
enum class ReportAlign : std::uint8_t { kLeft, kMiddle, kRight };
/// A text in one line. `at` is on the base line.
struct ReportWords {
  Point at;
  std::string text;
  ReportAlign align = ReportAlign::kLeft;
  ReportInk ink = {};
  double size = 8.0;
};
using ReportMark = std::variant<ReportLine, ReportDot, ReportWords>;

inline constexpr double kReportWidth = 480.0;

struct ReportTitle {
  std::string text;
};
struct ReportHeading {
  std::string text;
};
struct ReportText {
  std::string text;
};
/// A table. The first row is the heading, and the first column names the rows.
struct ReportTable {
  std::string title;
  std::vector<std::vector<std::string>> rows;
};
/// A picture of width kReportWidth.
struct ReportFigure {
  std::string title;
  std::string description;  ///< for readers who do not see the picture
  double height = 0.0;
  std::vector<ReportMark> marks;
};
using ReportBlock = std::variant<ReportTitle, ReportHeading, ReportText, ReportTable, ReportFigure>;
using Report = std::vector<ReportBlock>;

/// Returns the report as one HTML file without scripts or references to other files.
std::string report_html(const Report& report);

/// Returns the report as a PDF 1.4 file with A4 pages and the standard font Helvetica. Characters
/// that this font does not have become question marks. The same report gives the same bytes.
std::string report_pdf(const Report& report);

/// Returns the width of a text in Helvetica, in units of the font size.
double helvetica_width(std::string_view text);

}  // namespace felt
