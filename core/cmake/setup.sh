# Set-up shared by cases/run and tests/run; sourced, never run. Offers velum_setup and velum_build.
# Talks on stderr, one line per stage; what apt and CMake say goes to build/setup.log.

velum_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
velum_build_dir=$velum_root/build/run
velum_log=$velum_root/build/setup.log

velum_packages=(
  ninja-build libopenmpi-dev openmpi-bin libhdf5-openmpi-dev libeigen3-dev libtomlplusplus-dev
  libcli11-dev libfmt-dev libspdlog-dev libgtest-dev libbenchmark-dev
  python3-matplotlib python3-h5py
)

velum_say() { printf 'velum: %s\n' "$*" >&2; }
velum_stop() { velum_say "$*"; exit 1; }
velum_stop_with_log()
{
  tail -n 30 "$velum_log" >&2
  velum_stop "$* The lines above are the end of $velum_log."
}

# Compilations side by side: one per processor, each with 1 GB of memory.
velum_jobs()
{
  awk -v n="$(nproc)" '
    /MemAvailable/ { m = int($2 / 1e6) }
    END { print n < m ? n : (m < 1 ? 1 : m) }' /proc/meminfo
}

velum_check_tools()
{
  export CXX=${CXX:-g++}
  command -v "$CXX" >/dev/null ||
    velum_stop "There is no C++ compiler ($CXX) on this machine: apt-get install g++."
  command -v cmake >/dev/null ||
    velum_stop "There is no CMake on this machine: apt-get install cmake."
}

velum_missing_packages()
{
  local package
  for package in "${velum_packages[@]}"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
      echo "$package"
  done
}

velum_install_packages()
{
  [[ -z ${VELUM_SKIP_APT:-} ]] || return 0
  command -v apt-get >/dev/null ||
    velum_stop "This machine has no apt-get to install libraries with." \
      "Install these or their like, then set VELUM_SKIP_APT=1: ${velum_packages[*]}."
  local missing as_root=(env DEBIAN_FRONTEND=noninteractive)
  mapfile -t missing < <(velum_missing_packages)
  ((${#missing[@]})) || return 0
  if ((EUID != 0)); then
    sudo -n true 2>/dev/null || velum_stop "Libraries are missing and only root may install them:" \
      "apt-get install ${missing[*]}. (With equivalents elsewhere, set VELUM_SKIP_APT=1.)"
    as_root=(sudo -n "${as_root[@]}")
  fi
  velum_say "installing ${missing[*]}"
  {
    "${as_root[@]}" dpkg --configure -a  # ends what an interrupted run may have left
    "${as_root[@]}" apt-get -q -o DPkg::Lock::Timeout=300 update  # may fail for a stranger's list
    "${as_root[@]}" apt-get -qy -o DPkg::Lock::Timeout=300 --no-install-recommends install \
      "${missing[@]}"
  } </dev/null >>"$velum_log" 2>&1 ||
    velum_stop_with_log "apt-get could not install the libraries; is there a network?"
}

# Sets velum_kokkos_dir: the machine's own Kokkos where it will do, else velum's from the cache,
# else one built now.
velum_find_kokkos()
{
  local probe=$velum_root/build/kokkos_probe flags key cached
  rm -rf "$probe"
  cmake -S "$velum_root/core/cmake/kokkos_probe" -B "$probe" -G Ninja >>"$velum_log" 2>&1 ||
    velum_stop_with_log "The C++ compiler or CMake does not work."
  if [[ -f $probe/KOKKOS_DIR ]]; then
    velum_kokkos_dir=$(<"$probe/KOKKOS_DIR")
    return
  fi

  flags="-DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_STANDARD=17 -DCMAKE_POSITION_INDEPENDENT_CODE=ON"
  flags+=" -DKokkos_ENABLE_OPENMP=ON -DKokkos_ENABLE_SERIAL=ON"
  key=$({ command -v "$CXX" && "$CXX" --version && echo "$flags"; } | sha256sum)
  key=${key:0:12}
  local home=${XDG_CACHE_HOME:-${HOME:?is not set, so there is no place for Kokkos}/.cache}
  local cache=$home/velum
  for cached in "$cache"/kokkos-*-"$key"; do [[ -d $cached ]] && break; done
  if [[ ! -d $cached ]]; then
    velum_say "$(<"$probe/FAULT")" \
      "Building one with OpenMP from Debian's source package, once (160 MB)"
    bash "$velum_root/core/cmake/build_kokkos.sh" "$cache" "$key" "$flags" "$(velum_jobs)" \
      </dev/null >>"$velum_log" 2>&1 || velum_stop_with_log "Kokkos could not be built."
    for cached in "$cache"/kokkos-*-"$key"; do [[ -d $cached ]] && break; done
    velum_say "Kokkos is in $cached"
  fi
  velum_kokkos_dir=$cached/lib/cmake/Kokkos
}

velum_configure()
{
  # A build folder made for another tree, compiler or generator cannot be taken over.
  local cache=$velum_build_dir/CMakeCache.txt
  if [[ -f $cache ]] && ! { grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$velum_root" "$cache" &&
    grep -q "^CMAKE_CXX_COMPILER:.*=$(command -v "$CXX")\$" "$cache" &&
    grep -qx 'CMAKE_GENERATOR:INTERNAL=Ninja' "$cache"; }; then
    velum_say "removing $velum_build_dir, which was configured for another tree or compiler"
    rm -rf "$velum_build_dir"
  fi
  cmake -S "$velum_root" -B "$velum_build_dir" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DVELUM_NATIVE=ON -DVELUM_TESTS=ON -DKokkos_DIR="$velum_kokkos_dir" >>"$velum_log" 2>&1 ||
    velum_stop_with_log "CMake could not configure velum."
}

velum_setup()
{
  mkdir -p "$velum_root/build"
  : >"$velum_log"
  velum_check_tools
  velum_install_packages
  velum_find_kokkos
  velum_configure
}

# velum_build target: compiles for this machine's processor.
velum_build()
{
  velum_say "compiling $1 in $velum_build_dir (some minutes the first time)"
  cmake --build "$velum_build_dir" --target "$1" -j "$(velum_jobs)" >&2 ||
    velum_stop "The compilation of $1 failed; the compiler's words are above."
}
