#!/usr/bin/env bash
# Has other people's programs read what the grader writes: XML against a schema and by a reader of
# JUnit's form, HTML by a parser.
#
#   readers_test.sh GRADE
set -euo pipefail
shopt -s inherit_errexit
# shellcheck source=SCRIPTDIR/../../../words.sh
source "$(dirname "$(realpath "$0")")/../../../words.sh"
grade=$(realpath "$1")
here=$(dirname "$(realpath "$0")")
lessons=$(realpath "$here/../../../..")/lessons
command -v xmllint >/dev/null || skip "xmllint is not installed"
scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT
cd "$scratch"

# Of lesson 8 the picture is wrong, of lesson 12 nothing is compiled, of lesson 9 there is nothing.
mkdir in
sed 's/inverse_pi<T>;/T(1.0F);/' "$lessons/08_normalised_lambert/normalised_lambert.hpp" \
  >in/normalised_lambert.hpp
echo 'int <&"]]> no header' >in/schlick.hpp
"$grade" one in --lesson 8 9 12 --junit report.xml --html report.html --json report.json >/dev/null

xmllint --noout --schema "$here/junit.xsd" report.xml 2>log || wrong "$(<log)"
! xmllint --html --noout report.html 2>&1 | grep -v 'Tag .* invalid' | grep error ||
  wrong "the page is no HTML"

python=/usr/bin/python3 # where packages go
"$python" -c 'import junitparser' 2>/dev/null || skip "python3-junitparser is not installed"
"$python" - <<'END' || wrong "junitparser reads something else"
import json
from junitparser import Error, Failure, JUnitXml, Skipped

verdicts = {Failure: "wrong", Error: "compile error", Skipped: "skipped"}
read = [(case.classname, case.name, verdicts[type(case.result[0])] if case.result else "ok")
        for suite in JUnitXml.fromfile("report.xml") for case in suite]
report = json.load(open("report.json"))
written = [(f"{lesson['lesson']}.{task['id']}", case["name"], case["verdict"])
           for lesson in report["lessons"] for task in lesson["tasks"] for case in task["cases"]]
assert read == written, (read, written)
assert {verdict for _, _, verdict in read} == {"ok", "wrong", "compile error", "skipped"}
totals = JUnitXml.fromfile("report.xml")
counts = [sum(getattr(suite, what) for suite in totals)
          for what in ("tests", "failures", "errors", "skipped")]
assert counts == [len(read)] + [sum(v == verdict for _, _, v in read)
                                for verdict in ("wrong", "compile error", "skipped")], counts
END
