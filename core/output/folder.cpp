#include "core/output/folder.hpp"

#include "core/check.hpp"

#include <fmt/format.h>

#include <fstream>
#include <ios>
#include <system_error>

namespace velum::core {

namespace fs = std::filesystem;

fs::path make_folder(fs::path const& folder)
{
  std::error_code error;
  fs::path const path = fs::absolute(folder, error);
  if (!error) fs::create_directories(path, error);
  require(!error && fs::is_directory(path, error),
          fmt::format("The output folder {} cannot be made: {}.", folder.string(),
                      error ? error.message() : "a file of that name is in the way"));

  fs::path const trial = path / ".velum_can_write";
  bool const writable = static_cast<bool>(std::ofstream(trial));
  fs::remove(trial, error);
  require(writable, fmt::format("The output folder {} cannot be written in.", path.string()));
  return path;
}

void write_atomically(fs::path const& file, std::string_view text)
{
  fs::path const beside = file.string() + ".new";
  std::ofstream stream(beside, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  std::error_code error;
  if (stream) fs::rename(beside, file, error);
  require(static_cast<bool>(stream) && !error, fmt::format("{} cannot be written.", file.string()));
}

}  // namespace velum::core
