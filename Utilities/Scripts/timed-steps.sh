# For scripts that say what happens and how long it took: `source` it.
export LC_ALL=C.UTF-8 # seconds with a point
timings=()

# step "name" command…: says what happens, keeps its time for the end, shows its output only if it fails.
step()
{
  local name="$1" start log
  shift
  log="$(mktemp)"
  printf '%-44s ' "$name" >&2
  start="$(date +%s.%N)"
  if ! "$@" >"$log" 2>&1; then
    echo "failed" >&2
    cat "$log" >&2
    rm -f "$log"
    exit 1
  fi
  rm -f "$log"
  timings+=("$name=$(date +%s.%N | awk -v s="$start" '{ printf "%.1f", $1 - s }')")
  echo "${timings[-1]##*=} s" >&2
}

to() # to FILE command…: standard output into FILE, whole or not at all
{
  local file="$1"
  shift
  "$@" >"$file.part" || { rm -f "$file.part"; return 1; }
  mv "$file.part" "$file"
}

say_times() # each step's, and their sum
{
  echo >&2
  printf '%s\n' "${timings[@]}" | awk -F= '{ printf "%8.1f s  %s\n", $2, $1; sum += $2 } END { printf "%8.1f s  in all\n", sum }' >&2
}
