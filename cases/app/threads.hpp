#pragma once

namespace velum::cases {

/// Sets how many threads OpenMP uses and, where the user chose neither OMP_PROC_BIND nor
/// OMP_PLACES, how they are bound: spread over the processors when the run takes all of them, free
/// otherwise, because two bound runs side by side would share the same processors.
///
/// OpenMP reads these variables when the program is loaded, so where one changes the program
/// starts itself once more with the same arguments.
/// @param threads  0: as many as the process may use
/// @pre no thread has been started
void set_up_threads(int threads, char** argv);

}  // namespace velum::cases
