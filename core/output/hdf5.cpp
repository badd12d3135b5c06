#include "core/output/hdf5.hpp"

#include "core/check.hpp"

#include <algorithm>
#include <cstddef>

namespace velum::core::hdf5 {
namespace {

void check(herr_t status, std::string const& what)
{
  require(status >= 0, what + " cannot be written: is the disk full?");
}

Handle checked(hid_t id, herr_t (*close)(hid_t), std::string const& what)
{
  require(id >= 0, what + " cannot be written: is the disk full?");
  return {id, close};
}

/// Without file locks, so that a reader may look at the file while the run goes on: what the reader
/// knows of (see fields.hpp) is never written again.
Handle access_without_locks()
{
  H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);  // failures are reported here, not by the library
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access, false, true);
  return access;
}

void write_scalar(hid_t object, std::string const& name, hid_t type, void const* value)
{
  Handle const space(H5Screate(H5S_SCALAR), H5Sclose);
  auto const attribute = checked(
      H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose, name);
  check(H5Awrite(attribute, type, value), name);
}

}  // namespace

Handle create_file(std::filesystem::path const& path)
{
  hid_t const id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access_without_locks());
  require(id >= 0, path.string() + " cannot be written.");
  return {id, H5Fclose};
}

Handle open_file(std::filesystem::path const& path)
{
  hid_t const id = H5Fopen(path.c_str(), H5F_ACC_RDWR, access_without_locks());
  require(id >= 0, path.string() + " cannot be opened any more: was it moved or damaged?");
  return {id, H5Fclose};
}

Handle create_group(hid_t parent, std::string const& name)
{
  return checked(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
                 name);
}

bool contains(hid_t parent, std::string const& name)
{
  return H5Lexists(parent, name.c_str(), H5P_DEFAULT) > 0;
}

void remove(hid_t parent, std::string const& name)
{
  check(H5Ldelete(parent, name.c_str(), H5P_DEFAULT), name);
}

void write_attribute(hid_t object, std::string const& name, std::string const& text)
{
  Handle const type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, H5T_VARIABLE);  // Python reads it as text, one of fixed size as bytes
  H5Tset_cset(type, H5T_CSET_UTF8);
  char const* const start = text.c_str();
  write_scalar(object, name, type, &start);
}

void write_attribute(hid_t object, std::string const& name, double value)
{
  write_scalar(object, name, H5T_NATIVE_DOUBLE, &value);
}

void write_attribute(hid_t object, std::string const& name, int value)
{
  write_scalar(object, name, H5T_NATIVE_INT, &value);
}

Handle write_array(hid_t parent, std::string const& name, hid_t type, void const* values,
                   std::vector<hsize_t> const& extents)
{
  hsize_t row = H5Tget_size(type);
  for (std::size_t d = 1; d < extents.size(); ++d) row *= extents[d];
  std::vector<hsize_t> chunk = extents;
  chunk[0] = std::clamp<hsize_t>((1 << 20) / std::max<hsize_t>(row, 1), 1, extents[0]);

  Handle const layout(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_chunk(layout, static_cast<int>(chunk.size()), chunk.data());
  H5Pset_shuffle(layout);
  H5Pset_deflate(layout, 4);
  Handle const space(H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr),
                     H5Sclose);
  auto array =
      checked(H5Dcreate2(parent, name.c_str(), type, space, H5P_DEFAULT, layout, H5P_DEFAULT),
              H5Dclose, name);
  check(H5Dwrite(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), name);
  return array;
}

}  // namespace velum::core::hdf5
