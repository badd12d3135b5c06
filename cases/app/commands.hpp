#pragma once
#include "cases/app/options.hpp"

namespace velum::cases {

/// velum run: checks the scene, prepares the results folder, starts the log and marches.
void run_command(Options const& options);
/// velum check: the preflight table on stdout.
void check_command(Options const& options);
/// velum stl: the report of an STL file on stdout; with a cut, its section as tables and picture.
void stl_command(Options const& options);
/// velum mesh: what is in a mesh file of Gmsh and how good its triangles are, on stdout.
void mesh_command(Options const& options);
/// velum chart: error against wall time of scenes over resolution, collision and precision; a CSV
/// file, a picture and a line for each run.
void chart_command(Options const& options);
/// velum sweep: a scene once for every combination of some values, each in a folder; a CSV file, a
/// picture and a line for each run. What an earlier sweep has done is not run again.
void sweep_command(Options const& options);
/// velum limits: largest stable Reynolds and Mach numbers of every collision; the same.
void limits_command(Options const& options);
/// velum limits contact_penalty: penetration, errors and work of a contact over its stiffness; the
/// same.
void contact_penalty_command(Options const& options);
/// velum fit: laws of rubber from files of test data; a report, material cards, tables, a picture.
void fit_command(Options const& options);
/// velum plot: pictures of a run and one HTML page that holds them, its figures and assumptions.
void plot_command(Options const& options);
/// velum bench: speed of the lattice step, and of the memory, on stdout.
void bench_command(Options const& options);
/// velum info: version, back ends, threads, libraries on stdout.
void info_command();

}  // namespace velum::cases
