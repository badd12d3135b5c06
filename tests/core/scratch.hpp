#pragma once
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

namespace velum::tests {

/// An empty folder of this process's own, gone with its contents at the end of the scope.
struct Scratch {
  std::filesystem::path folder;

  explicit Scratch(std::string const& name)
      : folder(std::filesystem::temp_directory_path() /
               ("velum_" + name + "_" + std::to_string(getpid())))
  {
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  Scratch(Scratch const&) = delete;
  Scratch& operator=(Scratch const&) = delete;
  ~Scratch()
  {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }
};

/// The whole text of a file; empty when there is none.
inline std::string text_of(std::filesystem::path const& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace velum::tests
