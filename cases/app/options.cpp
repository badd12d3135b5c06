#include "cases/app/options.hpp"

#include "cases/app/version.hpp"
#include "core/spelling.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>

namespace velum::cases {
namespace {

constexpr char const* exit_codes =
    "Exit codes: 0 done, 2 bad input, 3 diverged, 4 stopped by a signal or a limit.";

void add_common(CLI::App& command, Options& options)
{
  command.add_option("--threads", options.threads, "Number of threads (all of the machine's)")
      ->check(CLI::PositiveNumber)
      ->type_name("N");
  command.add_flag("--quiet", options.quiet, "No live line, no report: warnings and errors only");
  command.footer(std::string("--kokkos-* options pass through to Kokkos.\n") + exit_codes);
}

void add_set(CLI::App& command, Options& options)
{
  command
      .add_option("--set", options.set,
                  "Replaces a value of the scene: inlet.pressure=\"300 kPa\". May be repeated")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->allow_extra_args(false);
}

void add_unit(CLI::App& command, Options& options)
{
  command
      .add_option("--unit", options.unit,
                  "What one unit of the file is, which it does not tell: mm, or \"25.4 mm\"")
      ->required()
      ->type_name("UNIT");
}

void add_stl(CLI::App& command, Options& options)
{
  command.add_option("FILE", options.stl, "The STL file, binary or ASCII")
      ->required()
      ->type_name("");
  add_unit(command, options);
  command.add_option("--dx", options.dx, "Side of the lattice's cells: \"0.1 mm\"")
      ->required()
      ->type_name("LENGTH");
  command
      .add_option("--cut", options.cut,
                  "Draws the section with a plane and the lattice's solid cells in it: "
                  "\"x=0.5 mm\"; a plain number is in the file's unit")
      ->type_name("AXIS=PLACE");
  command
      .add_option("--out", options.out, "Folder of the section (results/<name of the STL file>)")
      ->type_name("DIR");
}

void add_mesh(CLI::App& app, Options& options)
{
  auto* mesh = app.add_subcommand(
      "mesh", "What is in a mesh file of Gmsh, and how good its triangles are for a membrane");
  mesh->add_option("FILE", options.mesh, "The MSH file, version 2.2 or 4.1, binary or ASCII")
      ->required()
      ->type_name("");
  add_unit(*mesh, options);
  mesh->add_flag("--json", options.json, "For machines");
  add_common(*mesh, options);
}

void add_scene(CLI::App& command, Options& options)
{
  command
      .add_option("SCENE", options.scene, "The scene file, such as cases/closed_valve/scene.toml")
      ->required()
      ->type_name("");
  add_set(command, options);
}

void add_out(CLI::App& command, Options& options, std::string const& otherwise)
{
  command.add_option("--out", options.out, "Folder of the results (" + otherwise + ")")
      ->type_name("DIR");
}

void add_chart(CLI::App& app, Options& options)
{
  auto* chart = app.add_subcommand(
      "chart", "Error against wall time over resolution, collision and precision; CSV and picture");
  chart
      ->add_option("SCENE", options.scenes,
                   "Scene files with a [reference], such as cases/pipe/scene.toml")
      ->required()
      ->type_name("");
  add_set(*chart, options);
  add_out(*chart, options, "results/chart");
  chart->add_flag("--quick", options.quick, "Without the finest resolution of each scene");
  add_common(*chart, options);
}

void add_sweep(CLI::App& app, Options& options)
{
  auto* sweep = app.add_subcommand(
      "sweep", "A scene once for every combination of some values; a table and a map of figures");
  add_scene(*sweep, options);
  sweep
      ->add_option("--over", options.over,
                   "A key and its values: inlet.pressure=\"50 kPa,100 kPa\". Commas within [] or "
                   "quotes belong to a value. Repeated, all combinations are run; the picture "
                   "shows one key or two, the first along x")
      ->required()
      ->type_name("KEY=V1,V2")
      ->take_all()
      ->allow_extra_args(false);
  sweep
      ->add_option("--show", options.show,
                   "A figure of summary.json to print and to draw (of a valve flow, gap, pressure "
                   "above and chatter; otherwise the first four that differ). May be repeated")
      ->type_name("FIGURE")
      ->take_all()
      ->allow_extra_args(false);
  add_out(*sweep, options, "results/sweep_<name of the scene>");
  add_common(*sweep, options);
  sweep->footer(
      "sweep.csv has a row for each run: the values, \"ok\" or why it failed, all figures. Runs "
      "are kept\nin folders of their own; what is done there is not run again, so that a sweep "
      "that was stopped\ngoes on with the same command.\n"
      "  velum sweep scene.toml --over inlet.pressure=\"50 kPa,100 kPa\" \\\n"
      "    --over \"membrane.thickness=1 mm,2 mm\" --show seat_force\n" +
      sweep->get_footer());
}

void add_limits(CLI::App& app, Options& options)
{
  auto* limits = app.add_subcommand(
      "limits",
      "Largest stable Reynolds and Mach numbers of each collision, with LES and without; or what a "
      "contact's stiffness costs and gives; CSV and picture");
  limits
      ->add_option("MAP", options.map,
                   "The flow to try: shear_layer, taylor_green, pressure_step; or contact_penalty: "
                   "penetration, errors and linear solves over the stiffness, by penalty and by "
                   "augmented Lagrangian")
      ->required()
      ->type_name("");
  limits
      ->add_option("--cells", options.cells,
                   "Cells across the flow (64, in space 32; half with --quick); of contact_penalty "
                   "rings of triangles (22; 12 with --quick)")
      ->check(CLI::Range(8, 4096))
      ->type_name("N");
  add_out(*limits, options, "results/limits_<MAP>");
  limits->add_flag("--quick", options.quick,
                   "Half the cells, at one Mach number; one stiffness in each decade");
  add_common(*limits, options);
}

void add_fit(CLI::App& app, Options& options)
{
  auto* fit = app.add_subcommand(
      "fit",
      "Laws of rubber from test data: neo-Hookean, Mooney-Rivlin of 2 and 5; material cards");
  fit->add_option("DATA", options.data,
                  "CSV files of uniaxial, equibiaxial, planar or bulge tests, fitted together; the "
                  "first line says \"# test = uniaxial\"")
      ->required()
      ->type_name("");
  fit->add_option("--model", options.model,
                  "One law alone: neo_hookean, mooney_rivlin_2, mooney_rivlin_5 (all)")
      ->type_name("LAW");
  fit->add_option("--from", options.from, "Smallest stretch to fit (all)")->type_name("STRETCH");
  fit->add_option("--to", options.to, "Largest stretch to fit (all): 2 is 100 % strain")
      ->type_name("STRETCH");
  fit->add_flag("--relative", options.relative,
                "Residuals count by their share of the stress, not by their size");
  add_out(*fit, options, "results/fit_<name of the first file>");
  add_common(*fit, options);
}

void add_plot(CLI::App& app, Options& options)
{
  auto* plot = app.add_subcommand(
      "plot", "Pictures of a run and one HTML page that holds them, its figures and assumptions");
  plot->add_option("RUN", options.run, "Folder of the results, such as results/closed_valve")
      ->required()
      ->type_name("");
  plot->add_option("--out", options.out, "Folder of the pictures and the page (RUN)")
      ->type_name("DIR");
  add_common(*plot, options);
}

void add_bench(CLI::App& app, Options& options)
{
  auto* bench = app.add_subcommand(
      "bench", "Speed of the lattice step per lattice, collision and storage, beside the memory's");
  bench
      ->add_option("--cells", options.cells,
                   "Cells along each side in space (128); in the plane "
                   "as many cells in all")
      ->check(CLI::Range(16, 512))
      ->type_name("N");
  bench->add_flag("--quick", options.quick, "Central moments only");
  bench->add_flag("--json", options.json, "For machines");
  add_common(*bench, options);
}

Command parsed(CLI::App const& app)
{
  std::string const name = app.get_subcommands().front()->get_name();
  return name == "run"      ? Command::run
         : name == "check"  ? Command::check
         : name == "stl"    ? Command::stl
         : name == "mesh"   ? Command::mesh
         : name == "chart"  ? Command::chart
         : name == "sweep"  ? Command::sweep
         : name == "limits" ? Command::limits
         : name == "fit"    ? Command::fit
         : name == "plot"   ? Command::plot
         : name == "bench"  ? Command::bench
                            : Command::info;
}

}  // namespace

CommandLine read_command_line(int argc, char const* const* argv)
{
  Options options{};
  std::vector<std::string> rest;
  for (int k = argc - 1; k > 0; --k) {  // CLI11 takes them last first
    std::string const argument = argv[k];
    if (argument.starts_with("--kokkos-"))
      options.kokkos.insert(options.kokkos.begin(), argument);
    else
      rest.push_back(argument);
  }

  CLI::App app("velum: lattice Boltzmann flow with membranes and contact, from scene files.",
               "velum");
  app.require_subcommand(1);
  app.set_version_flag("--version", "velum " + version());
  app.footer(std::string("velum COMMAND --help shows the options of a command.\n") + exit_codes);

  auto* run = app.add_subcommand("run", "March a scene and write its results to a folder");
  add_scene(*run, options);
  add_out(*run, options, "results/<name of the scene>, or that of the checkpoint");
  run->add_option("--restart", options.restart,
                  "Goes on from a checkpoint of an earlier run, checkpoint_a.h5 or checkpoint_b.h5 "
                  "in its results; the scene may differ in what drives it, and run longer")
      ->type_name("FILE");
  add_common(*run, options);

  auto* check = app.add_subcommand(
      "check",
      "Preflight: what a run would cost and where it would be inaccurate, without running");
  add_scene(*check, options);
  add_common(*check, options);

  auto* stl = app.add_subcommand(
      "stl", "Whether an STL file is a closed solid, and what a lattice would see of it");
  add_stl(*stl, options);
  add_common(*stl, options);
  add_mesh(app, options);
  add_chart(app, options);
  add_sweep(app, options);
  add_limits(app, options);
  add_fit(app, options);
  add_plot(app, options);
  add_bench(app, options);

  auto* info = app.add_subcommand("info", "Version, back ends, threads, libraries");
  add_common(*info, options);

  std::vector<std::string> const commands{"run",    "check", "stl",  "mesh",  "chart", "sweep",
                                          "limits", "fit",   "plot", "bench", "info"};
  if (argc > 1 && argv[1][0] != '-' &&
      std::find(commands.begin(), commands.end(), argv[1]) == commands.end()) {
    std::string const near = core::nearest(argv[1], commands);
    fmt::print(stderr, "{} is not a command of velum{} Commands: {}.\n", argv[1],
               near.empty() ? "." : fmt::format("; did you mean \"{}\"?", near),
               fmt::join(commands, ", "));
    return {{}, 2};
  }
  try {
    app.parse(std::move(rest));
  } catch (CLI::ParseError const& error) {
    return {{}, app.exit(error) == 0 ? 0 : 2};
  }
  options.command = parsed(app);
  return {std::move(options), 0};
}

}  // namespace velum::cases
