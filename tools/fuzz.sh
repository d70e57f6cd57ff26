#!/usr/bin/env bash
# Runs every fuzz target of a build for an equal share of the time, from the corpus in the sources.
# New inputs stay in the build folder; a crash ends the run and leaves its input there.
# Usage: fuzz.sh BUILD SECONDS
set -euo pipefail
build=$(realpath "$1") seconds=$2
seeds=$(realpath "$(dirname "$0")/../tests/fuzz/corpus")

mapfile -t targets < <(find "$build" -type f -executable -name 'fuzz_*' | sort)
[ ${#targets[@]} -gt 0 ] || { echo "fuzz: no target in $build" >&2; exit 1; }
share=$(((seconds + ${#targets[@]} - 1) / ${#targets[@]}))
for target in "${targets[@]}"; do
    name=$(basename "$target")
    name=${name#fuzz_}
    work=$build/corpus/$name
    mkdir -p "$work"
    echo "fuzz: $name for $share s"
    "$target" "$work" "$seeds/$name" -max_total_time="$share" -timeout=10 -rss_limit_mb=2048 \
        -artifact_prefix="$build/crash-$name-" -print_final_stats=1 > "$work.log" 2>&1 ||
        { tail -n 40 "$work.log"; echo "fuzz: $name failed; its input is $build/crash-$name-*" >&2
          exit 1; }
    grep -E 'number_of_executed_units' "$work.log"
done
echo "fuzz: ${#targets[@]} targets, no crash"
