#include <memory>
#include <string>

#include "commands.h"
#include "felt/studies/export/preregistration.h"
#include "felt/trial/study_order.h"
#include "output.h"
#include "print.h"

namespace felt::cli {
namespace {

struct PreregisterArguments {
  std::string study, out = "-";
  int people = 0;  // 0: the number in the study
};

Result<std::string> preregister(const PreregisterArguments& args) {
  const Result<StudyFiles> files = read_study_files(args.study);
  if (!files) return tl::unexpected(files.error());
  const int people = args.people > 0 ? args.people : files->study.people;
  if (people == 0) {
    return fail(ErrorCode::kInvalidArgument,
                args.study +
                    ": the number of participants is missing; give --people, or set people "
                    "in the study");
  }
  Result<std::string> text = preregistration_text(*files, people, "feltline " FELT_VERSION);
  if (!text) return tl::unexpected(with_context(text.error(), args.study));
  return text;
}

void run_preregister(const PreregisterArguments& args, Console& console) {
  const Result<std::string> text = preregister(args);
  if (!text) return console.error(text.error().message);
  const Result<void> done =
      Output::create(args.out).and_then([&text](Output output) { return output.write_all(*text); });
  if (!done) console.error(done.error().message);
}

}  // namespace

void add_trial_preregister_command(CLI::App& trial, Console& console) {
  CLI::App* command = trial.add_subcommand(
      "preregister", "Write the preregistration of a study: hypotheses, exclusions, tests");
  const auto args = std::make_shared<PreregisterArguments>();
  command->add_option("STUDY", args->study, "The study, a .toml file with tables [[hypothesis]]")
      ->required();
  command->add_option("-o,--output", args->out, "The file to write, Markdown")
      ->capture_default_str();
  command->add_option("--people", args->people, "Planned number of participants")
      ->check(CLI::Range(kMinParticipants, kMaxParticipants))
      ->default_str("people in the study");
  command->footer(
      "The text has the fingerprints of the study and of the program, so that a reader of the\n"
      "export can see that nothing was changed. Complete the lines in brackets, and register the\n"
      "text before the first participant, for example at https://osf.io/prereg.\n" +
      examples("feltline trial preregister improving-sketching.toml -o preregistration.md"));
  command->callback([args, &console] { run_preregister(*args, console); });
}

}  // namespace felt::cli
