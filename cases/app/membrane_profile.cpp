#include "cases/app/membrane_profile.hpp"

#include "structure/faces.hpp"

namespace velum::cases {

core::Series start_profile(std::filesystem::path const& folder)
{
  return core::start_series(folder / "profile.csv", {{"radius", "m"},
                                                     {"axial", "m"},
                                                     {"minus_face_radius", "m"},
                                                     {"minus_face_axial", "m"},
                                                     {"thickness", "m"}});
}

void append_profile(core::Series& profile, structure::Membrane const& membrane, double dx,
                    double time)
{
  structure::Faces faces;
  structure::locate_faces(membrane, membrane.position, 1.0, faces);
  for (std::size_t a = 0; a < faces.minus.size(); ++a) {
    auto const x = structure::node(membrane.position, static_cast<int>(a));
    core::append(profile, time,
                 {dx * x[1], dx * x[0], dx * faces.minus[a][1], dx * faces.minus[a][0],
                  dx * faces.thickness[a]});
  }
}

}  // namespace velum::cases
