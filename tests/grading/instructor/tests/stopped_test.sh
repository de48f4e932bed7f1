#!/usr/bin/env bash
# A grader that is stopped leaves no folder and no process behind.
#
#   stopped_test.sh GRADE
set -euo pipefail
shopt -s inherit_errexit
# shellcheck source=SCRIPTDIR/../../../words.sh
source "$(dirname "$(realpath "$0")")/../../../words.sh"
grade=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
header=$(realpath "$here/../../../..")/lessons/12_schlick/schlick.hpp
for tool in pgrep ps; do
  command -v $tool >/dev/null || skip "$tool is not installed"
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch"
cd "$scratch"
mkdir tmp
for student in {1..9}; do
  mkdir -p "in/$student"
  cp "$header" "in/$student"
done

# wait_until WHAT SECONDS COMMAND...
wait_until() {
  local what=$1 deadline=$((SECONDS + $2))
  shift 2
  until "$@" >/dev/null; do
    ((SECONDS < deadline)) || wrong "$what"
    sleep 0.02
  done
}

# start OPTION...: returns once a student is being compiled.
start() {
  TMPDIR=$scratch/tmp "$grade" "$@" --lesson 12 >/dev/null 2>&1 &
  pid=$!
  wait_until "nothing is compiled" 30 compgen -G 'tmp/*/*/work'
}

# The graders that a process started, and they: compilers end by themselves.
graders() { # PID
  local child
  for child in $(pgrep -x -P "$1" grade); do
    echo "$child"
    graders "$child"
  done
}

for what in "class in --out out --jobs 2" "one in/1"; do
  read -ra words <<<"$what"
  status=0
  start "${words[@]}"
  kill -TERM "$pid"
  wait "$pid" || status=$?
  ((status == 143)) || wrong "$what, terminated, ends with $status"
  [[ ! $(ls tmp) ]] || wrong "$what, terminated, leaves $(ls tmp)"
done

# Students that are graded for seconds after that.
for student in {1..9}; do
  echo '[[gnu::constructor]] static void run_on() { for (volatile int i = 0;; ++i) {} }' \
    >>"in/$student/schlick.hpp"
done
start class in --out out --jobs 2
mapfile -t started < <(graders "$pid")
((${#started[@]} >= 3)) || wrong "no graders: ${started[*]}"
kill -KILL "$pid"
wait "$pid" 2>/dev/null || true
# But for what nobody has waited for yet.
all_gone() { ! ps -o stat= -p "$(IFS=, && echo "${started[*]}")" | grep -v '^Z'; }
wait_until "a grader goes on without its parent" 4 all_gone
