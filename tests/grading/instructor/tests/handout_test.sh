#!/usr/bin/env bash
# Builds the students' tree as a student does: its lessons draw from skeletons, tests of the framework
# pass, and its grader gives skeletons nothing. Files that the handout leaves as they are were
# compiled for the instructor's tree; of the tests those with most of the framework do.
#
#   handout_test.sh PROGRAM   the program is handout
set -euo pipefail
shopt -s inherit_errexit
handout=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
cd "$scratch"

wrong() {
  echo "wrong: $*"
  exit 1
}

"$handout" course
cmake -S course -B build -G Ninja -DGLINT_WERROR=ON >/dev/null
tests=(unit_math unit_raster exact_coverage)
cmake --build build --target lessons grade "${tests[@]}" >build.log || wrong "$(tail -n 40 build.log)"

for main in course/lessons/[0-9][0-9]_*/main.cpp; do
  name=$(basename "$(dirname "$main")")
  "build/bin/$name" --size 160x90 --out "$name.png" >/dev/null
  [[ -s $name.png ]] || wrong "$name draws nothing"
done

for cases in course/tests/grading/cases/*.json; do
  name=$(basename "$cases" .json)
  build/bin/grade one --lesson "$name" >score
  read -r graded points of _ <score
  [[ "$graded $points $of" == "$name 0 of" ]] || wrong "a skeleton's score: $(<score)"
done

for test in "${tests[@]}"; do
  (cd course && "../build/bin/$test") || wrong "$test"
done
