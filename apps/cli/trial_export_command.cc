#include <memory>
#include <string>

#include "commands.h"
#include "felt/studies/export/export_study.h"
#include "interrupt.h"
#include "print.h"

namespace felt::cli {
namespace {

struct TrialExportArguments {
  std::string folder, out;
};

void export_results(const TrialExportArguments& args, Console& console) {
  const Interrupt interrupt;
  const Result<StudyFolder> folder = StudyFolder::open(args.folder);
  if (!folder) return console.error(folder.error().message);
  const auto progress = [&console](double share) {
    console.status(fmt::format("exporting: {:.0f} %", 100.0 * share));
    return !Interrupt::was_asked();
  };
  const Result<std::vector<std::string>> done = export_study(*folder, args.out, progress);
  console.end_progress();
  if (!done) return console.error(done.error().message);
  for (const std::string& session : *done) {
    console.notice(args.folder + ": unfinished: " + session);
  }
  print("{}\n", args.out);
}

}  // namespace

void add_trial_export_command(CLI::App& trial, Console& console) {
  CLI::App* command = trial.add_subcommand(
      "export", "Write tables, a report, analysis scripts and a BIDS data set of a study");
  const auto args = std::make_shared<TrialExportArguments>();
  command->add_option("FOLDER", args->folder, "The folder with the results of the study")
      ->required()
      ->check(not_empty());
  command->add_option("-o,--output", args->out, "The new folder for the export")
      ->required()
      ->check(not_empty());
  command->footer(
      examples("feltline trial export results -o export\n"
               "Rscript export/analysis.R\n"
               "python3 export/analysis.py") +
      "\n\nThe export has trials.csv with its dictionary trials.json, answers.csv, report.html,\n"
      "report.pdf, analysis.R, analysis.py, the recordings, and the folder bids. The new folder\n"
      "is complete or does not exist. Format: docs/formats/study-export.md.");
  command->callback([args, &console] { export_results(*args, console); });
}

}  // namespace felt::cli
