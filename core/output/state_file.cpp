#include "core/output/state_file.hpp"

#include "core/check.hpp"
#include "core/output/hdf5.hpp"

#include <fmt/format.h>

#include <optional>
#include <system_error>

namespace velum::core {

struct StateFile::File {
  std::filesystem::path path, part;  // part: where it is written
  std::optional<hdf5::Handle> handle;
  bool reading;
};

namespace {

void transfer(hid_t file, bool reading, std::filesystem::path const& path, std::string const& name,
              hid_t type, void* values, std::size_t count)
{
  if (reading) {
    hdf5::Handle const array(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
    require(array >= 0, fmt::format("{} has no \"{}\": it is not the state of such a scene.",
                                    path.string(), name));
    hdf5::Handle const space(H5Dget_space(array), H5Sclose);
    auto const found = H5Sget_simple_extent_npoints(space);
    require(found == static_cast<hssize_t>(count),
            fmt::format("{} has {} numbers in \"{}\" where this scene has {}: it is the state of "
                        "another lattice or membrane.",
                        path.string(), found, name, count));
    require(H5Dread(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0,
            fmt::format("{} is damaged: \"{}\" cannot be read.", path.string(), name));
    return;
  }
  hsize_t const extent = count;
  hdf5::Handle const space(H5Screate_simple(1, &extent, nullptr), H5Sclose);
  hdf5::Handle const array(
      H5Dcreate2(file, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  require(array >= 0 && H5Dwrite(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) >= 0,
          fmt::format("{} cannot be written: is the disk full?", path.string()));
}

}  // namespace

StateFile::StateFile(std::unique_ptr<File> file) : file_(std::move(file)) {}
StateFile::StateFile(StateFile&&) noexcept = default;
StateFile::~StateFile() = default;

StateFile StateFile::create(std::filesystem::path const& path)
{
  auto part = path;
  part += ".part";
  return StateFile(std::make_unique<File>(File{path, part, hdf5::create_file(part), false}));
}

StateFile StateFile::open(std::filesystem::path const& path)
{
  H5Eset_auto(H5E_DEFAULT, nullptr, nullptr);  // failures are reported here, not by the library
  require(std::filesystem::exists(path), path.string() + " does not exist.");
  hdf5::Handle handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  require(handle >= 0, path.string() + " is not an HDF5 file, or is damaged.");
  return StateFile(std::make_unique<File>(File{path, path, std::move(handle), true}));
}

bool StateFile::reading() const { return file_->reading; }

void StateFile::field(std::string const& name, double* values, std::size_t count)
{
  transfer(*file_->handle, reading(), file_->path, name, H5T_NATIVE_DOUBLE, values, count);
}
void StateFile::field(std::string const& name, float* values, std::size_t count)
{
  transfer(*file_->handle, reading(), file_->path, name, H5T_NATIVE_FLOAT, values, count);
}
void StateFile::field(std::string const& name, std::int64_t* values, std::size_t count)
{
  transfer(*file_->handle, reading(), file_->path, name, H5T_NATIVE_INT64, values, count);
}
void StateFile::field(std::string const& name, std::uint8_t* values, std::size_t count)
{
  transfer(*file_->handle, reading(), file_->path, name, H5T_NATIVE_UINT8, values, count);
}

void StateFile::text(std::string const& name, std::string& value)
{
  auto length = static_cast<std::int64_t>(value.size());
  field(name + " length", length);
  value.resize(static_cast<std::size_t>(length));
  field(name, reinterpret_cast<std::uint8_t*>(value.data()), value.size());
}

void StateFile::same(std::string const& name, double value, std::string const& what)
{
  double found = value;
  field(name, found);
  require(found == value,
          fmt::format("{} has {} for \"{}\" where this scene has {}: it is the state "
                      "of {}.",
                      file_->path.string(), found, name, value, what));
}

void StateFile::commit()
{
  require(H5Fflush(*file_->handle, H5F_SCOPE_GLOBAL) >= 0,
          file_->part.string() + " cannot be written: is the disk full?");
  file_->handle.reset();
  std::error_code error;
  std::filesystem::rename(file_->part, file_->path, error);
  require(!error,
          fmt::format("{} cannot be put in place: {}.", file_->path.string(), error.message()));
}

}  // namespace velum::core
