#include "felt/studies/export/export_study.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "felt/store/felt_file.h"
#include "felt/studies/export/analysis_scripts.h"
#include "felt/studies/export/bids_files.h"
#include "felt/studies/export/data_table.h"
#include "felt/studies/export/export_folder.h"
#include "felt/studies/export/hypothesis_table.h"
#include "felt/studies/export/report_page.h"
#include "felt/studies/export/study_report.h"
#include "felt/studies/export/study_results.h"
#include "felt/studies/measured_trial.h"
#include "felt/studies/session_file.h"

namespace felt {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPictureSamples = 150;  // of one trial

/// Keeps some samples in contact for the pictures of the report.
void keep_ink(std::span<const TrialSample> samples, MeasuredTrial& trial) {
  const auto drawn = static_cast<std::size_t>(std::count_if(
      samples.begin(), samples.end(), [](const TrialSample& s) { return s.contact; }));
  const std::size_t every = std::max<std::size_t>(1, drawn / kPictureSamples);
  std::size_t in_touch = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!samples[i].contact) {
      in_touch = 0;
      continue;
    }
    if (in_touch == 0) trial.touches.push_back(trial.ink.size());
    const bool is_last = i + 1 == samples.size() || !samples[i + 1].contact;
    if (in_touch++ % every == 0 || is_last) trial.ink.push_back(samples[i].position);
  }
}

auto find_planned(const StudySession& session, int number) {
  return std::find_if(session.plan.begin(), session.plan.end(),
                      [number](const PlannedTrial& p) { return p.number == number; });
}

/// Reads a trial, measures it, and writes its recording and its part of the BIDS data set.
Result<MeasuredTrial> export_trial(const StudyFolder& folder, const StudyResults& results,
                                   const StudySession& session, std::size_t index,
                                   const ExportFolder& out) {
  const TrialResult& result = session.results[index];
  const auto planned = find_planned(session, result.trial);
  const std::string file = folder.file_of(session.info, result.recording);
  if (planned == session.plan.end()) {
    return invalid_data(file + ": the study has no trial " + std::to_string(result.trial));
  }
  std::string bytes;
  const Result<FeltRecording> recording = folder.recording(session.info, result, &bytes);
  if (!recording) return tl::unexpected(recording.error());
  const std::vector<TrialSample> samples = trial_samples(*recording);
  const StudyPath path = compared_path(results.files, *planned, samples);
  MeasuredTrial trial;
  trial.info = session.info;
  trial.plan = *planned;
  trial.result = result;
  const Result<Drawing> drawing = parse_felt(bytes);
  if (!drawing) return tl::unexpected(with_context(drawing.error(), file));
  trial.metrics = measure_recorded_trial(results.files, *planned, samples, drawing->document);
  trial.position =
      condition_positions(session.plan)[static_cast<std::size_t>(planned - session.plan.begin())];
  trial.recording =
      "recordings/" + fs::path(file).lexically_relative(folder.path()).generic_string();
  trial.path = path.points;
  trial.is_closed = path.ends == TrialPathEnds::kClosed;
  keep_ink(samples, trial);
  if (Result<void> done = out.write(trial.recording, bytes); !done) {
    return tl::unexpected(done.error());
  }
  for (const ExportFile& part : bids_run_files(results, trial, *recording, index + 1)) {
    if (Result<void> done = out.write("bids/" + part.path, part.bytes); !done) {
      return tl::unexpected(done.error());
    }
  }
  return trial;
}

Result<void> export_session(const StudyFolder& folder, const StudySession& session,
                            const ExportFolder& out, const std::function<bool()>& progress,
                            StudyResults& results) {
  for (std::size_t i = 0; i < session.results.size(); ++i) {
    Result<MeasuredTrial> trial = export_trial(folder, results, session, i, out);
    if (!trial) return tl::unexpected(trial.error());
    results.trials.push_back(std::move(*trial));
    if (!progress()) return fail(ErrorCode::kIo, "interrupted: nothing was exported");
  }
  for (const QuestionAnswers& answers : session.answers) {
    const auto planned = find_planned(session, answers.after_trial);
    if (planned != session.plan.end()) {
      results.answers.push_back({session.info, *planned, answers});
    }
  }
  return {};
}

/// Returns the files that need all trials.
std::vector<ExportFile> summary_files(const StudyResults& results) {
  const std::vector<DataColumn<MeasuredTrial>> trials = trial_columns(results);
  const std::vector<DataColumn<GivenAnswers>> answers = answer_columns(results);
  const Report report = study_report(results);
  std::vector<ExportFile> files = {{"trials.csv", csv_text(trials, results.trials)},
                                   {"trials.json", dictionary_text(infos_of(trials))},
                                   {"answers.csv", csv_text(answers, results.answers)},
                                   {"answers.json", dictionary_text(infos_of(answers))},
                                   {"analysis.R", std::string(analysis_r())},
                                   {"analysis.py", std::string(analysis_python())},
                                   {"report.html", report_html(report)},
                                   {"report.pdf", report_pdf(report)}};
  if (!results.files.study.hypotheses.empty()) {
    const std::vector<DataColumn<HypothesisRow>> hypotheses = hypothesis_columns();
    files.push_back({"hypotheses.csv", csv_text(hypotheses, hypothesis_rows(results))});
    files.push_back({"hypotheses.json", dictionary_text(infos_of(hypotheses))});
  }
  for (ExportFile& file : bids_dataset_files(results)) {
    files.push_back({"bids/" + file.path, std::move(file.bytes)});
  }
  for (const auto& [name, bytes] : results.files.sources) files.push_back({"study/" + name, bytes});
  return files;
}

}  // namespace

Result<std::vector<std::string>> export_study(const StudyFolder& folder, const std::string& out,
                                              const std::function<bool(double)>& progress) {
  const Result<std::vector<StudySession>> sessions = folder.sessions();
  if (!sessions) return tl::unexpected(sessions.error());
  Result<ExportFolder> target = ExportFolder::create(out);
  if (!target) return tl::unexpected(target.error());

  std::size_t count = 0, done = 0;
  for (const StudySession& session : *sessions) count += session.results.size();
  const auto report_share = [&] {
    ++done;
    return !progress || progress(static_cast<double>(done) / static_cast<double>(count));
  };
  StudyResults results;
  results.files = folder.files();
  for (const StudySession& session : *sessions) {
    if (Result<void> written = export_session(folder, session, *target, report_share, results);
        !written) {
      return tl::unexpected(written.error());
    }
    const std::size_t drawn = done_trials(session, results.files.study.catch_rules);
    if (drawn < session.plan.size()) {
      results.unfinished.push_back("participant " + std::to_string(session.info.participant) +
                                   ", " + std::string(session_name(session.info.session)) + ": " +
                                   std::to_string(drawn) + " of " +
                                   std::to_string(session.plan.size()) + " trials");
    }
  }
  for (const ExportFile& file : summary_files(results)) {
    if (Result<void> written = target->write(file.path, file.bytes); !written) {
      return tl::unexpected(written.error());
    }
  }
  if (Result<void> named = target->commit(); !named) return tl::unexpected(named.error());
  return std::move(results.unfinished);
}

}  // namespace felt
