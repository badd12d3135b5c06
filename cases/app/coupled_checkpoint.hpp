#pragma once
#include <filesystem>

#include "cases/app/coupled_march.hpp"
#include "core/output/state_file.hpp"

namespace velum::cases {

/// Writes the state of a scene and of its march, or reads it: all that a run needs to go on as if
/// it had not been interrupted. When reading, march.out has no open files yet (resume_output).
/// @throws core::InputError  the state is of another lattice, membrane, precision or time step
template <class Real>
void exchange(core::StateFile& file, CoupledScene<Real, ibm::Sharp>& s, March& march,
              std::string& scene_text);

/// Writes checkpoint_a.h5 or checkpoint_b.h5, the one that is older: whenever the run ends, one of
/// them is whole.
/// @return its path
template <class Real>
std::filesystem::path save_checkpoint(std::filesystem::path const& folder,
                                      CoupledScene<Real, ibm::Sharp>& s, March& march,
                                      std::string scene_text);

/// How often the run behind a checkpoint had fallen back to a shorter time step.
long times_fallen(std::filesystem::path const& checkpoint);

/// The newest whole checkpoint of a folder, by the steps taken; empty where there is none.
std::filesystem::path newest_checkpoint(std::filesystem::path const& folder);

}  // namespace velum::cases
