#!/usr/bin/env bash
# Ctrl-C ends a campaign with 130, kills its runs and loses only those: interrupt.sh VERIFY FAKE_SOLVER
set -u
verify=$1 fake=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/cases/bar" "$folder/bin"
ln -s "$fake" "$folder/bin/mpm_pf"
echo 'title = "bar"' >"$folder/cases/bar/quick.toml"
cat >"$folder/cases/bar/expect.toml" <<'END'
title = "bar"
[[run]]
name = "short"
solver = "mpm_pf"
[[run]]
name = "long"
solver = "mpm_pf"
needs = ["short"]
set = ["fake.sleep=3"]
[[check]]
name = "exact"
take = {run = "short", number = "largest"}
against = {number = 1}
norm = "absolute"
limit = 0
source = "fake_solver.cc"
reason = "a case of which nothing is asked does not pass"
END
campaign=("$verify" --cases "$folder/cases" --solvers "$folder/bin" run --suite quick --output "$folder/out")

"${campaign[@]}" >"$folder/log" 2>&1 &
pid=$!
for _ in $(seq 100); do [ -f "$folder/out/bar/quick/long.log" ] && break; sleep 0.1; done
kill -INT $pid
wait $pid
status=$?
[ $status -eq 130 ] || { cat "$folder/log"; echo "interrupted campaign ended with $status, not 130"; exit 1; }

"${campaign[@]}" >"$folder/log" 2>&1
status=$?
[ $status -eq 0 ] || { cat "$folder/log"; echo "resumed campaign ended with $status, not 0"; exit 1; }
grep -q '"name": "short"' "$folder/out/campaign.json" || { echo "no campaign.json"; exit 1; }
/usr/bin/python3 - "$folder/out/campaign.json" <<'END' || exit 1
import json, sys
runs = json.load(open(sys.argv[1]))["cases"][0]["runs"]
assert [r["reused"] for r in runs] == [True, False], [(r["name"], r["reused"]) for r in runs]
END
echo "interrupted with 130, resumed with 0, and only the lost run was repeated"
