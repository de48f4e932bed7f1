#!/usr/bin/env bash
# Bundles an autograder and runs it in a folder laid out as Gradescope's.
#
#   gradescope_test.sh GRADE   the grader that setup.sh would build
set -euo pipefail
shopt -s inherit_errexit
# shellcheck source=SCRIPTDIR/../../../words.sh
source "$(dirname "$(realpath "$0")")/../../../words.sh"
grade=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
top=$(realpath "$here/../../../..")
for tool in zip unzip; do
  command -v $tool >/dev/null || skip "$tool is not installed"
done
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
chmod 755 "$scratch"
cd "$scratch"

head -c 32 /dev/urandom >secret
"$here/../gradescope/bundle" a.zip secret "week 'one'" 12
mkdir -p autograder/{source,submission,results}
unzip -q a.zip -d autograder/source
[[ -x autograder/source/setup.sh && ! -e autograder/source/glint/.git ]] || wrong "the bundle"
cp autograder/source/run_autograder autograder/
echo '{"users": [{"id": 7, "email": "b@x"}, {"id": 3, "email": "a@x"}]}' \
  >autograder/submission_metadata.json

# run: with the header that is there; leaves the results.
run() {
  rm -f autograder/results/results.json
  AUTOGRADER=$scratch/autograder GLINT_GRADE=$grade autograder/run_autograder >log 2>&1 || true
}

cp "$top/lessons/12_schlick/schlick.hpp" autograder/submission/
run
grep -q '^ "score": 6.0,' autograder/results/results.json || wrong "right answers: $(<log)"

echo '[[gnu::constructor]] static void early() { __builtin_trap(); }' \
  >>autograder/submission/schlick.hpp
run
grep -q '^ "score": 0.0,' autograder/results/results.json || wrong "a crash: $(<log)"

rm autograder/submission/schlick.hpp
run
grep -q 'not handed in' autograder/results/results.json || wrong "nothing handed in: $(<log)"

grade=/bin/false
run
grep -q 'this is no grade' autograder/results/results.json || wrong "no provisional result"
