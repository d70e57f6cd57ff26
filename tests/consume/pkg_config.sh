#!/bin/sh
# Builds hello.cpp with what pkg-config says of the batten installed under a prefix, and runs it.
# Usage: pkg_config.sh COMPILER PREFIX OUTPUT
set -eu
compiler=$1 prefix=$2 output=$3
PKG_CONFIG_PATH=$(dirname "$(find "$prefix" -name batten.pc)")
export PKG_CONFIG_PATH
# shellcheck disable=SC2046 # pkg-config answers with several words
"$compiler" hello.cpp -o "$output" $(pkg-config --cflags --libs batten) \
    -Wl,-rpath,"$(pkg-config --variable=libdir batten)"
"$output"
