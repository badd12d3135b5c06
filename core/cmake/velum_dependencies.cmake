include(velum_kokkos)

# velum_require(name package arguments...): find_package(name arguments...), or a sentence that
# names Debian's package.
macro(velum_require name package)
  find_package(${name} QUIET ${ARGN})
  if(NOT ${name}_FOUND)
    message(FATAL_ERROR "velum needs ${name}, which was not found. "
      "Debian has it: apt-get install ${package}. Elsewhere set ${name}_ROOT to its folder.")
  endif()
endmacro()

velum_find_kokkos()
if(VELUM_KOKKOS_FAULT)
  message(FATAL_ERROR "${VELUM_KOKKOS_FAULT} cases/run and tests/run build one with OpenMP from "
    "Debian's source package; with your own, set Kokkos_ROOT to its folder.")
endif()
message(STATUS "Kokkos ${Kokkos_VERSION} (${Kokkos_DEVICES}) in ${Kokkos_DIR}")

set(MPI_CXX_SKIP_MPICXX TRUE)  # the C interface only
set(HDF5_PREFER_PARALLEL TRUE)
velum_require(MPI "libopenmpi-dev openmpi-bin" COMPONENTS CXX)
velum_require(HDF5 libhdf5-openmpi-dev COMPONENTS C)
if(NOT HDF5_IS_PARALLEL)
  message(FATAL_ERROR "The HDF5 in ${HDF5_INCLUDE_DIRS} was built without MPI. "
    "Debian's parallel build: apt-get install libhdf5-openmpi-dev.")
endif()
velum_require(Eigen3 libeigen3-dev 3.4 NO_MODULE)
velum_require(fmt libfmt-dev)
velum_require(spdlog libspdlog-dev)
velum_require(tomlplusplus libtomlplusplus-dev)
velum_require(CLI11 libcli11-dev)
if(VELUM_TESTS)
  velum_require(GTest libgtest-dev)
  velum_require(benchmark libbenchmark-dev)
endif()
