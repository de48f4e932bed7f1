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
}

test_list() {
  run list
  expect 0 "00_hello_shader *" ""
  local mains=("$top"/lessons/[0-9][0-9]_*/main.cpp)
  expect_lines ${#mains[@]} '^[0-9]{2}_[a-z0-9_]+ +Lesson [0-9]+: .'
}

test_wrong_words() {
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
test_program_errors
bare_machine
test_unknown_system
test_installs_once
test_failed_installation
