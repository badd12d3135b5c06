#include "core/geometry/stl.hpp"

#include "core/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

namespace velum::core {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

// A binary file: 80 bytes of anything, the count of triangles (4 bytes), then for each triangle the
// normal and three corners (12 floats) and two bytes of anything.
constexpr std::size_t header_bytes = 84, facet_bytes = 50, normal_bytes = 12;

std::string bytes_of(std::filesystem::path const& file)
{
  std::error_code error;
  auto const name = file.string();
  require(std::filesystem::exists(file, error), name + ": there is no such STL file.");
  std::ifstream stream(file, std::ios::binary);
  require(!std::filesystem::is_directory(file, error) && stream.good(),
          name + ": the STL file cannot be read.");
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  require(!bytes.empty(), name + ": the file is empty, and an STL file holds triangles.");
  return bytes;
}

std::uint32_t promised_triangles(std::string const& bytes)
{
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_bytes - sizeof count, sizeof count);
  return count;
}

std::size_t promised_bytes(std::string const& bytes)
{
  return header_bytes + facet_bytes * std::size_t{promised_triangles(bytes)};
}

bool is_binary(std::string const& bytes)
{
  return bytes.size() >= header_bytes && bytes.size() == promised_bytes(bytes);
}

/// Text has no zero byte; in a binary file the count of triangles brings one.
bool is_text(std::string const& bytes) { return bytes.find('\0') == std::string::npos; }

[[noreturn]] void refuse_length(std::string const& bytes, std::string const& name)
{
  require(bytes.size() >= header_bytes,
          fmt::format("{}: the file has {} bytes; a binary STL file has at least {}, and an ASCII "
                      "one holds text only.",
                      name, bytes.size(), header_bytes));
  throw InputError(fmt::format(
      "{}: the header promises {} triangles, which take {} bytes, but the file has {}: it {}.",
      name, promised_triangles(bytes), promised_bytes(bytes), bytes.size(),
      bytes.size() < promised_bytes(bytes) ? "is truncated, or no STL file"
                                           : "holds something else besides, or is no STL file"));
}

std::vector<Facet> parse_binary_stl(std::string const& bytes, std::string const& name)
{
  std::vector<Facet> facets(promised_triangles(bytes));
  char const* at = bytes.data() + header_bytes + normal_bytes;
  for (std::size_t t = 0; t < facets.size(); ++t, at += facet_bytes) {
    float x[9];
    std::memcpy(x, at, sizeof x);
    require(std::all_of(x, x + 9, [](float v) { return std::isfinite(v); }),
            fmt::format("{}: triangle {} of {} has a corner that is not a finite number.", name,
                        t + 1, facets.size()));
    facets[t] = {Vec3{x[0], x[1], x[2]}, Vec3{x[3], x[4], x[5]}, Vec3{x[6], x[7], x[8]}};
  }
  return facets;
}

}  // namespace

TriangleMesh read_stl(std::filesystem::path const& file, double unit)
{
  auto const name = file.string();
  require(std::isfinite(unit) && unit > 0,
          name + ": the unit of an STL file must be a positive length.");
  auto const bytes = bytes_of(file);
  if (!is_binary(bytes) && !is_text(bytes)) refuse_length(bytes, name);

  auto facets = is_binary(bytes) ? parse_binary_stl(bytes, name) : parse_ascii_stl(bytes, name);
  require(!facets.empty(), name + ": the file holds no triangles.");
  for (auto& facet : facets)
    for (auto& corner : facet) corner *= unit;
  TriangleMesh mesh = merge(facets);
  require(!mesh.triangles.empty(),
          fmt::format("{}: none of the {} triangles has an area.", name, facets.size()));
  return mesh;
}

}  // namespace velum::core
