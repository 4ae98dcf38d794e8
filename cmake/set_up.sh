# shellcheck shell=bash
# Sourced by tests/run and examples/run: the packages that are missing, and a quiet build.

# The packages of list $1 that are not installed, one on a line.
missing_packages() {
  local package
  while read -r package _; do
    [[ -z $package || $package == \#* ]] && continue
    dpkg-query -W -f='${db:Status-Status}\n' "$package" 2>/dev/null | grep -qx installed || echo "$package"
  done <"$1"
}

# Installs what list $1 names and the system lacks; nothing is downloaded when nothing is missing.
install_missing_packages() {
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "This is not Debian: install what corresponds to the packages in $1 if the build does not find it."
    return 0
  fi
  local missing=() as_root=() log
  mapfile -t missing < <(missing_packages "$1")
  ((${#missing[@]} > 0)) || return 0
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "Cannot install packages without root or sudo. Run as root: apt-get install ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing ${#missing[@]} Debian packages: ${missing[*]}"
  log=$(mktemp)
  if ! { "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q update &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install "${missing[@]}"; } \
    </dev/null >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    rm -f "$log"
    echo "Cannot install the packages. Run as root: apt-get install ${missing[*]}" >&2
    return 1
  fi
  rm -f "$log"
}

# As many compilers at once as there are processors, and as the free memory has room for (CGAL takes most of a gigabyte).
build_jobs() {
  local processors gigabytes=""
  processors=$(nproc)
  [[ -r /proc/meminfo ]] && gigabytes=$(awk '/^MemAvailable:/ { print int($2 / 1048576) }' /proc/meminfo)
  if [[ -n $gigabytes ]] && ((gigabytes < processors)); then
    echo $((gigabytes > 1 ? gigabytes : 1))
  else
    echo "$processors"
  fi
}

# Configures preset $1 and builds the targets that follow (all, if none); says nothing unless it fails. To be called at the root.
build_quietly() {
  local preset=$1
  shift
  local log=build/$preset.log targets=()
  (($# > 0)) && targets=(--target "$@")
  mkdir -p build
  if ! { cmake --preset "$preset" && cmake --build --preset "$preset" -j "$(build_jobs)" "${targets[@]}"; } >"$log" 2>&1; then
    tail -n 60 "$log" >&2
    echo "The build failed; all of its output is in $PWD/$log" >&2
    return 1
  fi
}
