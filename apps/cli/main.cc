/// The command line program: `feltline COMMAND ...`.
/// Exit codes: 0 all is well, 1 something failed (and stderr says what), 2 wrong usage.

#include <fmt/core.h>

#include <charconv>
#include <csignal>
#include <cstdio>
#include <new>

#include "commands.h"

namespace felt::cli {
namespace {

constexpr const char* kDescription =
    "From raw pen samples to smooth variable-width curves.\n"
    "stdout carries data, stderr errors and progress; '-' stands for stdin or stdout.";

void add_commands(CLI::App& app, Console& console) {
  app.require_subcommand(1);
  app.fallthrough();
  app.set_help_flag("-h,--help", "Show this help and exit");
  app.set_version_flag("--version", "feltline " FELT_VERSION, "Show the version and exit");
  app.add_flag_callback(
      "-q,--quiet", [&console] { console.set_quiet(); },
      "Neither progress nor notices on stderr, errors only");
  app.add_flag_callback(
      "--strict", [&console] { console.set_strict(); },
      "What a file holds and cannot be taken is an error, not a notice");
  app.footer(
      examples("feltline fit strokes.ndjson -o sketch.svg\n"
               "feltline render sketch.ndjson -o page.png --page A4\n"
               "feltline COMMAND --help"));
  add_fit_command(app, console);
  add_render_command(app, console);
  add_convert_command(app, console);
  add_info_command(app, console);
  add_formats_command(app);
  add_recover_command(app, console);
  add_replay_command(app, console);
  add_demo_command(app, console);
  add_tools_command(app, console);
  add_materials_command(app, console);
  add_devices_command(app, console);
  add_doctor_command(app, console);
  add_device_test_command(app, console);
  add_record_command(app, console);
  add_bench_command(app, console);
}

/// CLI11 reports an unknown command as a missing one.
void check_command_name(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->check_name(argv[1])) return;
  }
  throw UsageError(fmt::format("there is no command '{}'", argv[1]));
}

int report_usage(const CLI::App& app, const CLI::Error& error) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  const std::string name = commands.empty() ? "" : " " + commands.front()->get_name();
  fmt::print(stderr, "feltline: {}\nTry 'feltline{} --help'.\n", error.what(), name);
  return 2;
}

int run(int argc, char** argv) {
  // A reader that has seen enough ends us without a word, also when our parent ignores SIGPIPE.
  std::signal(SIGPIPE, SIG_DFL);
  Console console;
  CLI::App app(kDescription, "feltline");
  try {
    add_commands(app, console);
    check_command_name(app, argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::Error& error) {
    console.end_progress();
    return report_usage(app, error);
  } catch (const std::bad_alloc&) {
    console.error("not enough memory");
  }
  if (std::fflush(stdout) != 0) console.error("stdout: cannot write");
  return console.failed() ? 1 : 0;
}

}  // namespace

CLI::Validator number_between(double low, double high) {
  const std::string range = fmt::format("{:g}..{:g}", low, high);
  const auto check = [low, high, range](const std::string& text) -> std::string {
    double number = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool fine =
        error == std::errc() && end == text.data() + text.size() && number >= low && number <= high;
    return fine ? "" : "'" + text + "' is not a number in " + range;
  };
  return CLI::Validator(check, range);
}

std::string examples(const std::string& lines) {
  std::string text = "Examples:\n  ";
  for (const char c : lines) text += c == '\n' ? std::string("\n  ") : std::string(1, c);
  return text;
}

}  // namespace felt::cli

int main(int argc, char** argv) {
  return felt::cli::run(argc, argv);
}
