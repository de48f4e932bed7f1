#!/usr/bin/env bash
# A student's hour with lessons/run --watch, on a display of its own: changes, mistakes, a crash and
# an endless loop, and the window stays.
#   watch_test.sh BUILD    the folder that holds Glint's libraries; the lesson is built beside them
set -euo pipefail
shopt -s inherit_errexit
# shellcheck source=SCRIPTDIR/../words.sh
source "$(dirname "$(realpath "$0")")/../words.sh"
build=$(realpath "$1")
top=$(realpath "$(dirname "$0")/../..")
for tool in Xvfb xdotool import convert cmp ninja; do
  command -v $tool >/dev/null || skip "$tool is not installed"
done
grep -q '^SDL2_DIR:PATH=/' "$build/CMakeCache.txt" || skip "SDL2 was not there when this was built"
scratch=$(mktemp -d)
server_pid=""
watch_pid=""
end() {
  [[ ! $watch_pid ]] || kill "$watch_pid" 2>/dev/null || true
  [[ ! $server_pid ]] || kill "$server_pid" 2>/dev/null || true
  wait
  rm -rf "$scratch"
}
trap end EXIT
cd "$scratch"
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0
unset DISPLAY WAYLAND_DISPLAY SDL_VIDEODRIVER

# ---- a course of one lesson, whose answer is how bright a disc is --------------------------------

cached() { sed -n "s/^$1:STRING=//p" "$build/CMakeCache.txt"; }

mkdir -p tree/lessons/09_disc tree/framework
cp "$top/lessons/run" tree/lessons
cp "$top/framework/setup.sh" tree/framework
cat >tree/CMakePresets.json <<END
{"version": 6, "configurePresets": [{"name": "release", "generator": "Ninja"}]}
END
cat >tree/CMakeLists.txt <<END
cmake_minimum_required(VERSION 3.25)
project(course LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY \${PROJECT_BINARY_DIR}/bin)
find_package(SDL2 REQUIRED)
find_package(Threads REQUIRED)
add_executable(09_disc_watched lessons/09_disc/main.cpp lessons/09_disc/disc.cpp)
target_include_directories(09_disc_watched PRIVATE $top)
file(GLOB libraries $build/framework/*/libglint_*.a)
target_compile_options(09_disc_watched PRIVATE -march=$(cached GLINT_ARCH) $(cached CMAKE_CXX_FLAGS))
target_link_options(09_disc_watched PRIVATE $(cached CMAKE_CXX_FLAGS))
target_link_libraries(09_disc_watched -Wl,--start-group \${libraries} -Wl,--end-group tinyobjloader
  SDL2::SDL2 Threads::Threads)
file(WRITE \${PROJECT_BINARY_DIR}/bin/grade "#!/bin/sh\necho '09_disc   1 of 2'\n")
file(CHMOD \${PROJECT_BINARY_DIR}/bin/grade PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
add_custom_target(grade)
END
cat >tree/lessons/09_disc/main.cpp <<END
#include "framework/app/lesson.hpp"
#include "framework/geometry/shapes.hpp"

float brightness();

struct Disc {
    template <class T>
    struct Varyings {
        glint::Vec3<T> normal;
    };
    static Varyings<float> vertex(const glint::Vertex& v) { return {v.normal}; }
    template <glint::Real T>
    glint::Rgb<T> operator()(const Varyings<T>&) const {
        return glint::Rgb<T>(T(brightness()));
    }
};

int main(int argc, char** argv) {
    const auto stage = [](const glint::Parameters&) {
        return glint::Scene{.mesh = glint::icosphere(0.5F, 4)};
    };
    const auto shader = [](const auto&, const auto&, const auto&) { return Disc(); };
    return glint::run_lesson(argc, argv, {.name = "09_disc", .title = "Lesson: a disc",
        .stage = stage, .shaders = glint::shade_each_material(shader)});
}
END

# answer TEXT: saves the file as an editor does, beside it and then over it.
answer() {
  echo "$1" >new.cpp
  mv new.cpp tree/lessons/09_disc/disc.cpp
}

# ---- tools ---------------------------------------------------------------------------------------

wait_for() { # WHAT COMMAND...
  local what=$1 deadline=$((SECONDS + 60))
  shift
  until "$@"; do
    ((SECONDS < deadline)) || wrong "$what: $(tail -n 5 log)"
    kill -0 "$watch_pid" 2>/dev/null || wrong "$what, and the watch ended: $(tail -n 5 log)"
    sleep 0.1
  done
}
says() { grep -q "$1" log; }
find_window() { window=$(xdotool search --onlyvisible --name "^Lesson" 2>/dev/null); }
focus() {
  xdotool windowfocus "$window" 2>/dev/null && [[ $(xdotool getwindowfocus) == "$window" ]]
}
look() { import -window "$window" "$1.ppm"; }
# shows NAME [GEOMETRY]: the window, or a part of it, is as it was then.
shows() {
  look now
  convert now.ppm ${2:+-crop "$2"} +repage now_part.ppm
  convert "$1.ppm" ${2:+-crop "$2"} +repage then_part.ppm
  cmp -s now_part.ppm then_part.ppm
}
differs() { ! shows "$@"; }

# ---- the hour ------------------------------------------------------------------------------------

answer 'float brightness() { return 1; }'
Xvfb -displayfd 3 -screen 0 1024x768x24 -nolisten tcp -noreset 3>display 2>/dev/null &
server_pid=$!
watch_pid=$server_pid
wait_for "Xvfb opens no display" test -s display
DISPLAY=:$(<display)
export DISPLAY
tree/lessons/run 9 --watch --size 480x300 2>log &
watch_pid=$!
wait_for "no window appears" find_window
wait_for "the window takes no focus" focus
wait_for "no score" says '09_disc   1 of 2'

look start
xdotool key h shift+Left shift+Left
wait_for "the camera does not move" differs start
xdotool key k
sleep 0.5
look bright

answer 'float brightness() { return 0.25F; }'
wait_for "the window does not show what was saved" differs bright 200x300+260+0
shows bright 200x300+0+0 || wrong "the kept picture or the split line is lost"
look dark

answer 'float brightness() { return bright; }'
wait_for "no error" says "^lessons/09_disc/disc.cpp:1: .*bright.* was not declared"
shows dark || wrong "an error changes the window"

answer 'float brightness() { __builtin_trap(); }'
wait_for "no crash" says "^your program crashed: "
answer 'float brightness() { for (volatile int i = 0;; i = 1 - i) {} }'
wait_for "no endless loop" says "^your program took longer"
xdotool key shift+Right shift+Left

answer 'float brightness() { return 1; }'
wait_for "the window is not as it was" shows bright
[[ $(xdotool search --onlyvisible --name "^Lesson") == "$window" ]] || wrong "it is another window"
xdotool key q
wait "$watch_pid" || wrong "the watch ends with $?: $(tail -n 5 log)"
watch_pid=""
! pgrep -f "$scratch/tree" || wrong "programs are left"
