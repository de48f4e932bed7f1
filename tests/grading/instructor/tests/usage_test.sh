#!/usr/bin/env bash
# What is asked wrongly ends with a line that says how to mend it, and leaves nothing behind.
#
#   usage_test.sh GRADE
set -euo pipefail
shopt -s inherit_errexit
# shellcheck source=SCRIPTDIR/../../../words.sh
source "$(dirname "$(realpath "$0")")/../../../words.sh"
grade=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
cd "$scratch"

# refuses TEXT ARGUMENT...: TEXT is in the one line of the error.
refuses() {
  local text=$1 status=0
  shift
  "$grade" "$@" >said 2>err || status=$?
  ((status == 2)) || wrong "grade $* ends with $status, not 2: $(<err)"
  (($(wc -l <err) == 1)) || wrong "grade $*: not one line: $(<err)"
  [[ $(<err) == "error: "*"$text"* ]] || wrong "grade $*: the error lacks '$text': $(<err)"
}

mkdir -p in/ada bin

# ---- options -------------------------------------------------------------------------------------

refuses "subcommand"
refuses "--lesosn" one in/ada --lesosn 12
refuses "nowhere" class nowhere --out out
refuses "--jobs" class in --out out --jobs 0
refuses "--part 0/4x" class in --out out --part 0/4x
refuses "--part 4/4" class in --out out --part 4/4
refuses "--out in/out" class in --out in/out
refuses "nowhere" one nowhere
echo '{"users": [' >broken.json
refuses "broken.json" one in/ada --metadata broken.json
echo '{}' >broken.json
refuses "broken.json" one in/ada --metadata broken.json
"$grade" one --help | grep -q -- --gradescope || wrong "grade one --help does not say what there is"

# ---- without Slurm -------------------------------------------------------------------------------

printf '#!/bin/sh\necho "squeue: no controller" >&2\nexit 1\n' >bin/squeue
chmod +x bin/squeue
PATH=$scratch/bin:$PATH refuses "no controller" class in --out out --slurm --lesson 12
[[ ! -e out ]] || wrong "something was written, though there is no Slurm"

# ---- what is written for others ------------------------------------------------------------------

head -c 8 /dev/urandom >short
head -c 16 /dev/urandom >secret
echo old >a.zip
refuses "16 bytes" bundle gradescope a.zip --secret short --assignment a --lesson 12
[[ $(<a.zip) == old ]] || wrong "an archive that failed took the old one's place"
refuses "nowhere" bundle gradescope nowhere/a.zip --secret secret --assignment a --lesson 12
refuses "in/ada: has no schlick.hpp" export jplag in --out out --handout in/ada --lesson 12
refuses "nowhere" export jplag in --out nowhere/out --handout in/ada --lesson 12
[[ ! -e out && ! -e nowhere ]] || wrong "half a folder for JPlag is left"
