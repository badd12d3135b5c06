#include "cases/app/commands.hpp"
#include "cases/app/length_option.hpp"
#include "cases/app/plot_script.hpp"
#include "cases/app/section_picture.hpp"
#include "core/check.hpp"
#include "core/geometry/solid_cells.hpp"
#include "core/geometry/stl.hpp"
#include "core/geometry/stl_report.hpp"
#include "core/output/folder.hpp"
#include "core/quantity.hpp"
#include "core/readable_length.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>
#include <string_view>

namespace velum::cases {
namespace {

constexpr double most_cells = 4e6;  // of a section: some seconds of distances, a readable picture

bool is_plain_number(std::string_view text)
{
  double value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

/// "x=0.5 mm", or "x=0.5" in the file's unit.
core::CutPlane cut_plane(std::string const& text, double unit)
{
  auto const axis = std::string_view("xyz").find(text.empty() ? ' ' : text[0]);
  core::require(text.size() > 2 && axis != std::string_view::npos && text[1] == '=',
                fmt::format("--cut: \"{}\" is no plane: write x, y or z and its place, for example "
                            "\"x=0.5 mm\", or \"x=0.5\" in the file's unit.",
                            text));
  std::string const place = text.substr(2);
  double const at = parse_option("--cut", [&] {
    return is_plain_number(place)
               ? unit * core::parse_quantity(place, core::Dimension::dimensionless)
               : core::parse_quantity(place, core::Dimension::length);
  });
  return {static_cast<int>(axis), at};
}

void write_cut(Options const& options, core::TriangleMesh const& mesh, core::CutPlane const& plane,
               double dx)
{
  auto const box = core::bounds(mesh);
  char const letter = "xyz"[plane.axis];
  auto const lines = core::section(mesh, plane);
  core::require(!lines.empty(),
                fmt::format("--cut: the plane {} = {} does not cut the solid, which goes from {} "
                            "to {}.",
                            letter, core::readable_length(plane.at),
                            core::readable_length(box.lo[plane.axis]),
                            core::readable_length(box.hi[plane.axis])));
  double const cells = core::cells_in_section(box, plane, dx);
  core::require(cells <= most_cells,
                fmt::format("--cut: the section has {:.2g} cells of {}, and a picture at most "
                            "{:.2g}; choose a larger --dx.",
                            cells, core::readable_length(dx), most_cells));

  auto const folder =
      core::make_folder(options.out.empty() ? "results" / options.stl.stem() : options.out);
  auto const file = [&](char const* what, char const* kind) {
    return folder / fmt::format("{}_{}.{}", what, letter, kind);
  };
  core::write_section(file("section", "csv"), lines, plane);
  core::write_cells(file("cells", "csv"),
                    core::solid_cells(core::mesh_distance(mesh), box, plane, dx), plane);
  fmt::print("cut       {} = {}: {}, {}\n", letter, core::readable_length(plane.at),
             file("section", "csv").string(), file("cells", "csv").filename().string());
  if (draw_section(file("section", "csv"), file("cells", "csv"), file("section", "png")))
    fmt::print("          picture {}\n", file("section", "png").string());
  else
    fmt::print(
        "          no picture: it takes a Python with matplotlib, which PYTHON may name, and "
        "{}\n",
        plot_script(section_script).string());
}

}  // namespace

void stl_command(Options const& options)
{
  double const unit = file_unit(options.unit), dx = positive_length("--dx", options.dx);
  bool const cuts = !options.cut.empty();
  auto const plane = cuts ? cut_plane(options.cut, unit) : core::CutPlane{};
  auto const mesh = core::read_stl(options.stl, unit);
  fmt::print("{}\n{}", options.stl.string(), core::text(core::report(mesh, dx)));
  std::fflush(stdout);
  if (cuts) write_cut(options, mesh, plane, dx);
}

}  // namespace velum::cases
