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
"$grade" bundle gradescope a.zip --secret secret --assignment "week 'one'" --lesson 12
mkdir -p autograder/{source,submission,results}
unzip -q a.zip -d autograder/source
[[ -x autograder/source/setup.sh && ! -e autograder/source/glint/.git ]] || wrong "the bundle"
cp autograder/source/run_autograder autograder/
echo '{"users": [{"id": 7, "email": "b@x"}, {"id": 3, "email": "a@x"}]}' \
  >autograder/submission_metadata.json

# ---- the image is made: all but the compiler's work is done --------------------------------------

# A machine without ninja and unzip, where packages come from nowhere and the grader is built in no time.
mkdir bin
ln -s /usr/bin/* bin/
rm -f bin/{ninja,unzip,apt-get,cmake,sudo}
cat >bin/apt-get <<END
#!/bin/sh
echo "\$*" >>$scratch/packages
case \$* in *ninja-build*) ln -s $(command -v ninja) $scratch/bin/ninja ;; esac
END
cat >bin/cmake <<END
#!/bin/sh
case \$* in
  --build*-n) ;;
  --build*) mkdir -p "\$2/bin" && exec ln -s $grade "\$2/bin/grade" ;;
esac
exec $(command -v cmake) "\$@"
END
printf '#!/bin/sh\nexec "$@"\n' >bin/sudo
chmod +x bin/{apt-get,cmake,sudo}
PATH=$scratch/bin autograder/source/setup.sh &>log || wrong "setup.sh: $(<log)"
grep -q '^install .*ninja-build.* unzip' packages || wrong "setup.sh does not install what is missing"
[[ $(stat -c %a autograder/source/secret) == ?00 ]] || wrong "others may read the secret"

# ---- submissions come ----------------------------------------------------------------------------

# run: with the header that is there; leaves the results.
run() {
  rm -f autograder/results/results.json
  AUTOGRADER=$scratch/autograder autograder/run_autograder >log 2>&1 || true
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

ln -sf /bin/false autograder/source/glint/build/bin/grade
run
grep -q 'this is no grade' autograder/results/results.json || wrong "no provisional result"
