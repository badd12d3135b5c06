#!/usr/bin/env bash
# Claim: include_arrows.sh sees each kind of fault and names file and line; it passes a right tree.
set -euo pipefail
arrows=$(dirname "${BASH_SOURCE[0]}")/include_arrows.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir "$tree"/{core,lbm,structure,contact,ibm,cases,tests}

printf '#pragma once\n' | tee "$tree"/{core,lbm,structure,ibm}/a.hpp >/dev/null
printf '#include "lbm/a.hpp"\n#include "structure/a.hpp"\n' >"$tree/ibm/a.cpp"
bash "$arrows" "$tree" || { echo "a right tree was refused"; exit 1; }

expect() # file, content, line that must be reported
{
  printf '%b' "$2" >"$tree/$1"
  local said
  said=$(bash "$arrows" "$tree") && { echo "not caught: $2"; exit 1; }
  [[ $said == *"$1:$3"* ]] || { printf 'expected %s, got:\n%s\n' "$1:$3" "$said"; exit 1; }
  rm "$tree/$1"
}
expect core/b.hpp '#pragma once\n#include "lbm/a.hpp"\n' '2: core may not include'
expect lbm/b.cpp '#include "structure/a.hpp"\n' '1: lbm may not include'
expect contact/b.cpp '\n#  include  "ibm/a.hpp"\n' '2: contact may not include'
expect ibm/b.cpp '#include "core/missing.hpp"\n' '1: "core/missing.hpp" is no path'
expect core/b.hpp '#ifndef B\n#define B\n#endif\n' '1: a header opens with #pragma once'
