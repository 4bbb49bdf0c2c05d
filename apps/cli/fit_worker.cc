#include "fit_worker.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "felt/document/visible_strokes.h"

namespace felt::cli {
namespace {

/// Difference between the numbers of consecutive strokes on the same line. It is so large that the
/// numbers differ from those of all other lines.
constexpr std::int64_t kNumberStep = std::int64_t{1} << 32;

int count_corners(const Stroke& stroke) {
  const std::vector<JointKind>& joints = stroke.data().joints;
  return static_cast<int>(std::count(joints.begin(), joints.end(), JointKind::kCorner));
}

}  // namespace

FitWorker::FitWorker(const FitSettings& settings)
    : settings_(settings),
      steady_(settings.steady ? std::optional<SteadyLine>(*settings.steady) : std::nullopt),
      fitter_(settings.ink),
      meter_(settings.measure ? std::make_unique<StrokeMeter>(settings.ink) : nullptr) {}

void FitWorker::operator()(const FitItem& item, FitOutput& output) {
  output.name = item.name;
  output.sketch.clear();
  output.errors.clear();
  output.notices.clear();
  output.faults.clear();
  output.stats = {};
  for (std::size_t i = 0; i < item.lines.size(); ++i) {
    const NdjsonLine line = item.lines.line(i);
    Result<void> done = process(line, item.first_record + static_cast<std::int64_t>(i), output);
    if (done) continue;
    output.errors.push_back({line.number(), done.error().message});
  }
  if (item.drawing) process_whole(item, *item.drawing, output);
  if (item.failure) output.errors.push_back({0, item.failure->message});
}

/// Processes an input that was read as a whole. The reader of its format has already fitted the
/// samples.
void FitWorker::process_whole(const FitItem& item, const Imported& imported, FitOutput& output) {
  for (const ImportNotice& notice : imported.report.notices()) {
    output.notices.push_back(item.name + ": " + notice_text(notice));
  }
  std::int64_t record = item.first_record;
  const Document& document = imported.drawing.document;
  for (const Layer& layer : document.layers()) {
    if (!layer.visible) continue;
    for (const StrokeId id : layer.strokes) {
      const NamedStroke named{name_in_file(imported.drawing, id), *document.find(id)};
      ++output.stats.strokes;
      output.stats.segments += named.stroke.segment_count();
      output.stats.corners += count_corners(named.stroke);
      if (!settings_.format) continue;
      const Result<void> done = encode(named, record++, *settings_.format, output.sketch);
      if (!done) output.errors.push_back({0, named.id + ": " + done.error().message});
    }
  }
}

Result<void> FitWorker::process(const NdjsonLine& line, std::int64_t record, FitOutput& output) {
  try {
    if (looks_like_quickdraw(line.text())) return process_drawing(line, record, output);
    const Result<NdjsonKind> kind = parser_.raw_stroke(line, raw_);
    if (!kind) return tl::unexpected(kind.error());
    if (*kind == NdjsonKind::kHeader) return {};
    if (raw_.id.empty()) raw_.id = fmt::format("s{}", record);
    return process_raw(line, record, output);
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::kLimitExceeded, "not enough memory for this stroke; skipped");
  }
}

// Processes a drawing of Quick, Draw!. It has several strokes on a line; they are named KEY.1,
// KEY.2 and so on.
Result<void> FitWorker::process_drawing(const NdjsonLine& line, std::int64_t record,
                                        FitOutput& output) {
  QuickdrawRecord drawing;
  if (Result<void> parsed = drawings_.parse(line, drawing); !parsed) return parsed;
  const std::string key = drawing.key_id.empty() ? fmt::format("s{}", record) : drawing.key_id;
  std::int64_t number = record;
  for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
    raw_.id = fmt::format("{}.{}", key, i + 1);
    raw_.samples = std::move(drawing.strokes[i]);
    restore_simplified(raw_.samples);
    if (Result<void> done = process_raw(line, number, output); !done) {
      return tl::unexpected(with_context(done.error(), fmt::format("drawing[{}]", i)));
    }
    number += kNumberStep;
  }
  return {};
}

// Fits and encodes the stroke in raw_.
Result<void> FitWorker::process_raw(const NdjsonLine& line, std::int64_t number,
                                    FitOutput& output) {
  if (Result<void> scaled = scale_to_mm(); !scaled) return scaled;
  SampleFaults before;
  if (steady_) before = steady_samples(*steady_, raw_.samples);
  Result<Stroke> stroke = fit(raw_.samples, output.stats);
  if (!stroke) return tl::unexpected(stroke.error());
  const SampleFaults faults = combined_faults(fitter_.faults(), before);
  for (std::string& clause : fault_clauses(faults)) {
    output.faults.push_back(
        {line.number(), name_with_faults("stroke '" + raw_.id + "'", faults), std::move(clause)});
  }
  if (!settings_.format) return {};
  return encode({raw_.id, *std::move(stroke)}, number, *settings_.format, output.sketch);
}

Result<void> FitWorker::scale_to_mm() {
  for (std::size_t i = 0; i < raw_.samples.size(); ++i) {
    Point& p = raw_.samples[i].position;
    p = {p.x * settings_.mm_per_unit, p.y * settings_.mm_per_unit};
    if (is_in_range(p)) continue;
    return fail(ErrorCode::kLimitExceeded,
                fmt::format("points[{}]: beyond 1e9 mm after --mm-per-unit", i));
  }
  return {};
}

Result<Stroke> FitWorker::fit(std::span<const InkSample> samples, FitStats& stats) {
  const std::int64_t start = thread_cpu_ns();
  fitter_.begin();
  for (const InkSample& sample : samples) fitter_.push(sample);
  fitter_.end();
  const std::int64_t fitted = thread_cpu_ns();
  if (settings_.refine) fitter_.refine();
  const std::int64_t refined = thread_cpu_ns();
  Result<Stroke> stroke = fitter_.stroke();
  if (!stroke) return stroke;

  ++stats.strokes;
  stats.samples += static_cast<std::int64_t>(samples.size());
  stats.segments += stroke->segment_count();
  stats.corners += count_corners(*stroke);
  stats.fit_ns += fitted - start;
  stats.refine_ns += refined - fitted;
  if (meter_) {
    meter_->measure_calls(samples, stats);
    meter_->measure_error(samples, *stroke, stats);
  }
  return stroke;
}

}  // namespace felt::cli
