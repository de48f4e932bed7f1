#!/usr/bin/env bash
# Writes the gallery of the golden pictures and opens it in headless Chromium, with a keyboard, a
# mouse and a phone.
#   gallery_test.sh GALLERY COMPARE    exit code 77: skipped, for want of the word that it prints
set -euo pipefail
shopt -s inherit_errexit
# shellcheck source=SCRIPTDIR/../words.sh
source "$(dirname "$(realpath "$0")")/../words.sh"

gallery=$(realpath "$1")
compare=$(realpath "$2")
top=$(realpath "$(dirname "$0")/../..")
for tool in chromium chromedriver curl; do
  command -v $tool >/dev/null || skip "$tool is not installed"
done
scratch=$(mktemp -d)
driver_pid=""
end() {
  [[ ! $driver_pid ]] || kill "$driver_pid" 2>/dev/null || true
  wait
  rm -rf "$scratch"
}
trap end EXIT
cd "$scratch"

# ---- a project and what lessons/run leaves -------------------------------------------------------

make_project() {
  mkdir -p project/framework/app/programs project/docs/charts/results out
  cp -r "$top/lessons" project/
  cp "$top/framework/app/programs/gallery.html" project/framework/app/programs/
  printf '<svg xmlns="http://www.w3.org/2000/svg" width="40" height="30"></svg>' \
    >project/docs/charts/results/time_and_error.svg
  touch project/docs/charts/results/note.txt
}

# The golden pictures, with made-up times.
make_out() {
  local picture name previous=
  for picture in "$top"/assets/golden/*.png; do
    name=$(basename "$picture" .png)
    cp "$picture" out/
    printf '{"title": "Lesson %d: <i>\\"A&B\\"</i>", "frame_ms_min": 12.34, "fragments_shaded": %s,
      "triangles_in": 4053, "lanes": 8, "threads": 2, "samples": 4, "frames": 5,
      "instruction_set": "avx2"}' "$((10#${name%%_*}))" 1234567 >"out/$name.json"
    if [[ $previous ]]; then
      "$compare" "out/$previous.png" "$picture" --json "out/${previous}_to_$name.json" \
        --heatmap "out/${previous}_to_$name.heat.png" >/dev/null
    fi
    previous=$name
    names+=("$name")
  done
  "$gallery" project out "${names[@]}"
}

# refuses NAME MESSAGE
refuses() {
  local status=0
  "$gallery" project out "$1" 2>err || status=$?
  # shellcheck disable=SC2053
  [[ $status == 2 && $(<err) == $2 ]] || wrong "status $status, $(<err)"
}

test_bad_input() {
  refuses no_such "error: no_such: is not a lesson's name*"
  refuses 99_no_such "error: *99_no_such.png*"
}

# ---- the browser, by WebDriver (W3C) -------------------------------------------------------------

start_driver() {
  chromedriver --port=0 >driver.log 2>&1 &
  driver_pid=$!
  local deadline=$((SECONDS + 30))
  until grep -q 'successfully on port' driver.log; do
    ((SECONDS < deadline)) || wrong "chromedriver does not start: $(<driver.log)"
    sleep 0.1
  done
  driver=http://127.0.0.1:$(sed -n 's/.*successfully on port \([0-9]*\).*/\1/p' driver.log)
}

# post PATH JSON: the value that the driver answers with.
post() {
  local answer
  answer=$(curl -sS -X POST -H 'Content-Type: application/json' "$driver/$1" -d "$2")
  [[ $answer != *'"error":'* ]] || wrong "$1 $2: $answer"
  answer=${answer#'{"value":'}
  echo "${answer%\}}"
}

# open [CHROME-OPTION]: the page in a session of its own.
open() {
  local arguments='"--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
    "--window-size=1280,900"'
  session=session/$(post session '{"capabilities": {"alwaysMatch": {
      "goog:loggingPrefs": {"browser": "ALL"},
      "goog:chromeOptions": {"args": ['"$arguments"'] '"${1-}"'}}}}' |
    sed 's/.*"sessionId":"\([^"]*\)".*/\1/')
  post "$session/url" '{"url": "file://'"$scratch/out/index.html"'"}' >/dev/null
}
close() { curl -sS -X DELETE "$driver/$session" >/dev/null; }

# ask JAVASCRIPT: what the expression, without double quotes, is in the page.
ask() {
  post "$session/execute/sync" "{\"script\": \"return (${1//$'\n'/ })\", \"args\": []}"
}

# holds JAVASCRIPT WHAT
holds() { [[ $(ask "$1") == true ]] || wrong "not so: $2 ($1 is $(ask "$1"))"; }

