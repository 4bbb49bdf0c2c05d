#include <fmt/core.h>

#include <algorithm>
#include <memory>

#include "commands.h"
#include "felt/base/read_file.h"
#include "felt/io/ndjson/json_text.h"
#include "felt/material/material_fields.h"
#include "known_materials.h"
#include "print.h"
#include "text_table.h"

namespace felt::cli {
namespace {

constexpr const char* kBuiltIn = "Feltline";

/// A material and its location. The location is empty for a built-in material.
struct Row {
  AnyMaterial material;
  std::string path;
};

std::vector<Row> rows_of(const MaterialLibrary& library) {
  std::vector<Row> rows;
  const auto add = [&](const AnyMaterial& material) {
    const auto own =
        std::find_if(library.own.begin(), library.own.end(), [&](const MaterialEntry& entry) {
          return material_key(entry.material) == material_key(material);
        });
    rows.push_back({material, own == library.own.end() ? "" : own->path});
  };
  for (const SurfaceMaterial& surface : library.materials.surfaces()) add(surface);
  for (const Medium& medium : library.materials.media()) add(medium);
  return rows;
}

double friction_in(const AnyMaterial& material) {
  const auto* surface = std::get_if<SurfaceMaterial>(&material);
  return surface ? surface->friction : std::get<Medium>(material).friction;
}

std::string figures_of(const SurfaceMaterial& surface) {
  std::string text = fmt::format("{:g} N/m, ", surface.stiffness_n_per_m);
  if (!(surface.grain_um > 0.0)) return text + "smooth";
  const auto character = static_cast<std::size_t>(surface.grain_character);
  return text + fmt::format("{} {:g} um high, {:g} mm wide", kGrainCharacters[character],
                            surface.grain_um, surface.grain_mm);
}

std::string figures_of(const Medium& medium) {
  if (!medium.draws) return "erases";
  std::string text = fmt::format("{:g} to {:g} mm", medium.line.min_mm, medium.line.max_mm);
  if (medium.look.grain == 0.0) text += ", wet";
  if (medium.wear > 0.0) text += fmt::format(", wears {:g} % of the grain", 100.0 * medium.wear);
  return text;
}

void print_table(const MaterialLibrary& library) {
  TextTable table(
      {{"id"}, {"kind"}, {"friction", TextTable::Align::kRight}, {"figures"}, {"from"}});
  for (const Row& row : rows_of(library)) {
    table.add_row({id_of(row.material), std::string(kind_of(row.material)),
                   fmt::format("{:.2f}", friction_in(row.material)),
                   std::visit([](const auto& one) { return figures_of(one); }, row.material),
                   row.path.empty() ? kBuiltIn : row.path});
  }
  print("{}", table.text(TextStyle::of_stdout()));
}

template <class Material, class Field>
std::string figures_json(const Material& material, std::span<const Field> fields) {
  JsonObject object;
  for (const Field& field : fields) {
    const double value = field.get(material);
    switch (field.kind) {
      case MaterialFieldKind::kSwitch:
        object.add_raw(field.id, value != 0.0 ? "true" : "false");
        break;
      case MaterialFieldKind::kChoice:
        object.add_text(field.id, field.choices[static_cast<std::size_t>(value)]);
        break;
      case MaterialFieldKind::kColor:
        object.add_text(field.id, fmt::format("#{:06x}", static_cast<unsigned>(value)));
        break;
      case MaterialFieldKind::kNumber:
      case MaterialFieldKind::kWhole:
        object.add_number(field.id, value);
        break;
    }
  }
  return object.text();
}

std::string pairs_json(const Medium& medium) {
  JsonObject object;
  for (const PairFriction& pair : medium.pairs) object.add_number(pair.surface, pair.coefficient);
  return object.text();
}

std::string row_json(const Row& row) {
  JsonObject object;
  object.add_text("id", id_of(row.material));
  object.add_text("kind", kind_of(row.material));
  object.add_text("label", label_of(row.material));
  object.add_raw("path", row.path.empty() ? "null" : json_string(row.path));
  if (const auto* surface = std::get_if<SurfaceMaterial>(&row.material)) {
    object.add_raw("figures", figures_json(*surface, surface_fields()));
    object.add_raw("own_relief", surface->picture ? "true" : "false");
  } else {
    const auto& medium = std::get<Medium>(row.material);
    object.add_raw("figures", figures_json(medium, medium_fields()));
    object.add_raw("pairs", pairs_json(medium));
  }
  return object.text() + "\n";
}

void list(bool as_json, Console& console) {
  const MaterialLibrary& library = known_materials(console);
  if (!as_json) return print_table(library);
  for (const Row& row : rows_of(library)) print("{}", row_json(row));
}

/// Returns the surface or medium with this id. Fails if it does not exist; the message lists the
/// known ids.
Result<AnyMaterial> find_any(const std::string& id, Console& console) {
  std::string known;
  for (const Row& row : rows_of(known_materials(console))) {
    if (id_of(row.material) == id) return row.material;
    known += (known.empty() ? "" : ", ") + id_of(row.material);
  }
  return fail(ErrorCode::kNotFound, "there is no material \"" + id + "\"; there are " + known);
}

void show(const std::string& id, Console& console) {
  for (const BuiltInText& built_in : built_in_texts()) {
    if (built_in.id == id) return print("{}", built_in.text);
  }
  const Result<AnyMaterial> material = find_any(id, console);
  if (!material) return console.error(material.error().message);
  print("{}", write_material(*material));
}

void check(const std::vector<std::string>& files, Console& console) {
  for (const std::string& file : files) {
    const Result<std::string> text = file == "-" ? read_file(file, kMaxMaterialBytes)
                                                 : read_regular_file(file, kMaxMaterialBytes);
    if (!text) {
      console.error(text.error().message);
      continue;
    }
    const MaterialSource source = material_source(file, load_height_picture);
    const std::vector<Error> problems = material_problems(*text, source);
    for (const Error& problem : problems) console.error(problem.message);
    if (!problems.empty()) continue;
    const Result<AnyMaterial> material = read_material(*text, source);
    const std::string taken = new_id_error(id_of(*material));
    const std::string note =
        taken.empty() ? "" : " (can be read, but not saved as a custom material: " + taken + ")";
    print("{}: {} {}{}\n", source.name, kind_of(*material), id_of(*material), note);
  }
}

struct NewArguments {
  std::string id;
  std::string from = "paper";
  bool save = false;
};

void make_new(const NewArguments& args, Console& console) {
  if (const std::string wrong = new_id_error(args.id); !wrong.empty()) throw UsageError(wrong);
  Result<AnyMaterial> material = find_any(args.from, console);
  if (!material) throw UsageError("--from: " + material.error().message);
  std::visit(
      [&](auto& one) {
        one.id = args.id;
        one.label = label_of_id(args.id);
      },
      *material);
  if (!args.save) return print("{}", write_material(*material));
  for (const MaterialEntry& own : known_materials(console).own) {
    if (id_of(own.material) == args.id) {
      return console.error(own.path + " is " + args.id + " already; it was not changed");
    }
  }
  const Result<std::string> path = save_material(material_folders().front(), *material);
  if (!path) return console.error(path.error().message);
  print("{}\n", *path);
}

void add_show(CLI::App& materials, Console& console) {
  CLI::App* command = materials.add_subcommand("show", "Write the text of a material to stdout");
  const auto id = std::make_shared<std::string>();
  command->add_option("ID", *id, "A material that 'feltline materials' lists")->required();
  command->footer(
      examples("feltline materials show charcoal\n"
               "feltline materials show my-paper > to-give-away.toml"));
  command->callback([id, &console] { show(*id, console); });
}

void add_check(CLI::App& materials, Console& console) {
  CLI::App* command =
      materials.add_subcommand("check", "Check material files and report errors with their lines");
  const auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("FILE", *files, "Material files; '-' is stdin")->required();
  command->footer(examples("feltline materials check my-paper.toml\n"
                           "feltline materials show paper | feltline materials check -") +
                  "\n\nThe exit code is 1 if a file has an error.");
  command->callback([files, &console] { check(*files, console); });
}

void add_new(CLI::App& materials, Console& console) {
  CLI::App* command = materials.add_subcommand(
      "new", "Write the text of a new material, with the values of another one");
  const auto args = std::make_shared<NewArguments>();
  command->add_option("ID", args->id, "Its id: a-z, 0-9 and '-', not that of a built-in material")
      ->required();
  command->add_option("--from", args->from, "The material to copy the values from")
      ->capture_default_str();
  command->add_flag(
      "--save", args->save,
      "Save it in the folder of custom materials and print its path, instead of writing to stdout");
  command->footer(
      examples("feltline materials new my-paper > my-paper.toml\n"
               "feltline materials new my-chalk --from chalk --save"));
  command->callback([args, &console] { make_new(*args, console); });
}

}  // namespace

void add_materials_command(CLI::App& app, Console& console) {
  CLI::App* command = app.add_subcommand(
      "materials", "List surfaces and media; show, check and create custom ones");
  const auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "Print one line of JSON for each");
  command->footer(
      examples(
          "feltline materials\n"
          "feltline materials new my-paper --from rough-paper --save\n"
          "feltline replay cat.ndjson -o cat.png --surface my-paper --medium charcoal --grain") +
      "\n\nCustom materials are *.toml files in feltline/materials of $XDG_DATA_HOME\n"
      "(~/.local/share by default) and of $XDG_DATA_DIRS. Format: docs/formats/material.md.");
  command->require_subcommand(0, 1);
  add_show(*command, console);
  add_check(*command, console);
  add_new(*command, console);
  command->callback([command, json, &console] {
    if (command->get_subcommands().empty()) list(*json, console);
  });
}

}  // namespace felt::cli
