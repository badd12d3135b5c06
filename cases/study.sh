# What the studies beside the scenes share; sourced by them, after a usage() of their own.

say() { printf 'study: %s\n' "$*" >&2; }

# begin_study DIR "PARTS..." LAST [ARGUMENT...]: reads the command line into out, part and extra; the
# last part runs nothing, for the others the program is built, or is $VELUM.
begin_study()
{
  out=$1 part=all extra=()
  local parts=$2 last=$3 known
  shift 3
  while (($#)); do
    case $1 in
      --help | -h) usage; exit 0 ;;
      --only) part=${2:?--only needs the name of a part}; shift ;;
      --) shift; extra=("$@"); break ;;
      -*) say "There is no option $1; see --help."; exit 2 ;;
      *) out=$1 ;;
    esac
    shift
  done
  for known in all $parts $last; do
    [[ $part == "$known" ]] && break
  done
  if [[ $part != "$known" ]]; then
    say "There is no part \"$part\": $(sed 's/ /, /g' <<<"$parts $last")."
    exit 2
  fi
  if [[ $part != "$last" ]]; then
    program=${VELUM:-$("$root/cases/run" --build | tail -n 1)}
  fi
  mkdir -p "$out"
}

wanted() { [[ $part == all || $part == "$1" ]]; }

# run_scene NAME SCENE KEY=VALUE...: into a folder of that name; one with a summary.json is done.
run_scene()
{
  local folder=$out/$1 scene=$root/cases/$2/scene.toml options=() code=0 set
  shift 2
  if [[ -e $folder/summary.json ]]; then
    say "$folder is done"
    return
  fi
  for set in "$@"; do options+=(--set "$set"); done
  say "$folder: $*"
  "$program" run "$scene" --out "$folder" "${options[@]}" ${extra[@]+"${extra[@]}"} \
    >"$folder.txt" 2>&1 || code=$?
  ((code == 0)) && return
  # A run that was stopped writes a summary too; it must not pass for a whole one.
  rm -f "$folder/summary.json"
  tail -n 3 "$folder.txt" >&2
  if ((code != 3)); then
    say "velum ended with code $code; all it said is in $folder.txt"
    exit "$code"
  fi
}
