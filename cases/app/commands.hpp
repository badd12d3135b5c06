#pragma once
#include "cases/app/options.hpp"

namespace velum::cases {

/// velum run: checks the scene, prepares the results folder, starts the log and marches.
void run_command(Options const& options);
/// velum check: the preflight table on stdout.
void check_command(Options const& options);
/// velum stl: the report of an STL file on stdout; with a cut, its section as tables and picture.
void stl_command(Options const& options);
/// velum info: version, back ends, threads, libraries on stdout.
void info_command();

}  // namespace velum::cases
