# Sourced by benchmarks/run and tests/run: the one list of Debian 12 packages, and the way from a bare machine to built programs.
# Nothing here asks a question; standard input is never read.

export DEBIAN_FRONTEND=noninteractive
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# What the programs are built from and the report is written with.
# OpenBLAS stands in for the reference BLAS that deal.II brings: MUMPS then factorises in two thirds of the time.
packages="git ca-certificates cmake ninja-build g++ pkg-config
  libeigen3-dev libcli11-dev libtoml11-dev libmuparser-dev libfmt-dev nlohmann-json3-dev
  libboost-dev libbenchmark-dev
  libhdf5-openmpi-dev openmpi-bin libopenmpi-dev libdeal.ii-dev libopenblas0-serial gmsh
  python3 python3-numpy python3-matplotlib python3-h5py python3-jinja2"
# What the tests need beside them.
test_packages="libgtest-dev python3-meshio valgrind"

# One line per phase with the seconds since the start, so that a log tells where the time went.
phase() { printf '[%4d s] %s\n' "$SECONDS" "$*"; }

# missing_packages NAME...: those that dpkg does not know as installed.
missing_packages()
{
  local name
  for name in "$@"; do
    dpkg-query -W -f='${Status}' "$name" 2>/dev/null | grep -q '^install ok installed$' || printf '%s ' "$name"
  done
}

# install_missing NAME...: installs what is missing, as root or with a password-less sudo; else prints the line to type and stops.
install_missing()
{
  local missing as_root=()
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    phase "no apt-get here: taking the libraries as they are (Debian 12 names: $(echo "$@"))"
    return 0
  fi
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || { phase "every package needed is installed"; return 0; }
  if [ "$(id -u)" != 0 ]; then
    if command -v sudo >/dev/null && sudo -n true 2>/dev/null; then
      as_root=(sudo -n env DEBIAN_FRONTEND=noninteractive)
    else
      printf 'Packages are missing and may not be installed from here. Type this, then start again:\n\n'
      printf '  sudo apt-get update && sudo apt-get install -y --no-install-recommends %s\n\n' "$missing"
      return 2
    fi
  fi
  phase "installing $missing"
  "${as_root[@]}" apt-get update -qq </dev/null || return 2
  # shellcheck disable=SC2086 -- a list of names
  "${as_root[@]}" apt-get install -y -qq --no-install-recommends $missing </dev/null >/dev/null || return 2
}

# As many compilers at once as there are cores, but no more than memory holds (deal.II's headers take 1.5 GB each).
jobs_that_fit()
{
  local cores memory
  cores=$(nproc)
  memory=$(awk '/MemAvailable/ {print int($2 / 1700000)}' /proc/meminfo)
  [ "$memory" -ge 1 ] || memory=1
  echo $((cores < memory ? cores : memory))
}

# build PRESET TESTS [TARGET...]: configure and build; TESTS is ON or OFF. With CI=true warnings are errors whatever the compiler.
build()
{
  local preset=$1 tests=$2 strict=()
  shift 2
  [ "${CI:-}" != true ] || strict=(-DMPM_PF_WERROR=ON)
  phase "configuring build/$preset (tests $tests)"
  mkdir -p "$root/build/$preset"
  (cd "$root" && cmake --preset "$preset" -DMPM_PF_TESTS="$tests" "${strict[@]}" </dev/null) >"$root/build/$preset/configure.log" 2>&1 || {
    tail -n 60 "$root/build/$preset/configure.log"; return 2; }
  phase "building with $(jobs_that_fit) jobs"
  (cd "$root" && cmake --build --preset "$preset" -j "$(jobs_that_fit)" ${1:+--target "$@"} </dev/null) \
    >"$root/build/$preset/build.log" 2>&1 || { tail -n 60 "$root/build/$preset/build.log"; return 2; }
  phase "built: $root/build/$preset/bin"
}
