#pragma once
#include <string>
#include <vector>

namespace velum::cases {

/// Version of velum, "0.1.0".
std::string version();

/// Compiler and language standard of this build.
std::string build_description();

/// A library that velum is built with, and its version.
struct Library {
  std::string name, version;
};
std::vector<Library> libraries();

}  // namespace velum::cases
