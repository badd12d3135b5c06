#!/usr/bin/env bash
# build_kokkos.sh CACHE KEY FLAGS JOBS: builds Kokkos from Debian's trilinos source package and
# installs it as CACHE/kokkos-<version>-KEY. Nothing appears under that name before it is complete,
# and nothing of the machine's apt configuration is changed.
set -euo pipefail
cache=$1 key=$2 flags=$3 jobs=$4

mkdir -p "$cache"
exec 9>"$cache/lock"
flock 9  # two builds at once: the second waits
for ready in "$cache"/kokkos-*-"$key"; do [[ -d $ready ]] && exit 0; done
rm -rf "$cache"/.building.*
work=$(mktemp -d "$cache/.building.XXXXXX")
trap 'rm -rf "$work"' EXIT

stop() { echo "$*" >&2; exit 1; }

# The machine's binary entries turned into source entries: one-line form and deb822 form.
one_line_sources() { sed -nE '/cdrom:/d; s/^[[:space:]]*deb[[:space:]]/deb-src /p' "$1"; }
deb822_sources()
{
  awk -v RS= -v ORS='\n\n' '
    tolower($0) ~ /(^|\n)types:[^\n]*deb([ \t\n]|$)/ {
      n = split($0, line, "\n")
      out = ""
      for (i = 1; i <= n; ++i) {
        if (line[i] ~ /^#/) continue
        if (tolower(line[i]) ~ /^types:/) line[i] = "Types: deb-src"
        out = out line[i] "\n"
      }
      printf "%s\n", out
    }' "$1"
}

sources() { # writes the temporary entries to folder $1
  local list parts file
  eval "$(apt-config shell list Dir::Etc::sourcelist/f parts Dir::Etc::sourceparts/d)"
  for file in "$list" "${parts%/}"/*.list; do
    [[ -r $file ]] && one_line_sources "$file" >>"$1/velum.list"
  done
  for file in "${parts%/}"/*.sources; do
    [[ -r $file ]] && deb822_sources "$file" >>"$1/velum.sources"
  done
  grep -qs deb-src "$1"/velum.* ||
    stop "The machine's apt has no package sources to take Kokkos from."
}

mkdir -p "$work"/{apt.d,lists/partial,archives/partial,source}
sources "$work/apt.d"
apt=(apt-get -q -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$work/apt.d"
  -o Dir::State::Lists="$work/lists" -o Dir::Cache::Archives="$work/archives"
  -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= -o Acquire::Languages=none
  -o APT::Sandbox::User="$(id -un)")  # apt's own user could not write below the cache
cd "$work/source"
# Entries that carry no sources fail here; what counts is whether trilinos is found.
"${apt[@]}" update || true
"${apt[@]}" --only-source --download-only --tar-only source trilinos ||
  stop "apt-get could not fetch the source package trilinos; is there a network?"
tar xf trilinos_*.orig.tar.* --wildcards --strip-components=1 '*/packages/kokkos/*'

# shellcheck disable=SC2086  # FLAGS is a list of options
cmake -S packages/kokkos -B "$work/build" -G Ninja $flags
version=$(sed -nE 's/^set\(PACKAGE_VERSION "([^"]+)"\).*/\1/p' \
  "$work/build/KokkosConfigVersion.cmake")
cmake "$work/build" -DCMAKE_INSTALL_PREFIX="$cache/kokkos-$version-$key"
cmake --build "$work/build" -j "$jobs"
DESTDIR=$work/stage cmake --install "$work/build"
mv "$work/stage$cache/kokkos-$version-$key" "$cache/"
