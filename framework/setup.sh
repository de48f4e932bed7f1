# Installs what Glint is built with, configures and builds; for bash scripts to source.
# All it says goes to standard error.
# shellcheck shell=bash disable=SC2034

top=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")

# Debian's package, and the program or header that shows it is there.
build_needs=(g++:c++ cmake:cmake ninja-build:ninja libglm-dev:glm/glm.hpp
  libxsimd-dev:xsimd/xsimd.hpp libstb-dev:stb/stb_image_write.h libcli11-dev:CLI/CLI.hpp
  libtinyobjloader-dev:tiny_obj_loader.h nlohmann-json3-dev:nlohmann/json.hpp)
window_needs=(libsdl2-dev:SDL2/SDL.h)
test_needs=(doctest-dev:doctest/doctest.h libseccomp-dev:seccomp.h
  libssl-dev:openssl/hmac.h git:git unzip:unzip)
window_test_needs=("${window_needs[@]}" xvfb:Xvfb xdotool:xdotool imagemagick:import)
gallery_test_needs=(chromium:chromium chromium-driver:chromedriver curl:curl)
count_test_needs=(valgrind:valgrind)
chart_needs=(gnuplot-nox:gnuplot)
peer_needs=(libegl-dev:EGL/egl.h libgles-dev:GLES3/gl3.h)

say() { printf '%s\n' "$*" >&2; }

fail() {
  say "error: $*"
  exit 2
}

has_header() {
  local folder folders
  IFS=: read -ra folders <<<"/usr:/usr/local:${CMAKE_PREFIX_PATH:-}"
  for folder in "${folders[@]}"; do
    [[ ! -f $folder/include/$1 ]] || return 0
  done
  return 1
}

is_there() {
  case $1 in
    *.h | *.hpp) has_header "$1" ;;
    *) command -v "$1" >/dev/null ;;
  esac
}

can_install() {
  command -v apt-get >/dev/null && { ((EUID == 0)) || command -v sudo >/dev/null; }
}

# install NEED...: asks the package manager once for all that is missing.
install() {
  local need names=() packages=()
  for need in "$@"; do
    if ! is_there "${need#*:}"; then
      names+=("${need#*:}")
      packages+=("${need%%:*}")
    fi
  done
  ((${#packages[@]})) || return 0
  can_install || fail "these are missing: ${names[*]}; on Debian, install them as root with:
  apt-get install --no-install-recommends ${packages[*]}"
  say "Installing ${packages[*]}; this may take minutes"
  install_packages "${packages[@]}"
}

install_packages() {
  local log as_root=()
  ((EUID == 0)) || as_root=(sudo)
  log=$(mktemp)
  "${as_root[@]}" apt-get update -qq &>"$log" || say "apt-get update failed; trying what is known"
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -qq --no-install-recommends "$@" </dev/null &>>"$log"; then
    tail -n 20 "$log" >&2
    fail "apt-get install --no-install-recommends $* failed; the whole log is $log"
  fi
  rm "$log"
}

# A build folder that came along when the project was copied would build the project it came from.
is_configured() {
  [[ -f $1/build.ninja && -f $1/CMakeCache.txt ]] || return 1
  local source
  source=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$1/CMakeCache.txt")
  [[ $source -ef $top ]]
}

# configure PRESET FOLDER
configure() {
  say "Configuring $2"
  cmake -S "$top" --preset "$1" -B "$2" --fresh >/dev/null
}

# build PRESET FOLDER TARGET...: configures where that is not done, builds what is not up to date.
build() {
  local preset=$1 folder=$2
  shift 2
  is_configured "$folder" || configure "$preset" "$folder"
  local plan
  if ! plan=$(cmake --build "$folder" --target "$@" -- -n 2>/dev/null); then
    configure "$preset" "$folder" # when it was configured, packages were missing
    plan=$(cmake --build "$folder" --target "$@" -- -n)
  fi
  if [[ $plan != *"no work to do"* ]]; then
    say "Building $* in $folder"
    cmake --build "$folder" --target "$@" >&2
  fi
}
