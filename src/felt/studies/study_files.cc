#include "felt/studies/study_files.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "felt/base/read_file.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/drawing_reader.h"
#include "felt/store/felt_recording.h"
#include "felt/stroke/outline/outline.h"
#include "felt/studies/measured_trial.h"
#include "felt/trial/study_file.h"
#include "felt/trial/study_shapes.h"

namespace felt {
namespace {

constexpr double kPathToleranceMm = 1e-3;

Rect box_of(std::span<const Point> points) {
  Rect box;
  for (const Point p : points) box.extend(p);
  return box;
}

/// Reads the files of a study, each of them once.
class StudyReader {
 public:
  explicit StudyReader(const std::string& path) : path_(path) {
    const std::string name = std::filesystem::path(path).filename().string();
    folder_ = path.substr(0, path.size() - name.size());
    files_.sources.emplace_back(name, "");
  }

  Result<StudyFiles> read() {
    Result<std::string> text = read_regular_file(path_, kMaxStudyBytes);
    if (!text) return tl::unexpected(text.error());
    Result<Study> study = read_study(*text, path_);
    if (!study) return tl::unexpected(study.error());
    files_.sources.front().second = *std::move(text);
    files_.study = *std::move(study);
    for (const StudyShape& shape : files_.study.shapes) {
      Result<StudyPath> path = path_of(shape);
      if (!path) return tl::unexpected(path.error());
      files_.paths.push_back(*std::move(path));
    }
    for (const StudyCondition& condition : files_.study.conditions) {
      Result<std::vector<TrialSample>> teacher = teacher_of(condition);
      if (!teacher) return tl::unexpected(teacher.error());
      files_.teachers.push_back(*std::move(teacher));
    }
    return std::move(files_);
  }

 private:
  /// Returns an error about a key of the study.
  [[nodiscard]] tl::unexpected<Error> wrong(int line, const std::string& key,
                                            const Error& error) const {
    return tl::unexpected(with_context(error, path_ + ":" + std::to_string(line) + ": " + key));
  }

  /// Reads a file that the study names. The reference is valid until the next call.
  Result<Drawing> read_drawing_named(const std::string& name) {
    if (name == kStudyFileName || name.starts_with(kParticipantPrefix)) {
      return invalid_data("\"" + name + "\" is a name in the folder with the results");
    }
    const std::string path = folder_ + name;
    auto source = std::find_if(files_.sources.begin() + 1, files_.sources.end(),
                               [&name](const auto& s) { return s.first == name; });
    if (source == files_.sources.end()) {
      Result<std::string> bytes = read_regular_file(path, kMaxStudySourceBytes);
      if (!bytes) return tl::unexpected(bytes.error());
      source = files_.sources.emplace(files_.sources.end(), name, *std::move(bytes));
    }
    Result<Imported> read = parse_drawing(source->second, path);
    if (!read) return tl::unexpected(with_context(read.error(), path));
    return std::move(read->drawing);
  }

  Result<StudyPath> path_of(const StudyShape& shape) {
    StudyPath path;
    if (shape.kind == StudyShapeKind::kFile) {
      Result<StudyPath> drawn = drawn_path(shape);
      if (!drawn) return wrong(shape.line, "shape.file", drawn.error());
      path = *std::move(drawn);
    } else {
      path.points = shape_path(shape.kind, shape.size_mm.value_or(kDefaultShapeMm));
      const bool is_closed =
          shape.kind == StudyShapeKind::kCircle || shape.kind == StudyShapeKind::kStar;
      path.ends = is_closed ? TrialPathEnds::kClosed : TrialPathEnds::kOpen;
    }
    if (shape.task == StudyTask::kClose && path.ends == TrialPathEnds::kOpen) {
      return wrong(shape.line, "shape.file",
                   {ErrorCode::kInvalidData, folder_ + shape.file +
                                                 ": the line is open, the task close requires a "
                                                 "closed one"});
    }
    const bool is_copied = shape.task == StudyTask::kCopy;
    const double width_mm = is_copied ? 0.5 * kStudyPage.width() : kStudyPage.width();
    const Rect box = box_of(path.points);
    if (!(box.width() <= width_mm && box.height() <= kStudyPage.height())) {
      const std::string room = is_copied ? "half a page (task copy), 148.5" : "the page, 297";
      return wrong(shape.line, shape.size_mm ? "shape.size_mm" : "shape",
                   {ErrorCode::kInvalidData,
                    "\"" + shape.name + "\" does not fit on " + room + " x 210 mm"});
    }
    Point middle = middle_of(kStudyPage);
    if (is_copied) middle.x += 0.25 * kStudyPage.width();
    const Vec shift = middle - middle_of(box);
    for (Point& p : path.points) p = p + shift;
    return path;
  }

