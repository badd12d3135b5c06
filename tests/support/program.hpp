#pragma once
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace velum::tests {

struct Outcome {
  int exit_code;
  std::string text;  // stdout and stderr
};

/// Runs the built program with these arguments, as a shell would.
inline Outcome velum_program(std::string const& arguments)
{
  std::FILE* pipe = popen(("'" VELUM_PROGRAM "' " + arguments + " 2>&1").c_str(), "r");
  std::string text;
  std::array<char, 4096> part{};
  while (auto const n = std::fread(part.data(), 1, part.size(), pipe)) text.append(part.data(), n);
  int const status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text};
}

}  // namespace velum::tests
