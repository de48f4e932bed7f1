#!/usr/bin/env bash
# Runs once, when Gradescope makes the image: installs what is missing and builds the grader.
set -euo pipefail
shopt -s inherit_errexit
here=$(dirname "$(realpath "$0")")
# shellcheck source=SCRIPTDIR/../../../../framework/setup.sh
source "$here/glint/framework/setup.sh"
install "${build_needs[@]}" "${test_needs[@]}"
build release "$here/glint/build" grade
chmod -R go= "$here" # manifests, mutants and the secret are nobody else's