  /// Returns the only line of the shape's file, scaled to its size.
  Result<StudyPath> drawn_path(const StudyShape& shape) {
    const Result<Drawing> drawing = read_drawing_named(shape.file);
    if (!drawing) return tl::unexpected(drawing.error());
    const std::vector<StrokePtr> strokes = visible_strokes(drawing->document);
    if (strokes.size() != 1) {
      return invalid_data(folder_ + shape.file + " has " + std::to_string(strokes.size()) +
                          " lines, it must have one");
    }
    const Stroke& stroke = *strokes.front();
    Rect box;
    for (int i = 0; i < stroke.segment_count(); ++i) box.extend(bounds(stroke.segment(i)));
    const double scale =
        shape.size_mm ? *shape.size_mm / std::max({box.width(), box.height(), kMinSegmentMm}) : 1.0;
    StudyPath path;
    path.ends = stroke.closed() ? TrialPathEnds::kClosed : TrialPathEnds::kOpen;
    path.points.push_back(scaled(stroke.segment(0), scale).p[0]);
    for (int i = 0; i < stroke.segment_count(); ++i) {
      const Cubic cubic = scaled(stroke.segment(i), scale);
      const int steps = flatten_steps(cubic, 1.0, kPathToleranceMm);
      for (int k = 1; k <= steps; ++k) {
        path.points.push_back(evaluate(cubic, static_cast<double>(k) / steps));
      }
    }
    return path;
  }

  static Cubic scaled(Cubic cubic, double scale) {
    for (Point& p : cubic.p) p = {scale * p.x, scale * p.y};
    return cubic;
  }

  Result<std::vector<TrialSample>> teacher_of(const StudyCondition& condition) {
    if (condition.guidance != StudyGuidance::kReplayedTeacher) return std::vector<TrialSample>();
    Result<std::vector<TrialSample>> samples = recorded_teacher(condition.teacher);
    if (!samples) return wrong(condition.line, "condition.teacher", samples.error());
    return samples;
  }

  Result<std::vector<TrialSample>> recorded_teacher(const std::string& name) {
    const Result<Drawing> drawing = read_drawing_named(name);
    if (!drawing) return tl::unexpected(drawing.error());
    const std::string path = folder_ + name;
    const auto all = recordings_of(*drawing);
    if (!all) return tl::unexpected(with_context(all.error(), path));
    if (all->empty()) return invalid_data(path + " has no recording");
    const Result<FeltRecording> recording = read_recording(*drawing, all->size() - 1);
    if (!recording) return tl::unexpected(with_context(recording.error(), path));
    std::vector<TrialSample> samples = trial_samples(*recording);
    Rect box;
    for (const TrialSample& s : samples) {
      if (s.contact) box.extend(s.position);
    }
    if (box.empty()) return invalid_data(path + ": the pen never touches the surface");
    const Vec shift = middle_of(kStudyPage) - middle_of(box);
    for (TrialSample& s : samples) s.position = s.position + shift;
    return samples;
  }

  std::string path_, folder_;
  StudyFiles files_;
};

}  // namespace

Result<StudyFiles> read_study_files(const std::string& path) {
  return StudyReader(path).read();
}

StudyPath model_of(const StudyPath& path) {
  StudyPath model = path;
  for (Point& p : model.points) p.x -= 0.5 * kStudyPage.width();
  return model;
}

std::vector<Point> via_points(const StudyPath& path) {
  constexpr double kCornerCosine = 0.87;  // of 30 degrees
  std::vector<Point> points = path.points;
  if (path.ends == TrialPathEnds::kClosed && points.front() != points.back()) {
    points.push_back(points.front());
  }
  std::vector<Point> via;
  for (std::size_t i = 0; i < points.size(); ++i) {
    via.push_back(points[i]);
    if (i == 0 || i + 1 == points.size()) continue;
    const Vec in = points[i] - points[i - 1], out = points[i + 1] - points[i];
    if (dot(in, out) < kCornerCosine * norm(in) * norm(out)) via.push_back(points[i]);
  }
  return via;
}

}  // namespace felt
