#!/usr/bin/env bash
# Claim: lower folders never include higher ones, fluid, structure and contact never include each
# other, quoted includes are paths from the root, and every header opens with #pragma once.
# include_arrows.sh ROOT: prints each offending line as file:line: text, and fails if there is one.
set -euo pipefail
cd "$1"

declare -A may_include=(
  [core]="core"
  [lbm]="core lbm"
  [structure]="core structure"
  [contact]="core contact"
  [ibm]="core lbm structure contact ibm"
  [cases]="core lbm structure contact ibm cases"
  [tests]="core lbm structure contact ibm cases tests"
)
faults=0
fault() { echo "$1"; faults=$((faults + 1)); }

for folder in core lbm structure contact ibm cases tests; do
  while IFS=: read -r file line text; do
    path=$(sed -E 's/^[^"]*"([^"]*)".*/\1/' <<<"$text")
    if [[ " ${may_include[$folder]} " != *" ${path%%/*} "* ]]; then
      fault "$file:$line: $folder may not include \"$path\" (only: ${may_include[$folder]})"
    elif [[ ! -f $path ]]; then
      fault "$file:$line: \"$path\" is no path from the root of the repository"
    fi
  done < <(grep -rnE '^[[:space:]]*#[[:space:]]*include[[:space:]]*"' "$folder" \
    --include=*.hpp --include=*.cpp --exclude-dir=consumer)

  while read -r file; do
    first=$(awk '!/^[[:space:]]*(\/\/.*)?$/ { print; exit }' "$file")
    [[ $first == '#pragma once' ]] || fault "$file:1: a header opens with #pragma once"
  done < <(find "$folder" -name '*.hpp')
done

((faults == 0)) || { echo "$faults wrong lines"; exit 1; }
