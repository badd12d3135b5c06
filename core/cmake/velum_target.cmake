# velum_compile_options(target): language, warnings and optimisation of all that velum compiles.
function(velum_compile_options target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  set(optimised "$<CONFIG:Release,RelWithDebInfo>")
  # Square roots and comparisons vectorise only without errno and trap semantics, and a sum begun
  # at zero costs nothing only where -0 is 0; the rest of IEEE arithmetic (NaN, infinities, order of
  # operations) stays as written.
  target_compile_options(${target} PRIVATE
    "$<${optimised}:-fno-math-errno;-fno-trapping-math;-fno-signed-zeros>")
  if(VELUM_NATIVE)
    target_compile_options(${target} PRIVATE -march=native)
  endif()
  target_compile_options(${target} PRIVATE -Wall -Wextra)
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC 12 sees overlapping copies in std::string's operator+ (GCC bug 105651).
    target_compile_options(${target} PRIVATE -Wno-restrict)
    # GCC 12 warns of the deliberately undefined registers in its own AVX-512 header, which Eigen
    # uses where the processor has it (GCC bug 105593). Portable builds keep the warning.
    if(VELUM_NATIVE)
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    endif()
  endif()
  # nvcc's generated host code is not pedantic and carries warnings of its own.
  if(NOT Kokkos_ENABLE_CUDA)
    target_compile_options(${target} PRIVATE -Wpedantic)
    if(VELUM_WARNINGS_AS_ERRORS)
      target_compile_options(${target} PRIVATE -Werror)
    endif()
  endif()
  if(VELUM_SANITIZE)
    target_compile_options(${target} PRIVATE
      -fsanitize=${VELUM_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
    target_link_options(${target} PUBLIC -fsanitize=${VELUM_SANITIZE})
  endif()
endfunction()

# velum_precompile(target header...): what most files of the target include anyway, and spend most of
# their compile time on.
function(velum_precompile target)
  if(Kokkos_ENABLE_CUDA OR Kokkos_ENABLE_HIP)
    return()  # their compilers take no precompiled header of another language mode
  endif()
  set(eigen <Eigen/Core> <Eigen/SparseCore>)
  if(target MATCHES "^velum_(core|lbm|contact)$")
    set(eigen)  # these rooms do not have it
  endif()
  target_precompile_headers(${target} PRIVATE ${eigen} <Kokkos_Core.hpp> <fmt/format.h> <filesystem>
    <fstream> <functional> <map> <memory> <optional> <sstream> <string> <vector> ${ARGN})
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # Behind a precompiled header GCC 12 sees overflows in small strings, as in GCC bug 105651.
    target_compile_options(${target} PRIVATE -Wno-stringop-overflow -Wno-array-bounds)
  endif()
endfunction()

# velum_library(folder dependency...): target velum::folder from the folder's sources and headers.
function(velum_library folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  add_library(velum_${folder} ${sources})
  add_library(velum::${folder} ALIAS velum_${folder})
  set_target_properties(velum_${folder} PROPERTIES EXPORT_NAME ${folder})
  target_include_directories(velum_${folder} PUBLIC
    "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
    "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/velum>")
  target_link_libraries(velum_${folder} PUBLIC ${ARGN})
  velum_compile_options(velum_${folder})
  velum_precompile(velum_${folder})
endfunction()
