#!/usr/bin/env bash
# Tests lessons/run and tests/run from outside, in a folder of its own and without a network.
# GLINT_BUILD names a folder where the lessons are built.
set -euo pipefail
shopt -s inherit_errexit
top=$(realpath "$(dirname "$0")/../..")
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
cd "$scratch"

# call COMMAND...: leaves what it said in out and err, how it ended in status.
call() {
  called=$*
  status=0
  "$@" >.out 2>.err || status=$?
  out=$(<.out)
  err=$(<.err)
}

# expect STATUS OUT ERR: what the last call gave, as patterns.
expect() {
  # shellcheck disable=SC2053
  if [[ $status != "$1" || $out != $2 || $err != $3 ]]; then
    wrong "status $1, output '$2' and errors '$3'"
  fi
}

# expect_lines COUNT REGEX: so many lines of output match.
expect_lines() {
  [[ $(grep -cE "$2" .out) == "$1" ]] || wrong "$1 lines like '$2'"
}

wrong() {
  printf '%s\nwas to give %s; it gave\nstatus %s\noutput:\n%s\nerrors:\n%s\n' \
    "$called" "$1" "$status" "$out" "$err"
  exit 1
}

run() { call "$top/lessons/run" "$@"; }

test_help() {
  run --help
  expect 0 "*lessons/run compare*Examples:*" ""
  call "$top/tests/run" --help
  expect 0 "*tests/run*Examples:*" ""
  call "$top/tests/handout" --help
  expect 0 "*tests/handout ../course*" ""
}

