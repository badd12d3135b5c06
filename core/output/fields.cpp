#include "core/output/fields.hpp"

#include "core/check.hpp"
#include "core/output/folder.hpp"
#include "core/output/hdf5.hpp"
#include "core/output/xdmf.hpp"

#include <fmt/format.h>

#include <numeric>
#include <set>
#include <string_view>
#include <utility>

namespace velum::core {
namespace {

constexpr std::string_view data_name = "run.h5";

hid_t type_of(std::vector<float> const&) { return H5T_NATIVE_FLOAT; }
hid_t type_of(std::vector<double> const&) { return H5T_NATIVE_DOUBLE; }
hid_t type_of(std::vector<std::int32_t> const&) { return H5T_NATIVE_INT32; }

std::string dump_name(int number) { return fmt::format("dump_{:06}", number); }

char const* name_of(Symmetry symmetry)
{
  switch (symmetry) {
    case Symmetry::planar:
      return "planar";
    case Symmetry::axisymmetric:
      return "axisymmetric";
    case Symmetry::none:
      break;
  }
  return "none";
}

void describe(hid_t root, Grid const& grid)
{
  hdf5::write_attribute(root, "nx", grid.nx);
  hdf5::write_attribute(root, "ny", grid.ny);
  hdf5::write_attribute(root, "dx [m]", grid.dx);
  hdf5::write_attribute(root, "origin axial [m]", grid.origin[0]);
  hdf5::write_attribute(root, "origin radial [m]", grid.origin[1]);
  if (dimensions(grid.symmetry) == 3) {
    hdf5::write_attribute(root, "nz", grid.nz);
    hdf5::write_attribute(root, "origin third [m]", grid.origin[2]);
  }
  hdf5::write_attribute(root, "symmetry", name_of(grid.symmetry));
}

/// Claims a name within one group.
void claim(std::set<std::string>& taken, std::string const& name)
{
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  require(!name.empty() && name.find_first_not_of(allowed) == std::string::npos,
          fmt::format("\"{}\" cannot name an output: use letters, digits, '_' and '-'.", name));
  require(taken.insert(name).second, fmt::format("Two outputs are named \"{}\".", name));
}

/// Writes one array into a group and describes it for the index.
/// @param extents  of the cells or nodes, without the components
xdmf::Array write(hid_t group, std::string const& group_path, Field const& field,
                  std::vector<hsize_t> extents)
{
  if (field.components > 1) extents.push_back(static_cast<hsize_t>(field.components));
  hsize_t needed = 1;
  for (hsize_t const extent : extents) needed *= extent;
  return std::visit(
      [&](auto const& values) {
        require(values.size() == needed,
                fmt::format("Output \"{}\" has {} values where {} are needed.", field.name,
                            values.size(), needed));
        hid_t const type = type_of(values);
        auto const array = hdf5::write_array(group, field.name, type, values.data(), extents);
        hdf5::write_attribute(array, "unit", field.unit);
        return xdmf::Array{field.name,
                           fmt::format("{}:{}/{}", data_name, group_path, field.name),
                           {extents.begin(), extents.end()},
                           field.components,
                           H5Tget_class(type) == H5T_INTEGER ? "Int" : "Float",
                           H5Tget_size(type)};
      },
      field.values);
}

std::vector<xdmf::Array> write_all(hid_t group, std::string const& group_path,
                                   std::vector<Field> const& fields,
                                   std::vector<hsize_t> const& extents, std::set<std::string> taken)
{
  std::vector<xdmf::Array> arrays;
  for (auto const& field : fields) {
    claim(taken, field.name);
    arrays.push_back(write(group, group_path, field, extents));
  }
  return arrays;
}

std::string write_curve(hid_t dump, std::string const& dump_path, Curve const& curve)
{
  std::string const path = dump_path + "/" + curve.name;
  require(curve.nodes.size() >= 2,
          fmt::format("Curve \"{}\" needs at least two nodes to be drawn.", curve.name));
  auto const group = hdf5::create_group(dump, curve.name);
  std::vector<hsize_t> const extents{curve.nodes.size()};

  std::vector<std::int32_t> numbers(curve.nodes.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  auto const nodes = write(group, path, vector_field("nodes", "m", curve.nodes), extents);
  auto const list = write(group, path, {"node_list", "1", 1, std::move(numbers)}, extents);
  auto const fields = write_all(group, path, curve.fields, extents, {"nodes", "node_list"});
  return xdmf::curve(curve.name, nodes, list, fields);
}

std::string write_surface(hid_t dump, std::string const& dump_path, Surface const& surface)
{
  std::string const path = dump_path + "/" + surface.name;
  auto const group = hdf5::create_group(dump, surface.name);
  std::vector<double> places;
  for (auto const& p : surface.nodes) places.insert(places.end(), {p[0], p[1], p[2]});
  std::vector<std::int32_t> corners;
  for (auto const& t : surface.triangles) corners.insert(corners.end(), t.begin(), t.end());
  auto const nodes =
      write(group, path, {"nodes", "m", 3, std::move(places)}, {surface.nodes.size()});
  auto const triangles =
      write(group, path, {"triangles", "1", 3, std::move(corners)}, {surface.triangles.size()});
  auto const fields =
      write_all(group, path, surface.fields, {surface.nodes.size()}, {"nodes", "triangles"});
  return xdmf::surface(surface.name, nodes, triangles, fields);
}

}  // namespace

Field vector_field(std::string name, std::string unit, std::vector<Vec2> const& values)
{
  std::vector<double> flat;
  flat.reserve(3 * values.size());
  for (auto const& value : values) flat.insert(flat.end(), {value[0], value[1], 0.0});
  return {std::move(name), std::move(unit), 3, std::move(flat)};
}

Field vector_field(std::string name, std::string unit, std::vector<Vec3> const& values)
{
  std::vector<float> flat;  // a field in space is large, and drawn
  flat.reserve(3 * values.size());
  for (auto const& value : values)
    for (double const component : value.c) flat.push_back(static_cast<float>(component));
  return {std::move(name), std::move(unit), 3, std::move(flat)};
}

FieldsFile create_fields(std::filesystem::path const& folder, std::optional<Grid> const& grid,
                         Assumptions const& assumptions)
{
  FieldsFile file{folder / data_name, folder / "run.xmf", grid, 0, ""};
  auto const root = hdf5::create_file(file.data);
  if (grid) describe(root, *grid);
  for (auto const& [name, text] : assumptions)
    hdf5::write_attribute(root, "assumption: " + name, text);
  write_atomically(file.index, xdmf::index(file.times));
  return file;
}

FieldsFile resume_fields(std::filesystem::path const& folder, std::optional<Grid> const& grid,
                         int dumps, std::string times)
{
  FieldsFile file{folder / data_name, folder / "run.xmf", grid, dumps, std::move(times)};
  {
    auto const root = hdf5::open_file(file.data);
    require(dumps == 0 || hdf5::contains(root, dump_name(dumps - 1)),
            fmt::format("{} has fewer dumps than the run had written.", file.data.string()));
    // one that was cut short by the end of the earlier run is the last
    for (int k = dumps; hdf5::contains(root, dump_name(k)); ++k) hdf5::remove(root, dump_name(k));
  }
  write_atomically(file.index, xdmf::index(file.times));
  return file;
}

void write_fields(FieldsFile& file, double time, std::vector<Field> const& fluid,
                  std::vector<Curve> const& curves, std::vector<Surface> const& surfaces)
{
  std::string members;
  {
    auto const root = hdf5::open_file(file.data);
    std::string const name = dump_name(file.dumps), path = "/" + name;
    auto const dump = hdf5::create_group(root, name);
    hdf5::write_attribute(dump, "time", time);

    if (file.grid) {
      auto const group = hdf5::create_group(dump, "fluid");
      std::vector<hsize_t> cells{static_cast<hsize_t>(file.grid->ny),
                                 static_cast<hsize_t>(file.grid->nx)};
      if (dimensions(file.grid->symmetry) == 3)
        cells.insert(cells.begin(), static_cast<hsize_t>(file.grid->nz));
      members = xdmf::fluid(*file.grid, write_all(group, path + "/fluid", fluid, cells, {}));
    }

    std::set<std::string> taken{"fluid"};
    for (auto const& curve : curves) {
      claim(taken, curve.name);
      members += write_curve(dump, path, curve);
    }
    for (auto const& surface : surfaces) {
      claim(taken, surface.name);
      members += write_surface(dump, path, surface);
    }
  }
  // Only now that the arrays are on the disk may the index name them.
  ++file.dumps;
  file.times += xdmf::at_time(time, members);
  write_atomically(file.index, xdmf::index(file.times));
}

}  // namespace velum::core
