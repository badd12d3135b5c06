# velum_find_kokkos(): finds Kokkos and judges it. Sets in the caller Kokkos' own variables and
# VELUM_KOKKOS_FAULT, the sentence that says what is wrong with it; empty where it will do.
macro(velum_find_kokkos)
  set(VELUM_KOKKOS_FAULT "")
  # No version here: Kokkos 4 declares itself incompatible with a request for 3.4.
  find_package(Kokkos QUIET CONFIG)
  if(NOT Kokkos_FOUND)
    set(VELUM_KOKKOS_FAULT "No Kokkos was found on this machine.")
  elseif(Kokkos_VERSION VERSION_LESS 3.4)
    set(VELUM_KOKKOS_FAULT
      "The Kokkos in ${Kokkos_DIR} is version ${Kokkos_VERSION}; velum needs 3.4 or newer.")
  elseif(NOT Kokkos_ENABLE_OPENMP)
    set(VELUM_KOKKOS_FAULT "The Kokkos in ${Kokkos_DIR} was built without OpenMP.")
  endif()
endmacro()
