#!/usr/bin/env bash
# Claim: before it sets anything up, cases/run refuses an unknown scene with exit code 2 and the
# list of the scenes there are, and --help names every form of the command.
set -euo pipefail
cd "$1"

if said=$(cases/run no_such_scene 2>&1); then code=0; else code=$?; fi
[[ $code == 2 ]] || { echo "exit code $code instead of 2"; exit 1; }
for part in no_such_scene closed_valve; do
  [[ $said == *"$part"* ]] || { printf 'no word of %s in:\n%s\n' "$part" "$said"; exit 1; }
done

help=$(cases/run --help)
for part in NAME FILE.toml --build --help VELUM_NATIVE=ON; do
  [[ $help == *"$part"* ]] || { printf 'no word of %s in:\n%s\n' "$part" "$help"; exit 1; }
done
