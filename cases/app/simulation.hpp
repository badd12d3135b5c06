#pragma once
#include <filesystem>

#include "cases/app/scene.hpp"

namespace velum::cases {

struct RunOptions {
  std::filesystem::path out;  // absolute, exists
  bool quiet = false;
  std::filesystem::path restart = {};  // checkpoint to go on from; empty: from the start
  std::vector<std::string> set = {};   // overrides, for another scene that this one starts from
};

/// Runs a scene to its end and leaves its results in the folder; prints the certificate.
/// Throws core::InputError, core::Divergence or Stopped; what was written until then is complete.
void run(Scene const& scene, RunOptions const& options);

}  // namespace velum::cases
