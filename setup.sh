#!/usr/bin/env bash
# Installs the system packages that building Batten needs. Run without arguments for the groups.
set -euo pipefail

declare -A packages=(
    [core]="g++ cmake ninja-build make libeigen3-dev libboost-dev libcli11-dev libfmt-dev
            nlohmann-json3-dev libpng-dev"
    [demo]="python3"
    [test]="libgtest-dev librapidcheck-dev python3 python3-ezdxf pkg-config"
    [python]="python3-dev python3-numpy pybind11-dev"
    [package]="dpkg-dev file"
    [bench]="libbenchmark-dev libgsl-dev libspiro-dev python3-numpy python3-scipy"
    [clang]="clang libclang-rt-dev"
    [wasm]="emscripten"
    [gdal]="libgdal-dev"
    [draw]="gnuplot-nox librsvg2-bin"
    [reference]="python3-numpy python3-scipy"
    [develop]="ccache clang-format"
)
declare -A purposes=(
    [core]="the library and the command"
    [demo]="the demo's own data (make demo)"
    [test]="the tests (make test, make asan, make tsan)"
    [python]="the Python module and its tests (make python)"
    [package]="the .tar.gz and the .deb (make package)"
    [bench]="the benchmark and its peers (make bench)"
    [clang]="the clang build and the fuzzers (make clang, make fuzz)"
    [wasm]="the core in WebAssembly (make wasm)"
    [gdal]="GeoTIFF and other rasters as grids (-DBATTEN_WITH_GDAL=ON)"
    [draw]="charts as PNG and PDF, PNG copies of pictures"
    [reference]="the programs in tools/ that remake reference data"
    [develop]="faster rebuilds, one layout of the sources"
)
order="core demo test python package bench clang wasm gdal draw reference develop"

usage() {
    local each
    echo "Usage: ./setup.sh GROUP..."
    for each in $order; do printf '  %-10s %s\n' "$each" "${purposes[$each]}"; done
    printf '  %-10s %s\n' all "everything above"
}

die() {
    echo "setup: $*" >&2
    exit 1
}

[ $# -gt 0 ] || { usage; exit 0; }
groups=()
for group in "$@"; do
    case "$group" in
        -h | --help) usage; exit 0 ;;
        all) for each in $order; do groups+=("$each"); done ;;
        *)
            [ -n "${packages[$group]:-}" ] || { usage >&2; die "no group is called $group"; }
            groups+=("$group")
            ;;
    esac
done
wanted=()
for group in "${groups[@]}"; do
    # shellcheck disable=SC2206 # a group's text is split into its words
    wanted+=(${packages[$group]})
done

if ! command -v apt-get > /dev/null || ! command -v dpkg-query > /dev/null; then
    echo "setup: this is no Debian or Ubuntu. Please see that your system has what these packages"
    echo "setup: of Debian hold: ${wanted[*]}"
    exit 0
fi

installed() {
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2> /dev/null)" = installed ]
}

missing=()
for package in "${wanted[@]}"; do
    installed "$package" || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

install=(apt-get install -y --no-install-recommends)
as_root=()
if [ "$(id -u)" != 0 ]; then
    command -v sudo > /dev/null || die "missing packages; as root, run: ${install[*]} ${missing[*]}"
    as_root=(sudo)
fi

echo "setup: fetching the list of packages"
"${as_root[@]}" apt-get update -qq
available=()
for package in "${missing[@]}"; do
    # Older systems have the clang run-time library inside clang itself.
    if [ "$package" = libclang-rt-dev ] && ! apt-cache show "$package" > /dev/null 2>&1; then
        continue
    fi
    available+=("$package")
done
[ ${#available[@]} -gt 0 ] || exit 0
echo "setup: installing ${available[*]}"
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive "${install[@]}" -qq "${available[@]}" < /dev/null ||
    die "that failed; as root, run: ${install[*]} ${available[*]}"