test_list() {
  run list
  expect 0 "00_hello_shader *" ""
  local mains=("$top"/lessons/[0-9][0-9]_*/main.cpp)
  expect_lines ${#mains[@]} '^[0-9]{2}_[a-z0-9_]+ +Lesson [0-9]+: .'
}

test_wrong_words() {
  call "$top/tests/handout"
  expect 2 "" "error: name one folder*"
  local word
  for word in 99 1x 01_ad_hoc -1 18446744073709551617; do
    run "$word"
    expect 2 "" "error: there is no lesson $word;*"
  done
  run compare 1
  expect 2 "" "error: compare needs two*"
  run compare 99 1
  expect 2 "" "error: there is no lesson 99;*"
}

test_statistics_are_alone() {
  run 1 --size 64x36 --out 1.png --stats -
  expect 0 "{*\"fragments_shaded\": *}" "*01_ad_hoc_phong: *"
  expect_lines "$(wc -l <.out)" '^([{}]|  "[a-z_]+": .*)$'
}

# --out above and the pictures here are found where the caller is, not where the project is.
test_compare() {
  run compare 1.png ./1.png --heatmap heat.png --side-by-side all.png --json -
  expect 0 "{*\"flip_max\": 0.0*}" "*compare 1.png ./1.png *"
  [[ -s heat.png && -s all.png ]] || wrong "two pictures"
  run compare 1.png missing.png --heatmap heat.png --side-by-side all.png
  expect 2 "" "*error: *missing.png*"
}

# A project of two lessons that draw at once, and a folder where all is built.
make_project() {
  local name data=$top/tests/data/metrics
  mkdir -p project/framework/app/programs project/lessons project/assets/golden built/bin
  cp "$top/framework/setup.sh" project/framework/
  cp "$top/framework/app/programs/gallery.html" project/framework/app/programs/
  cp "$top/lessons/run" project/lessons/
  for name in 01_one 02_two; do
    mkdir "project/lessons/$name"
    echo ".title = \"Lesson: $name\"," >"project/lessons/$name/main.cpp"
    cat >"built/bin/$name" <<END
#!/bin/bash
# $name [--frames N] --out PICTURE [--stats FILE]
[[ \$1 != --frames ]] || shift 2
[[ ! -e $scratch/broken_$name ]] || exit 2
cp "$scratch/$name.png" "\$2"
[[ \$# == 2 ]] || echo '{"title": "T", "frame_ms_min": 1, "fragments_shaded": 9, "triangles_in": 9,
  "lanes": 1, "threads": 1, "samples": 4, "frames": 5, "instruction_set": "x"}' >"\$4"
echo "$name: drawn"
END
    chmod +x "built/bin/$name"
    cp "$data/sphere.png" "$name.png"
    cp "$data/sphere.png" "project/assets/golden/$name.png"
  done
  ln -s "$GLINT_BUILD"/bin/{compare,gallery} built/bin/
  printf 'rule none\n  command = true\nbuild lessons compare: phony\n' >built/build.ninja
  printf '%s\n' CMAKE_PROJECT_NAME:STATIC=Glint "CMAKE_HOME_DIRECTORY:INTERNAL=$scratch/project" \
    CMAKE_GENERATOR:INTERNAL=Ninja "CMAKE_MAKE_PROGRAM:FILEPATH=$(command -v ninja)" \
    >built/CMakeCache.txt
}

run_project() { call env GLINT_BUILD="$scratch/built" project/lessons/run "$@"; }

test_all_lessons() {
  run_project
  expect 0 "01_one: drawn
02_two: drawn; FLIP from 01_one: mean 0, max 0" "The gallery of all is *out/index.html"
  local left=(01_one.json 01_one.png 01_one_to_02_two.heat.png 01_one_to_02_two.json 02_two.json
    02_two.png index.html)
  [[ $(ls project/out) == "$(printf '%s\n' "${left[@]}")" ]] || wrong "${left[*]} in out"
}

test_check() {
  run_project --check
  expect 0 "01_one: as it was*02_two: as it was*" ""
  cp "$top/tests/data/metrics/sphere_noise.png" 02_two.png
  run_project --check
  expect 1 "01_one: as it was*
02_two: WRONG, rmse is 7.54016, --max-rmse 0.05 is the limit;over_one is 0.995*
  worst pixel 92,57: 255 156 126, was 255 159 160
*02_two.diff.png" "1 of 2 lessons are not as they were: 02_two"
  [[ -s project/out/02_two.diff.png ]] || wrong "the difference as a picture"
  rm project/assets/golden/01_one.png
  run_project --check
  expect 1 "01_one: WRONG, there is no golden *01_one.png
02_two: WRONG*" "2 of 2 lessons*"
  cp "$top/assets/golden/09_normalised_phong.png" project/assets/golden/01_one.png
  touch broken_02_two
  run_project --check
  expect 1 "01_one: WRONG, error:*960x540*
02_two: WRONG, it cannot be drawn" "2 of 2 lessons*"
}

test_program_errors() {
  run 01 --size 0x0
  expect 2 "" "error: --size*"
}

# A machine that has nothing but these.
bare_machine() {
  mkdir bin
  local tool
  for tool in bash dirname realpath basename mktemp cat rm tail sed grep env; do
    ln -s "$(command -v "$tool")" bin/
  done
}

test_unknown_system() {
  call env PATH="$scratch/bin" "$top/lessons/run" 1
  expect 2 "" "error: these are missing: c++ cmake ninja;*apt-get install*g++ cmake ninja-build"
}

test_installs_once() {
  printf '#!/bin/sh\nexec "$@"\n' >bin/sudo
  printf '#!/bin/sh\necho "$@" >>%s\n' "$scratch/asked" >bin/apt-get
  chmod +x bin/sudo bin/apt-get
  call env PATH="$scratch/bin" "$top/lessons/run" 1
  [[ $err == "Installing g++ cmake ninja-build;"* ]] || wrong "a word on what is installed"
  called="apt-get"
  out=$(<asked)
  expect "$status" $'update -qq\ninstall -qq --no-install-recommends g++ cmake ninja-build' "*"
}

test_failed_installation() {
  printf '#!/bin/sh\necho no network; exit 100\n' >bin/apt-get
  call env PATH="$scratch/bin" "$top/lessons/run" 1
  expect 2 "" "*no network*error: apt-get install --no-install-recommends g++ cmake * failed*"
}

test_help
test_list
test_wrong_words
test_statistics_are_alone
test_compare
make_project
test_all_lessons
test_check
test_program_errors
bare_machine
test_unknown_system
test_installs_once
test_failed_installation
