# How a test that is a script ends; for bash scripts to source.
# shellcheck shell=bash

# CTest counts 77 as skipped.
skip() {
  echo "skipped: $*"
  exit 77
}

wrong() {
  echo "wrong: $*"
  exit 1
}
