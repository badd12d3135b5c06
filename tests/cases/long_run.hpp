#pragma once
#include <hdf5.h>

#include <set>

#include "cases/app/coupled_checkpoint.hpp"
#include "cases/app/coupled_run.hpp"
#include "cases/app/stop.hpp"
#include "core/output/hdf5.hpp"
#include "tests/cases/scene_file.hpp"

namespace velum::tests {

/// The small valve, its seat touching, on few cells, some thousand steps.
inline std::string const quick_valve =
    edited(edited(edited(small_valve, "dx = \"100 um\"", "dx = \"200 um\""),
                  "settle = \"10 ms\"\noutput_every = \"5 ms\"",
                  "settle = \"1.5 ms\"\noutput_every = \"0.4 ms\""),
           "[[\"-1.2 mm\", \"3 mm\"], [\"-1.2 mm\", \"3.5 mm\"]",
           "[[\"-0.95 mm\", \"3 mm\"], [\"-0.95 mm\", \"3.5 mm\"]");

/// The same with a chamber above the membrane that a pilot passage empties from 0.3 ms on.
inline std::string const quick_piloted_valve =
    edited(edited(edited(quick_valve, "side = \"x+\", from = \"1 mm\", to = \"5 mm\"",
                         "side = \"x-\", from = \"3.5 mm\", to = \"5 mm\""),
                  "to = [\"2 mm\", \"6 mm\"]", "to = [\"1.4 mm\", \"6 mm\"]"),
           "[material.rubber]", R"([chamber.control]
side = "above"
volume = "200 mm3"
bulk_modulus = "20 MPa"
[orifice.bleed]
from = "inlet"
to = "control"
area = "0.2 mm2"
[orifice.pilot]
from = "control"
to = "outlet"
area = "1 mm2"
[orifice.pilot.seat]
diameter = "2 mm"
land = "0.3 mm"
lift = [["0 ms", "0 mm"], ["0.3 ms", "0 mm"], ["0.5 ms", "0.5 mm"]]
[material.rubber])");

/// A folder with a scene, and the runs of it.
struct SceneRuns {
  TemporaryFolder folder;
  std::string text;

  explicit SceneRuns(std::string scene) : text(std::move(scene)) { write("scene.toml", text); }
  void write(std::string const& name, std::string const& what) const
  {
    std::ofstream(folder.path / name) << what;
  }
  std::filesystem::path out(std::string const& name) const { return folder.path / name; }

  /// Runs into a folder; from a checkpoint, if one is given. False where a stop was asked for.
  bool run(std::string const& name, std::vector<std::string> const& set = {},
           std::filesystem::path const& restart = {}, std::string const& scene = "scene.toml") const
  {
    std::filesystem::create_directories(out(name));
    try {
      cases::run_coupled(cases::read_scene(folder.path / scene, set),
                         {.out = out(name), .quiet = true, .restart = restart, .set = set});
      return true;
    } catch (cases::Stopped const&) {
      return false;
    }
  }
};

/// Names of the arrays in which two state files differ, but for what a clock says.
inline std::vector<std::string> differences(std::filesystem::path const& a,
                                            std::filesystem::path const& b,
                                            std::set<std::string> const& but = {
                                                "wall time", "wall time of the membrane"})
{
  using core::hdf5::Handle;
  Handle const files[] = {{H5Fopen(a.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose},
                          {H5Fopen(b.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose}};
  if (files[0] < 0 || files[1] < 0) return {"a file that is no state"};
  std::set<std::string> names;
  for (auto const& file : files) {
    H5G_info_t info;
    H5Gget_info(file, &info);
    for (hsize_t k = 0; k < info.nlinks; ++k) {
      char name[100];
      H5Lget_name_by_idx(file, ".", H5_INDEX_NAME, H5_ITER_INC, k, name, sizeof name, H5P_DEFAULT);
      names.insert(name);
    }
  }
  auto const bytes = [](hid_t file, std::string const& name) {
    Handle const array(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
    if (array < 0) return std::string("missing");
    Handle const type(H5Dget_type(array), H5Tclose), space(H5Dget_space(array), H5Sclose);
    std::string data(
        static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)) * H5Tget_size(type), ' ');
    H5Dread(array, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data.data());
    return data;
  };
  std::vector<std::string> different;
  for (auto const& name : names)
    if (!but.contains(name) && bytes(files[0], name) != bytes(files[1], name))
      different.push_back(name);
  return different;
}

}  // namespace velum::tests
