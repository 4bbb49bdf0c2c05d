#include <memory>

#include "commands.h"
#include "felt/formats/format_traits.h"
#include "felt/io/ndjson/json_text.h"
#include "print.h"
#include "text_table.h"

namespace felt::cli {
namespace {

const char* yes_no(bool is) {
  return is ? "yes" : "no";
}

std::string endings_of(const FormatTraits& row) {
  std::string text;
  for (const std::string_view ending : row.endings) {
    text += (text.empty() ? "" : " ") + std::string(ending);
  }
  return text;
}

std::string table_text() {
  TextTable table({{"format"}, {"endings"}, {"read"}, {"written"}, {"layers"}, {"what it keeps"}});
  for (const FormatTraits& row : format_table()) {
    table.add_row({std::string(row.name), endings_of(row), yes_no(row.reads), yes_no(row.writes),
                   yes_no(row.layers), std::string(row.kept)});
  }
  return table.text(TextStyle::of_stdout());
}

std::string row_json(const FormatTraits& row) {
  const auto flag = [](bool is) { return is ? "true" : "false"; };
  const auto texts = [](std::span<const std::string_view> words) {
    std::vector<std::string> values;
    for (const std::string_view word : words) values.push_back(json_string(word));
    return json_array(values);
  };
  JsonObject object;
  object.add_text("name", row.name);
  object.add_text("title", row.title);
  object.add_raw("endings", texts(row.endings));
  object.add_raw("media_types", texts(row.media_types));
  object.add_raw("read", flag(row.reads));
  object.add_raw("written", flag(row.writes));
  object.add_raw("layers", flag(row.layers));
  object.add_raw("page", flag(row.page));
  object.add_raw("lossless", flag(row.lossless));
  object.add_text("widths", row.widths);
  object.add_text("taken", row.taken);
  object.add_text("kept", row.kept);
  return object.text() + "\n";
}

}  // namespace

void add_formats_command(CLI::App& app) {
  CLI::App* command =
      app.add_subcommand("formats", "List the supported formats and what each keeps");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print one line of JSON for each");
  command->footer(
      examples("feltline formats\n"
               "feltline formats --json"));
  command->callback([json] {
    if (!*json) return print("{}", table_text());
    for (const FormatTraits& row : format_table()) print("{}", row_json(row));
  });
}

}  // namespace felt::cli
