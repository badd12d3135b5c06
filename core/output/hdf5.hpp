#pragma once
#include <hdf5.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace velum::core::hdf5 {

/// An open HDF5 object, closed at the end of its scope.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
  Handle& operator=(Handle&&) = delete;
  ~Handle()
  {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

// All of these throw InputError when the library refuses. The file is written by one process with
// the default driver, which needs no MPI, also in an MPI build of the library.

/// A new file, replacing what was there.
Handle create_file(std::filesystem::path const& path);
/// A file to write more into.
Handle open_file(std::filesystem::path const& path);

Handle create_group(hid_t parent, std::string const& name);

bool contains(hid_t parent, std::string const& name);
/// Takes a group or array out of the file; its room is not given back.
void remove(hid_t parent, std::string const& name);

void write_attribute(hid_t object, std::string const& name, std::string const& text);
void write_attribute(hid_t object, std::string const& name, double value);
void write_attribute(hid_t object, std::string const& name, int value);

/// A whole array, C order, shuffled and deflated (level 4) in chunks of whole rows of about 1 MiB.
/// @return the data set, for its attributes
Handle write_array(hid_t parent, std::string const& name, hid_t type, void const* values,
                   std::vector<hsize_t> const& extents);

}  // namespace velum::core::hdf5
