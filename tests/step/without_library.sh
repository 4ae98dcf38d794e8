#!/usr/bin/env bash
# A command that was copied without the library that reads STEP says so, in one line and with exit status 2, and writes nothing.
#   without_library.sh HSR PART.step
set -euo pipefail
directory=$(mktemp -d)
trap 'rm -rf "$directory"' EXIT
cp "$1" "$directory/hsr"
status=0
"$directory/hsr" draw "$2" -o "$directory/x.svg" 2>"$directory/said" || status=$?
cat "$directory/said"
[ "$status" = 2 ]
[ "$(wc -l <"$directory/said")" = 1 ]
grep -q "found no library hsr_step.so" "$directory/said"
[ ! -e "$directory/x.svg" ]