element() {
  post "$session/element" "{\"using\": \"css selector\", \"value\": \"$1\"}" |
    sed 's/.*:"\(.*\)".*/\1/'
}

# ---- tests ---------------------------------------------------------------------------------------

test_loads() {
  local log
  log=$(post "$session/se/log" '{"type": "browser"}')
  [[ $log == "[]" ]] || wrong "the browser complains: $log"
  holds "document.querySelectorAll('main section').length == ${#names[@]} + 1" "a section a lesson"
  holds "[...document.querySelectorAll('[src], [href]')].every(e =>
    /^(data:|#)/.test(e.getAttribute('src') || e.getAttribute('href')))" "it needs no other file"
  holds "[...document.querySelectorAll('nav a')].every(a =>
    document.getElementById(a.getAttribute('href').slice(1)))" "each entry leads to its lesson"
}

test_pictures() {
  holds "document.images.length == 3 * ${#names[@]} - 2 + 1" \
    "picture, the one before, heat map, chart"
  holds "[...document.images].every(i => i.complete && i.naturalWidth > 0 && i.alt)" \
    "every picture is there, and told in words"
}

test_formulas() {
  holds "document.querySelectorAll('.formula').length == ${#names[@]}" "a formula a lesson"
  holds "[...document.querySelectorAll('math')].every(m => m.getBoundingClientRect().height > 10)" \
    "every formula is seen"
  holds "[...document.querySelectorAll('math *')].every(e => e instanceof MathMLElement)" \
    "formulas are MathML and nothing else"
}

test_words() {
  holds "document.querySelector('figcaption').textContent == '<i>\\\\x22A&B\\\\x22</i>'" \
    "titles are text"
  holds "['10.0 ns', '12.3 ms'].every(t => document.body.innerText.includes(t))" "times"
  holds "!document.body.innerText.includes('{{')" "nothing is left to fill in"
}

split() { ask "getComputedStyle(document.querySelector('.before')).clipPath"; }

test_keyboard() {
  local slider before
  slider=$(element '.slider input')
  before=$(split)
  [[ $before == *" 50% "* ]] || wrong "the split begins in the middle: $before"
  post "$session/element/$slider/value" '{"text": "\uE012\uE012"}' >/dev/null # left, left
  [[ $(split) == *" 52% "* ]] || wrong "the arrow keys move the split from $before to $(split)"
  post "$session/element/$slider/value" '{"text": "\uE010"}' >/dev/null # end
  [[ $(split) == *" 0% "* || $(split) == *" 0px "* ]] || wrong "the end key moves it to $(split)"
  holds "document.activeElement.matches('.slider input:focus-visible') &&
    getComputedStyle(document.activeElement).outlineStyle == 'solid'" "the focus is seen"
  holds "[...document.querySelectorAll('input')].every(i => i.labels.length == 1)" \
    "sliders have labels"
}

test_mouse() {
  local picture
  picture='{"element-6066-11e4-a52e-4f735466cecf": "'$(element '.split.two')'"}'
  post "$session/actions" '{"actions": [{"type": "pointer", "id": "mouse", "actions": [
    {"type": "pointerMove", "x": 0, "y": 0, "origin": '"$picture"'},
    {"type": "pointerDown", "button": 0},
    {"type": "pointerMove", "x": -195, "y": 9, "duration": 50, "origin": "pointer"},
    {"type": "pointerUp", "button": 0},
    {"type": "pointerMove", "x": 300, "y": 0, "origin": "pointer"}]}]}' >/dev/null
  holds "Math.abs(document.querySelector('.slider input').value - 25) < 3" \
    "the line follows the mouse"
  [[ $(split) == *" 7"?"% "* ]] || wrong "the mouse moves the split to $(split)"
}

test_phone() {
  holds "innerWidth == 390" "the window is a phone's"
  holds "document.documentElement.scrollWidth <= 390" "nothing is wider than a phone"
  holds "document.querySelector('.split').getBoundingClientRect().width > 340" \
    "pictures fill its width"
  holds "[...document.querySelectorAll('.formula')].every(f => f.scrollWidth <= f.clientWidth)" \
    "formulas fit"
  holds "document.querySelector('.slider input').getBoundingClientRect().height >= 32" \
    "a finger finds the slider"
}

names=()
make_project
make_out
test_bad_input
start_driver
open
for test in loads pictures formulas words keyboard mouse; do
  "test_$test"
  echo "$test: right"
done
close
open ', "mobileEmulation": {"deviceMetrics": {"width": 390, "height": 844, "pixelRatio": 2}}'
test_phone
echo "phone: right"
close
