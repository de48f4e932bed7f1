#!/usr/bin/env bash
# The atlas names every test, every test is in the atlas, and its pictures are there.
#   atlas_test.sh PROGRAM    the stability tests
set -euo pipefail
shopt -s inherit_errexit
here=$(dirname "$(realpath "$0")")
# shellcheck source=SCRIPTDIR/../words.sh
source "$here/../words.sh"
docs=$here/../../docs

tests=$("$1" --list-test-cases | grep -v -e '^\[doctest\]' -e '^==' | sort)
rows=$(awk -F ' *[|] *' '/^<!-- begin rows/ { inside = 1 } /^<!-- end rows/ { inside = 0 }
  inside && /^[|]/ && $2 !~ /^(-+|Method, and where it fails)$/ { print $2 }
  ' "$docs/stability.md" | sort)
[[ $tests == "$rows" ]] || wrong "tests (<) and rows (>) of docs/stability.md differ:
$(diff <(echo "$tests") <(echo "$rows"))"

shown=$(grep -o 'stability/[a-z0-9_]*\.png' "$docs/stability.md" | sort)
there=$(cd "$docs" && ls stability/*.png)
[[ $shown == "$there" ]] || wrong "pictures shown (<) and there (>) differ:
$(diff <(echo "$shown") <(echo "$there"))"
