#!/usr/bin/env bash
# Fair curves through real data, step by step: each command is shown, then run.
set -euo pipefail
cd "$(dirname "$0")/.."
export PATH="$PWD/build/release/bin:$PATH"
points=cases/points
out=build/demo
mkdir -p "$out"

say() { printf '\n%s\n' "$*"; }
run() {
    printf '  $ %s\n' "$*"
    "$@" 2>&1 | sed 's/^/    /'
}

say "1. A violin's body, 36 points typed by hand, four of them corners."
run batten interpolate $points/violin.csv --closed --corner 6,12,24,30 \
    -o $out/violin.json --draw $out/violin.svg
say "   How good is it?"
run batten measure $out/violin.json -o $out/violin-measures.json

say "2. An aerofoil (RAE 2822): closed at its sharp trailing edge."
run batten interpolate $points/rae2822.dat -o $out/aerofoil.json --draw $out/aerofoil.svg

say "3. Four points where the classical methods make needles (Inoue & Shibata, Table 2)."
for method in natural-uniform natural-chord hermite-chord hermite-arc pseudo-spline; do
    run batten interpolate $points/inoue-shibata-table-2.csv --method $method --quiet \
        -o $out/$method.json
done
run batten draw $out/natural-uniform.json $out/natural-chord.json $out/hermite-chord.json \
    $out/hermite-arc.json $out/pseudo-spline.json $points/inoue-shibata-table-2.csv \
    -o $out/needles.svg --quiet
run batten compare $out/pseudo-spline.json --to $points/inoue-shibata-table-2.csv \
    -o $out/needles-compared.json

say "4. A car's side line, heights rounded to whole millimetres: made fair within 1 mm."
run batten fair $points/car-side.csv --sigma 0.29 --tolerance 1 -o $out/car-side.csv \
    --draw $out/car-side.svg
say "   The same as a chain of log-aesthetic arcs; how far are the points from it?"
run batten fair $points/car-side.csv --sigma 0.29 --tolerance 1 --as arcs -o $out/car-side.json
run batten compare $out/car-side.json --to $points/car-side.csv --tolerance 1.2 \
    -o $out/car-side-compared.json
run batten measure $out/car-side.json -o $out/car-side-measures.json --draw $out/car-side-curvature.svg
say "   Walk along it as fast as 1.5 m/s, and 2 m/s2 across and along, allow."
run batten sample $out/car-side.json --law time-optimal --max-speed 1500 --max-lateral 2000 \
    --max-tangential 2000 --fps 25 -o $out/car-side-walk.csv --draw $out/car-side-walk.svg
say "   For the machine: circular arcs within 0.2 mm, as DXF and as G-code."
run batten arcs $out/car-side.json --tolerance 0.2 -o $out/car-side.dxf \
    --draw $out/car-side-arcs.svg
run batten arcs $out/car-side.json --tolerance 0.2 --feed 1200 -o $out/car-side.gcode --quiet

say "5. The titanium data, a property against temperature: as many knots as the data carry."
run batten fit cases/fits/titanium.csv -o $out/titanium.json --draw $out/titanium.svg

say "6. A noisy dome on 150 x 100 nodes: a surface, its level line, the curvature of that."
say "   The level is a circle of radius 0.3: length 1.88496, curvature 3.33333."
python3 tools/make_dome.py > $out/dome.csv
run batten fit-surface $out/dome.csv --sigma 0.002 --degree 5 -o $out/dome.json \
    --draw $out/dome.svg
run batten contour $out/dome.json --levels 0.835270211 -o $out/dome-level.json \
    --draw $out/dome-level.svg
run batten measure $out/dome-level.json -o $out/dome-level-measures.json \
    --draw $out/dome-level-curvature.svg

data=../shared/data
if [ -r $data/car-key-line-1.txt ]; then
    say "7. A car's character line as measured, 808 points, seen from the side: fair within 0.5 mm."
    awk '{ print $2 "," $3 }' $data/car-key-line-1.txt > $out/key-line-points.csv
    key_line="$out/key-line-points.csv --sigma 0.1 --tolerance 0.5"
    run batten fair $key_line -o $out/key-line.csv --draw $out/key-line.svg
    run batten fair $key_line --as arcs -o $out/key-line.json --quiet
    run batten compare $out/key-line.json --to $out/key-line-points.csv --tolerance 0.55 \
        -o $out/key-line-compared.json
    run batten sample $out/key-line.json --count 100 -o $out/key-line-samples.csv \
        --draw $out/key-line-samples.svg
    run batten arcs $out/key-line.json --tolerance 0.05 -o $out/key-line.dxf \
        --draw $out/key-line-arcs.svg
    run batten arcs $out/key-line.json --tolerance 0.05 --feed 1200 -o $out/key-line.gcode --quiet
    say "   A cat's outline and a race track, closed, with their curvature before and after."
    run batten fair $data/cat.csv --closed --sigma 0.7 --tolerance 2 -o $out/cat.csv \
        --draw $out/cat.svg
    run batten fair $data/monza-track.csv --columns x_m,y_m --closed --sigma 0.25 --tolerance 1 \
        -o $out/monza.csv --draw $out/monza.svg
fi

say "Pictures: $out/*.svg"
