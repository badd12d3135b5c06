#pragma once
#include "cases/app/scene.hpp"
#include "cases/app/scene_table.hpp"

/// One function per section of a scene file: table in, struct out. They check each value by itself
/// and the names that point to other sections; what the geometry must satisfy is in scene_checks.
namespace velum::cases {

Lattice read_lattice(SceneTable table);
FluidProperties read_fluid(SceneTable table);
Les read_les(SceneTable table);
Solid read_solid(SceneTable table, std::string name);
Boundary read_boundary(SceneTable table, std::string name, core::Symmetry symmetry,
                       Lattice const& lattice);
Material read_material(SceneTable table);
MembraneSheet read_membrane(SceneTable table, core::Symmetry symmetry, double dx);
ContactPair read_contact(SceneTable table);
GapSection read_gap(SceneTable table);
ChamberSection read_chamber(SceneTable table, std::string name);
OrificeSection read_orifice(SceneTable table, std::string name);
Coupling read_coupling(SceneTable table);
Schedule read_schedule(SceneTable table);
Start read_start(SceneTable table);
InitialState read_initial(SceneTable table);
Probe read_probe(SceneTable table, std::string name);
Reference read_reference(SceneTable table);
Sweep read_sweep(SceneTable table);

}  // namespace velum::cases
