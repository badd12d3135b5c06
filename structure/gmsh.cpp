#include "structure/gmsh.hpp"

#include "core/check.hpp"
#include "structure/gmsh_records.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <set>

namespace velum::structure {
namespace {

constexpr char const* save_again =
    "save it with \"gmsh -2 -format msh41\" (or msh22), in ASCII or binary";

std::string bytes_of(std::filesystem::path const& file)
{
  std::error_code error;
  auto const name = file.string();
  core::require(std::filesystem::exists(file, error), name + ": there is no such mesh file.");
  std::ifstream stream(file, std::ios::binary);
  core::require(!std::filesystem::is_directory(file, error) && stream.good(),
                name + ": the mesh file cannot be read.");
  return {std::istreambuf_iterator<char>(stream), {}};
}

enum class Version { msh22, msh41 };

/// The section $MeshFormat, which says how all others are written.
Version read_header(GmshSource& source)
{
  constexpr char const* first = "$MeshFormat, with which a mesh file of Gmsh begins";
  auto const word = source.word(first);
  if (word == "$NOD") source.refuse(std::string("this is MSH 1; ") + save_again + ".");
  if (word != "$MeshFormat") source.refuse(fmt::format("the file does not begin with {}.", first));
  auto const version = source.word("the version of the format");
  if (version != "2.2" && version != "4.1")
    source.refuse(fmt::format(
        "the version of the format is not one of those read, 2.2 and 4.1; {}.", save_again));
  auto const type = source.number("0 for ASCII, or 1 for binary");
  if (type != 0 && type != 1) source.refuse("a MSH file is ASCII (0) or binary (1).");
  auto const bytes = source.number("the size of a number");
  if (type == 1) {
    if (bytes != 8) source.refuse("numbers of a binary MSH file have 8 bytes.");
    source.binary = true;
    source.begin_values();
    auto const one = source.value<std::int32_t>("a 1 that tells the order of bytes");
    if (one == 1 << 24)
      source.refuse(
          "the file comes from a machine of the other byte order (big-endian); save it in ASCII.");
    if (one != 1) source.refuse("a binary MSH file has a 1 here that tells the order of bytes.");
  }
  source.expect("$EndMeshFormat");
  return version == "2.2" ? Version::msh22 : Version::msh41;
}

/// Text in binary files too: dimension, tag and name in quotes, one group a line.
void read_physical_names(GmshSource& source, GmshRecords& records)
{
  auto const count = source.number("the number of physical names");
  for (std::int64_t i = 0; i < count; ++i) {
    int tag[2];
    for (int& t : tag) {
      auto const value = source.number("dimension and tag of a physical group");
      if (value < 0 || value > INT32_MAX)
        source.refuse("dimension and tag of a physical group are whole numbers, not negative.");
      t = static_cast<int>(value);
    }
    auto const line = source.rest_of_line();
    auto const open = line.find('"'), close = line.rfind('"');
    if (open == close) source.refuse("the name of a physical group stands in quotes.");
    records.names[{tag[0], tag[1]}] = line.substr(open + 1, close - open - 1);
  }
  source.expect("$EndPhysicalNames");
}

GmshRecords read_sections(GmshSource& source, Version version)
{
  GmshRecords records;
  std::set<std::string, std::less<>> seen;
  bool const old = version == Version::msh22;
  while (!source.at_end()) {
    std::string const section(source.word("a section"));
    if (section.size() < 2 || section[0] != '$' || section.starts_with("$End"))
      source.refuse("a section of a MSH file begins here, with $ and its name.");
    bool const first = seen.insert(section).second;
    if (!first && (section == "$Nodes" || section == "$Elements"))
      source.refuse(fmt::format("a second {}; a MSH file has one.", section));
    if (section == "$ParametricNodes")
      source.refuse("parametric nodes are not read; save with Mesh.SaveParametric = 0.");
    if (section == "$PartitionedEntities")
      source.refuse("the mesh is cut in partitions; save it before it is partitioned.");
    if (section == "$PhysicalNames")
      read_physical_names(source, records);
    else if (section == "$Nodes")
      old ? read_nodes_22(source, records) : read_nodes_41(source, records);
    else if (section == "$Elements")
      old ? read_elements_22(source, records) : read_elements_41(source, records);
    else if (section == "$Entities" && !old)
      read_entities_41(source, records);
    else
      source.skip_past("$End" + section.substr(1));
  }
  for (char const* needed : {"$Nodes", "$Elements"})
    core::require(seen.contains(needed),
                  fmt::format("{}: the file has no section {}: it is truncated, or holds no mesh.",
                              source.name(), needed));
  return records;
}

}  // namespace

int gmsh_nodes(GmshSource const& source, std::int32_t type)
{
  static std::map<std::int32_t, char const*> const solids{
      {4, "tetrahedra"}, {5, "hexahedra"}, {6, "prisms"}, {7, "pyramids"}};
  if (type == 15) return 1;
  if (type == 1 || type == 2) return type + 1;
  constexpr char const* wanted = "a sheet is made of 3-node triangles";
  if (type == 3)
    source.refuse(
        fmt::format("the file has quadrilaterals, and {}: mesh without Recombine.", wanted));
  if (auto const solid = solids.find(type); solid != solids.end())
    source.refuse(fmt::format("the file has {}, and {}: save the surface alone (gmsh -2).",
                              solid->second, wanted));
  bool const line = type == 8, triangle = type == 9;
  source.refuse(
      fmt::format("the file has {}, and {}: save first-order triangles (Mesh.ElementOrder = 1).",
                  line       ? "second-order lines"
                  : triangle ? "second-order triangles (6 nodes)"
                             : fmt::format("elements of type {}", type),
                  wanted));
}

std::int32_t gmsh_group(GmshSource& source)
{
  auto const tag = source.value<std::int32_t>("the tag of a physical group");
  if (tag == INT32_MIN) source.refuse("the tag of a physical group is out of range.");
  return tag;
}

GmshMesh parse_gmsh(std::string bytes, std::string const& name, double unit)
{
  core::require(std::isfinite(unit) && unit > 0,
                name + ": the unit of a mesh file must be a positive length.");
  core::require(!bytes.empty(), name + ": the file is empty, and a MSH file holds a mesh.");
  GmshSource source(std::move(bytes), name);
  auto const version = read_header(source);
  auto mesh = surface_of(read_sections(source, version), unit, name);
  mesh.format = fmt::format("MSH {}, {}", version == Version::msh22 ? "2.2" : "4.1",
                            source.binary ? "binary" : "ASCII");
  return mesh;
}

GmshMesh read_gmsh(std::filesystem::path const& file, double unit)
{
  return parse_gmsh(bytes_of(file), file.string(), unit);
}

}  // namespace velum::structure
