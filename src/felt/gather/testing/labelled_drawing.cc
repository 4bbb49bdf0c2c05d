#include "felt/gather/testing/labelled_drawing.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "felt/geometry/rect.h"

namespace felt {
namespace {

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == line.npos;
}

/// Reads the lines of one file.
class ScapReader {
 public:
  explicit ScapReader(LabelledDrawing& drawing) : drawing_(drawing) {}

  // Returns false if the line has another form.
  bool add(const std::string& text) {
    std::istringstream in(text);
    char mark = static_cast<char>((in >> std::ws).peek());
    if (mark == '{' || mark == '}') {
      if (in_stroke_ == (mark == '{')) return false;
      in_stroke_ = mark == '{';
      if (in_stroke_) {
        drawing_.lines.emplace_back();
        drawing_.labels.push_back(0);
      }
      return true;
    }
    if (mark == '@') return static_cast<bool>(in >> mark >> drawing_.pen_width);
    double x = 0.0, y = 0.0;
    if (mark == '#') {
      long id = 0, label = 0;
      if (!in_stroke_) return true;  // the size of the picture
      if (!(in >> mark >> id >> label) || label < 0) return false;
      drawing_.labels.back() = static_cast<std::uint32_t>(label);
      return true;
    }
    if (!in_stroke_ || !(in >> x >> y) || !is_in_range({x, y})) return false;
    drawing_.lines.back().push_back({x, y});
    return true;
  }

  [[nodiscard]] bool in_stroke() const { return in_stroke_; }

 private:
  LabelledDrawing& drawing_;
  bool in_stroke_ = false;
};

}  // namespace

double LabelledDrawing::diagonal() const {
  Rect box;
  for (const RoughLine& line : lines) {
    for (const Point p : line) box.extend(p);
  }
  return std::hypot(box.width(), box.height());
}

Result<LabelledDrawing> read_scap(const std::string& path) {
  std::ifstream file(path);
  if (!file) return fail(ErrorCode::kIo, path + ": cannot be read");
  LabelledDrawing drawing;
  drawing.name = std::filesystem::path(path).stem().string();
  ScapReader reader(drawing);
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    if (is_blank(line) || reader.add(line)) continue;
    return fail(ErrorCode::kInvalidData, path + ":" + std::to_string(number) + ": is not .scap");
  }
  if (reader.in_stroke()) return fail(ErrorCode::kInvalidData, path + ": ends within a stroke");
  return drawing;
}

Result<std::vector<LabelledDrawing>> read_scap_folder(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".scap") paths.push_back(entry.path().string());
  }
  if (paths.empty()) return fail(ErrorCode::kNotFound, folder + ": contains no .scap files");
  std::sort(paths.begin(), paths.end());
  std::vector<LabelledDrawing> drawings;
  for (const std::string& path : paths) {
    Result<LabelledDrawing> drawing = read_scap(path);
    if (!drawing) return tl::unexpected(drawing.error());
    drawings.push_back(*std::move(drawing));
  }
  return drawings;
}

}  // namespace felt
