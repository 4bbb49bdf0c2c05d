#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "commands.h"
#include "felt/document/visible_strokes.h"
#include "felt/formats/format_traits.h"
#include "felt/tactile/seen_ink.h"
#include "felt/tactile/tactile_check.h"
#include "input.h"
#include "print.h"
#include "sketch_input.h"

namespace felt::cli {
namespace {

struct CheckArguments {
  std::string input;
  bool tactile = false;
  bool embossed = false;
  bool csv = false;
};

std::string_view rule_name(const TactileFault& fault) {
  return kTactileRuleNames[static_cast<std::size_t>(fault.rule)];
}

/// Describes a fault in one line, without its position.
std::string words_of(const TactileFault& f) {
  switch (f.rule) {
    case TactileRule::kGap:
      return fmt::format("{:.1f} mm between lines, for {:.0f} mm; at least {:.1f} mm", f.measured,
                         f.length_mm, f.limit);
    case TactileRule::kSmallShape:
      return fmt::format("a shape of {:.1f} mm; at least {:.1f} mm, or a dot", f.measured, f.limit);
    case TactileRule::kShortSide:
      return fmt::format("a side of {:.1f} mm; at least {:.1f} mm", f.measured, f.limit);
    case TactileRule::kNarrowArea:
      return fmt::format("an area {:.1f} mm wide; at least {:.1f} mm", f.measured, f.limit);
    case TactileRule::kLineStyles:
      return fmt::format("{:.0f} widths of lines; at most {:.0f}", f.measured, f.limit);
    case TactileRule::kAreaStyles:
      return fmt::format("areas of {:.0f} colours, which feel the same", f.measured);
    case TactileRule::kSize:
      return fmt::format("{:.0f} mm long or wide; at most {:.0f} mm (A4)", f.measured, f.limit);
    case TactileRule::kThinLine:
      return fmt::format("a line or dot {:.2f} mm wide; at least {:.1f} mm", f.measured, f.limit);
  }
  return {};
}

/// Names the ink that is not seen, because it is not raised.
void report_unseen(const std::string& name, const UnseenInk& unseen, Console& console) {
  constexpr std::size_t kNamed = 5;
  if (!unseen.strokes.empty()) {
    std::string names;
    for (std::size_t i = 0; i < std::min(kNamed, unseen.strokes.size()); ++i) {
      names += (i == 0 ? "" : ", ") + stroke_name(unseen.strokes[i]);
    }
    if (unseen.strokes.size() > kNamed) names += ", ...";
    console.notice(
        fmt::format("{}: {} too faint to see on this paper and will not be raised: {}", name,
                    unseen.strokes.size() == 1 ? std::string("1 line is")
                                               : fmt::format("{} lines are", unseen.strokes.size()),
                    names));
  }
  if (!unseen.fills.empty()) {
    console.notice(fmt::format("{}: {} too faint to see on this paper and will not be raised", name,
                               unseen.fills.size() == 1
                                   ? std::string("1 area is")
                                   : fmt::format("{} areas are", unseen.fills.size())));
  }
}

/// Says how far the drawing must be enlarged, and what remains then.
void report_enlargement(const std::string& name, const std::vector<TactileFault>& faults,
                        const Document& document, Rgba paper, Console& console) {
  const auto by_size = static_cast<std::size_t>(std::count_if(
      faults.begin(), faults.end(), [](const TactileFault& f) { return depends_on_size(f.rule); }));
  const double times = tactile_enlargement(faults);
  if (by_size == 0 || !std::isfinite(times)) return;
  const std::size_t others = faults.size() - by_size;
  std::string text = fmt::format("{}: enlarge {:.1f} times: then ", name, times);
  if (others == 0) {
    text += by_size == 1 ? "the fault goes" : fmt::format("all {} faults go", by_size);
  } else {
    text += fmt::format("{} of {} faults {}, and {} {}", by_size, faults.size(),
                        by_size == 1 ? "goes" : "go", others, others == 1 ? "remains" : "remain");
  }
  const Rect box = seen_bounds(document, paper);
  const auto [shorter, longer] = std::minmax({times * box.width(), times * box.height()});
  if (longer > TactileLimits::kLongMm || shorter > TactileLimits::kShortMm) {
    text += fmt::format(
        "; the drawing is then {:.0f} x {:.0f} mm, more than A4: leave out details, or print it in "
        "parts",
        times * box.width(), times * box.height());
  }
  console.summary(text);
}

void print_faults(const std::string& name, const std::vector<TactileFault>& faults) {
  for (const TactileFault& f : faults) {
    print("{}: {:.1f},{:.1f}: {}: {}\n", name, f.at.x, f.at.y, rule_name(f), words_of(f));
  }
  if (faults.empty()) print("{}: no faults\n", name);
}

void print_csv(const std::vector<TactileFault>& faults) {
  print("rule,x_mm,y_mm,measured,limit,length_mm,stroke,other\n");
  const auto id = [](StrokeId stroke) {
    return stroke.value == 0 ? std::string() : std::to_string(stroke.value);
  };
  for (const TactileFault& f : faults) {
    print("{},{:.2f},{:.2f},{:.2f},{:.2f},{:.2f},{},{}\n", rule_name(f), f.at.x, f.at.y, f.measured,
          f.limit, f.length_mm, id(f.stroke), id(f.other));
  }
}

void run_check(const CheckArguments& args, Console& console) {
  const Result<Input> input = Input::open(args.input);
  if (!input) return console.error(input_name(args.input) + ": " + input.error().message);
  const Result<Imported> opened = input->read_drawing({});
  if (!opened) return console.error(input->name() + ": " + opened.error().message);
  if (!report_notices(input->name(), opened->report, console)) return;
  TactileLimits limits;
  if (args.embossed) limits.gap_mm = TactileLimits::kEmbossedGapMm;
  const Document& document = opened->drawing.document;
  limits.paper = opened->drawing.page.paper;
  const Result<std::vector<TactileFault>> faults = check_tactile(document, limits);
  if (!faults) return console.error(input->name() + ": " + faults.error().message);
  report_unseen(input->name(), unseen_ink(document, limits.paper), console);
  args.csv ? print_csv(*faults) : print_faults(input->name(), *faults);
  report_enlargement(input->name(), *faults, document, limits.paper, console);
  if (!faults->empty()) console.set_failed();
}

}  // namespace

void add_check_command(CLI::App& app, Console& console) {
  CLI::App* command =
      app.add_subcommand("check", "Name what a fingertip could not tell apart in a raised drawing");
  const auto args = std::make_shared<CheckArguments>();
  command
      ->add_option("IN", args->input,
                   "A sketch, or raw pen strokes ('-' is stdin). Its format is detected from its "
                   "content: " +
                       readable_names())
      ->required();
  command->add_flag("--tactile", args->tactile, "Check the rules for raised lines")->required();
  command->add_flag("--embossed", args->embossed,
                    "Lines may be 3.2 mm apart, as embossers print them; swell paper needs 6.4 mm");
  command->add_flag("--csv", args->csv, "Print a table: rule, position, measure, limit, strokes");
  command->footer("The exit code is 1 if there is a fault. The rules: docs/guide/tactile.md.\n" +
                  examples("feltline check --tactile map.felt\n"
                           "feltline check --tactile --csv map.svg >faults.csv"));
  command->callback([args, &console] { run_check(*args, console); });
}

}  // namespace felt::cli
