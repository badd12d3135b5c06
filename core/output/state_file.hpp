#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace velum::core {

/// The state of a run as named arrays in one HDF5 file. The same list of calls writes it and reads
/// it back to the last bit: what is written from a variable is read into it.
class StateFile {
 public:
  /// A new file, written under another name beside `path` until commit() puts it in its place: at
  /// every instant `path` is absent, the old file, or the whole new one.
  static StateFile create(std::filesystem::path const& path);
  /// Throws InputError where it is no such file.
  static StateFile open(std::filesystem::path const& path);
  StateFile(StateFile&&) noexcept;
  ~StateFile();

  bool reading() const;

  // Throw InputError where the disk is full, or what is read is missing or of another size.
  void field(std::string const& name, double* values, std::size_t count);
  void field(std::string const& name, float* values, std::size_t count);
  void field(std::string const& name, std::int64_t* values, std::size_t count);
  void field(std::string const& name, std::uint8_t* values, std::size_t count);

  /// An array whose length is the state's; reading needs it to be the same.
  template <class T>
  void field(std::string const& name, std::vector<T>& values)
  {
    field(name, values.data(), values.size());
  }
  /// An array of any length; what is read has that of the file.
  template <class T>
  void list(std::string const& name, std::vector<T>& values)
  {
    auto length = values.size();
    number(name + " length", length);
    values.resize(length);
    field(name, values);
  }
  void field(std::string const& name, double& value) { field(name, &value, 1); }
  void field(std::string const& name, std::int64_t& value) { field(name, &value, 1); }
  /// Any whole number or choice.
  template <class T>
  void number(std::string const& name, T& value)
  {
    auto wide = static_cast<std::int64_t>(value);
    field(name, wide);
    value = static_cast<T>(wide);
  }
  void text(std::string const& name, std::string& value);
  /// Writes a number that the reader must have too, and refuses another one.
  /// @param what  it is a state of, where the numbers differ: "another time step"
  void same(std::string const& name, double value, std::string const& what);

  /// Ends writing.
  void commit();

 private:
  struct File;
  explicit StateFile(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

}  // namespace velum::core
