#!/bin/sh
# Stands before the compiler in the add_subdirectory test: an object of the core that the build
# around the test has made already is copied, all else is compiled. The test asks whether this tree
# can be contained, and the answer does not need the core compiled twice.
# Usage: BATTEN_BUILD=FOLDER known_objects.sh COMPILER ARGUMENTS...
set -eu
previous='' output='' dependencies=''
for argument; do
    case $previous in
        -o) output=$argument ;;
        -MF) dependencies=$argument ;;
    esac
    previous=$argument
done
known=$BATTEN_BUILD/${output#batten/}
if [ "$output" != "${output#batten/}" ] && [ -f "$known" ]; then
    cp "$known" "$output"
    : > "$dependencies"
else
    exec "$@"
fi
