#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# soak.sh BUILD MINUTES SEED OUT: simulated missions are mapped undisturbed, and again with kills at
# random moments until they end; both must be the same bytes. Between them readers and commands get
# inputs that were damaged at random. The same seed does the same, as far as time allows.
# What was done and what failed: OUT/report.txt. Exit code 1 where anything failed.
set -uo pipefail
build=$1 minutes=$2 seed=$3 out=$4
roomatlas=$build/apps/roomatlas
end=$((SECONDS + 60 * minutes))
missions=0 kills=0 mutations=0 failures=0
rm -rf "$out"
mkdir -p "$out"

note() { printf '%s\n' "$*" | tee -a "$out/report.txt"; }
failed() {
  failures=$((failures + 1))
  note "FAILED: $*"
}
# A whole number below $1.
below() { echo $((RANDOM % $1)); }

# killed_build LOG FOLDER: killed up to five times, then left alone.
killed_build() {
  local signals=(KILL INT TERM) pid
  for _ in 1 2 3 4 5; do
    "$roomatlas" -q build "$1" -o "$2" >/dev/null 2>&1 &
    pid=$!
    sleep "0.$(below 10)$(below 10)"
    if kill -"${signals[$(below 3)]}" "$pid" 2>/dev/null; then kills=$((kills + 1)); fi
    wait "$pid" 2>/dev/null
  done
  "$roomatlas" -q build "$1" -o "$2" 2>>"$out/log.txt"
}

mission_of() {
  local number=$1 place=$out/mission sensor=() code
  ((number % 2)) && sensor=(--sensor laser)
  rm -rf "$place"
  "$roomatlas" -q simulate --random-world "$number" --max-time 120 --odometry typical \
    "${sensor[@]}" -o "$place" 2>>"$out/log.txt" || return 0  # no such world
  "$roomatlas" -q build "$place/mission.clf" -o "$place/whole" 2>>"$out/log.txt"
  code=$?
  ((code == 0 || code == 4)) || failed "mission $number: build ended with $code"
  killed_build "$place/mission.clf" "$place/killed"
  (($? == code)) || failed "mission $number: ended otherwise after kills"
  if ((code == 0)) && ! diff -r "$place/whole" "$place/killed" >>"$out/log.txt"; then
    failed "mission $number: other bytes after kills"
  fi
  missions=$((missions + 1))
}

mutations_of() {
  local number=$1 target count=500
  while read -r target; do
    "$build/tests/fuzz/replay_readers" "$target" $count "$number" >>"$out/log.txt" 2>&1 ||
      failed "replay_readers $target $count $number"
    mutations=$((mutations + count))
  done < <("$build/tests/fuzz/replay_readers" --list)
  ROOMATLAS_MUTATIONS=40 ROOMATLAS_MUTATION_SEED=$number "$build/tests/test_apps" \
    --gtest_filter='Damaged*' >>"$out/log.txt" 2>&1 || failed "test_apps Damaged*, seed $number"
  mutations=$((mutations + 100))
}

RANDOM=$seed
for ((number = seed; SECONDS < end; ++number)); do
  mission_of "$number"
  ((SECONDS < end)) && mutations_of "$number"
done
note "seed $seed, $minutes min: $missions missions, $kills kills, $mutations damaged inputs, $failures failures"
((failures == 0))
