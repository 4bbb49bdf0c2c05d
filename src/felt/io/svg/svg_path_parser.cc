#include "felt/io/svg/svg_path_parser.h"

#include <array>
#include <cctype>

#include "felt/io/svg/svg_scan.h"

namespace felt {
namespace {

/// Returns how many numbers a command takes each time; -1 if it is not a command.
int argument_count(char command) noexcept {
  switch (command) {
    case 'm':
    case 'l':
    case 't':
      return 2;
    case 'h':
    case 'v':
      return 1;
    case 'c':
      return 6;
    case 's':
    case 'q':
      return 4;
    case 'a':
      return 7;
    case 'z':
      return 0;
    default:
      return -1;
  }
}

class PathParser {
 public:
  PathParser(std::string_view d, std::size_t max_segments, double max_number)
      : scan_(d, max_number), path_(max_segments) {}

  SvgPathData parse() {
    SvgPathData data;
    data.problem = read_commands();
    data.contours = path_.take();
    return data;
  }

 private:
  std::string problem(const std::string& what) const {
    return what + " at character " + std::to_string(scan_.taken() + 1);
  }

  std::string read_commands() {
    bool first = true;
    while (!scan_.at_end()) {
      const char letter = scan_.peek();
      const char command = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
      const int count = argument_count(command);
      if (count < 0) return problem("no command");
      if (first && command != 'm') return problem("the first command is not M");
      scan_.take(letter);
      first = false;
      if (count == 0) {
        path_.close();
        last_ = 'z';
      } else if (std::string wrong = read_repeats(command, letter == command, count);
                 !wrong.empty()) {
        return wrong;
      }
      if (path_.full()) return problem("too many curves");
    }
    return {};
  }

  /// Reads a command with its numbers, repeatedly as long as numbers follow.
  std::string read_repeats(char command, bool relative, int count) {
    scan_.skip_spaces();
    do {
      std::array<double, 7> v{};
      for (int i = 0; i < count; ++i) {
        if (i > 0) scan_.skip_comma();
        if (!read_argument(command, i, v)) return problem("a number is missing or beyond 1e9");
      }
      carry_out(command, relative, v);
      if (path_.full()) return problem("too many curves");
      if (command == 'm') command = 'l';
      scan_.skip_comma();
    } while (scan_.at_number());
    return {};
  }

  bool read_argument(char command, int i, std::array<double, 7>& v) {
    double& value = v[static_cast<std::size_t>(i)];
    if (command != 'a' || (i != 3 && i != 4)) return scan_.number(value);
    bool flag = false;
    if (!scan_.flag(flag)) return false;
    value = flag ? 1.0 : 0.0;
    return true;
  }

  void carry_out(char command, bool relative, const std::array<double, 7>& v) {
    const Point here = path_.here();
    const auto place = [&](std::size_t i) {
      return relative ? here + Vec{v[i], v[i + 1]} : Point{v[i], v[i + 1]};
    };
    Point handle = here;  // mirrored by a following S or T
    switch (command) {
      case 'm':
        path_.move(place(0));
        break;
      case 'l':
        path_.line(place(0));
        break;
      case 'h':
        path_.line({relative ? here.x + v[0] : v[0], here.y});
        break;
      case 'v':
        path_.line({here.x, relative ? here.y + v[0] : v[0]});
        break;
      case 'c':
        path_.cubic(place(0), place(2), place(4));
        handle = place(2);
        break;
      case 's':
        path_.cubic(mirrored('c', 's'), place(0), place(2));
        handle = place(0);
        break;
      case 'q':
        path_.quadratic(place(0), place(2));
        handle = place(0);
        break;
      case 't':
        handle = mirrored('q', 't');
        path_.quadratic(handle, place(0));
        break;
      default:
        path_.arc(v[0], v[1], v[2], v[3] != 0.0, v[4] != 0.0, place(5));
    }
    handle_ = handle;
    last_ = command;
  }

  /// Returns the last handle, mirrored at the current point, if the last command was one of the
  /// two.
  [[nodiscard]] Point mirrored(char a, char b) const noexcept {
    const Point here = path_.here();
    return last_ == a || last_ == b ? here + (here - handle_) : here;
  }

  SvgScan scan_;
  SvgPathBuilder path_;
  Point handle_;
  char last_ = 'm';
};

}  // namespace

SvgPathData parse_svg_path(std::string_view d, std::size_t max_segments, double max_number) {
  const std::string_view text = svg_trimmed(d);
  if (text.empty() || svg_same_word(text, "none")) return {};
  return PathParser(d, max_segments, max_number).parse();
}

SvgPointList parse_svg_points(std::string_view text) {
  SvgPointList list;
  SvgScan scan(text);
  while (!scan.at_end()) {
    Point p;
    bool ok = scan.number(p.x);
    if (ok) scan.skip_comma();
    ok = ok && scan.number(p.y);
    if (!ok) {
      list.problem = "no pair of numbers at character " + std::to_string(scan.taken() + 1);
      break;
    }
    list.points.push_back(p);
    scan.skip_comma();
  }
  return list;
}

}  // namespace felt
