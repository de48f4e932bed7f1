#!/usr/bin/env bash
# Builds the students' tree as a student does: its lessons draw from skeletons, tests of the framework
# pass, and its grader gives skeletons nothing. Files that the handout leaves as they are were
# compiled for the instructor's tree, so one test does, and few lanes in few units, which are soon
# built.
#
#   handout_test.sh PROGRAM   the program is handout
set -euo pipefail
shopt -s inherit_errexit
# shellcheck source=SCRIPTDIR/../../../words.sh
source "$(dirname "$(realpath "$0")")/../../../words.sh"
handout=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
cd "$scratch"

"$handout" course
few_lanes=()
[[ $(uname -m) != x86_64 ]] || few_lanes=(-DGLINT_ARCH=x86-64-v2)
cmake -S course -B build -G Ninja -DGLINT_WERROR=ON -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG=-O1 -DCMAKE_UNITY_BUILD=ON "${few_lanes[@]}" >/dev/null
cmake --build build --target lessons grade unit_scene >build.log || wrong "$(tail -n 40 build.log)"

for main in course/lessons/[0-9][0-9]_*/main.cpp; do
  name=$(basename "$(dirname "$main")")
  "build/bin/$name" --size 160x90 --out "$name.png" >/dev/null
  [[ -s $name.png ]] || wrong "$name draws nothing"
done

for cases in course/tests/grading/cases/*.json; do
  name=$(basename "$cases" .json)
  build/bin/grade one --lesson "$name" >score
  read -r graded points of _ < <(grep "^$name " score)
  [[ "$graded $points $of" == "$name 0 of" ]] || wrong "a skeleton's score: $(<score)"
done

(cd course && ../build/bin/unit_scene) || wrong "unit_scene"
