#!/usr/bin/env bash
# Opens a lesson's window on a display of its own, uses keys and mouse, and looks at what is shown.
#   window_test.sh PROGRAM    exit code 77: skipped, for want of the word that it prints
set -euo pipefail
shopt -s inherit_errexit
# shellcheck source=SCRIPTDIR/../words.sh
source "$(dirname "$(realpath "$0")")/../words.sh"

program=$(realpath "$1")
for tool in Xvfb xdotool import convert cmp; do
  command -v $tool >/dev/null || skip "$tool is not installed"
done
scratch=$(mktemp -d)
window_pid=""
server_pid=""
end() {
  [[ ! $window_pid ]] || kill "$window_pid" 2>/dev/null || true
  [[ ! $server_pid ]] || kill "$server_pid" 2>/dev/null || true
  rm -rf "$scratch"
}
trap end EXIT
cd "$scratch"
# What X libraries hold at the end is not ours to judge.
export ASAN_OPTIONS=${ASAN_OPTIONS:+$ASAN_OPTIONS:}detect_leaks=0
unset DISPLAY WAYLAND_DISPLAY SDL_VIDEODRIVER

# ---- tools ---------------------------------------------------------------------------------------

# wait_for WHAT COMMAND...: until the command succeeds, half a minute at most.
wait_for() {
  local what=$1 deadline=$((SECONDS + 30))
  shift
  until "$@"; do
    ((SECONDS < deadline)) || wrong "$what"
    sleep 0.05
  done
}

# draw NAME OPTION...: the program's own picture, NAME.png.
draw() {
  "$program" --size 480x300 --out "$1.png" "${@:2}" >/dev/null
}

open_window() {
  "$program" --window --size 480x300 --out picture.png "$@" &
  window_pid=$!
  wait_for "no window appears" find_window
  wait_for "the window takes no focus" focus
}
find_window() { window=$(xdotool search --onlyvisible --name "^Lesson" 2>/dev/null); }
focus() {
  xdotool windowfocus "$window" 2>/dev/null && [[ $(xdotool getwindowfocus 2>/dev/null) == "$window" ]]
}

closes_with_0() {
  local status=0
  wait "$window_pid" || status=$?
  window_pid=""
  ((status == 0)) || wrong "the window ends with $status after $1"
}

key() { xdotool key "$@"; }
move() { xdotool mousemove --window "$window" "$@"; }
drag() { # FROM_X FROM_Y TO_X TO_Y
  move "$1" "$2"
  xdotool mousedown 1
  move $((($1 + $3) / 2)) $((($2 + $4) / 2))
  move "$3" "$4"
  xdotool mouseup 1
}

# same NAME [CROP]: the window, or a part of it, shows NAME.png.
same() {
  look "$@" && cmp -s expected.ppm window.ppm
}
# other NAME [CROP]: a hundred pixels at least are not those of NAME.png.
other() {
  look "$@" && (($({ cmp -l expected.ppm window.ppm || true; } | wc -l) >= 300))
}
look() {
  local crop=(${2:+-crop "$2"} +repage -depth 8)
  import -window "$window" "${crop[@]}" window.ppm && convert "$1.png" "${crop[@]}" expected.ppm
}

shows() { wait_for "the window does not show $*" same "$@"; }
moves_from() { wait_for "the window still shows $1" other "$1"; }

# ---- tests ---------------------------------------------------------------------------------------

test_no_display() {
  local status=0
  "$program" --window 2>err || status=$?
  ! grep -q "has no SDL2" err || skip "SDL2 was not there when this was built"
  [[ $status == 2 && $(<err) == "error: --window: there is no display"* ]] ||
    wrong "without a display: status $status, $(<err)"
  [[ $(wc -l <err) == 1 ]] || wrong "without a display there is more than one line: $(<err)"
}

start_server() {
  Xvfb -displayfd 3 -screen 0 1024x768x24 -nolisten tcp -noreset 3>display 2>/dev/null &
  server_pid=$!
  wait_for "Xvfb opens no display" test -s display
  DISPLAY=:$(<display)
  export DISPLAY
}

test_picture() {
  draw picture
  open_window
  wait_for "no words lie over the picture" other picture 200x60+0+0
  key h
  shows picture
}

test_camera() {
  drag 240 200 290 180
  moves_from picture
  key r
  shows picture
  for keys in Right Up shift+Left shift+Down Prior Next; do
    key "$keys"
    moves_from picture
    key Home
    shows picture
  done
  move 240 200
  xdotool click 4
  moves_from picture
  key Home
  shows picture
}

test_settings() {
  draw triangles --view triangle
  draw samples --samples 8
  draw three_lamps --set lights=2
  key 4
  shows triangles
  key 1
  shows picture
  key m
  shows samples
  key m m m m
  shows picture
  key t l c
  key t l c
  key plus
  shows three_lamps
  key minus
  shows picture
}

test_comparison() {
  key k plus
  shows picture 230x300+0+0
  shows three_lamps 230x300+250+0
  drag 240 150 120 150
  shows picture 110x300+0+0
  shows three_lamps 350x300+130+0
  key d
  moves_from three_lamps
  key d
  shows three_lamps
  key minus
  shows picture
}

test_probe() {
  move 60 200
  xdotool click 1
  wait_for "no pixel is explained" other picture 200x200+260+20
  [[ $(convert window.ppm -format '%[fx:mean < 0.4]' info:) == 1 ]] || wrong "no dark panel"
  key Escape
  shows picture
}

test_save() {
  key s
  wait_for "no picture is saved" test -s picture-shot.png
  cmp picture.png picture-shot.png || wrong "the saved picture is not the program's"
}

test_resize() {
  "$program" --size 300x340 --out resized.png >/dev/null
  xdotool windowsize "$window" 300 340
  shows resized
}

test_idle() {
  local before after
  before=$(cpu_ticks)
  sleep 0.5
  after=$(cpu_ticks)
  ((after - before < 10)) || wrong "an idle window took $((after - before)) ticks in half a second"
}
cpu_ticks() { awk '{ print $14 + $15 }' "/proc/$window_pid/stat"; }

test_close() {
  key q
  closes_with_0 "Q"
  open_window
  kill -TERM "$window_pid"
  closes_with_0 "SIGTERM"
  "$program" --window --size 480x300 --frames 3 || wrong "--frames 3 ends with $?"
}

test_compare_option() {
  open_window --compare three_lamps.png
  key h
  shows three_lamps 230x300+0+0
  shows picture 230x300+250+0
  key q
  closes_with_0 "Q"
}

test_no_display
start_server
for test in picture camera settings comparison probe save resize idle close compare_option; do
  "test_$test"
  echo "$test: right"
done
