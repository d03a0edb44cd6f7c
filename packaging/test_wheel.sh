#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Python package by pip, without a network, and runs its tests with what was installed:
#   packaging/test_wheel.sh BUILD OUT
# BUILD is the folder that CMake builds in, OUT where it is installed: in a virtual environment, and in a plain folder.
set -euo pipefail
build=$(realpath -m "$1")
out=$(realpath -m "$2")
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
python=/usr/bin/python3  # the system's: Debian's setuptools, wheel and numpy are its
export ROOMATLAS_BUILD=$build ROOMATLAS_WORLDS=$here/data/worlds

say() { printf '==> %s\n' "$*" >&2; }
# test_with PYTHON FOLDER: the package is the one below FOLDER, and passes its tests.
test_with() {
  (cd "$out" && "$1" -c 'import pathlib, roomatlas, sys
home = pathlib.Path(roomatlas.__file__).resolve()
sys.exit(None if pathlib.Path(sys.argv[1]).resolve() in home.parents else f"imported from {home}")' "$2" &&
    "$1" -m pytest -q -p no:cacheprovider "$here/python/tests")
}

rm -rf "$out"
mkdir -p "$out"
say "in a virtual environment"
"$python" -m venv --system-site-packages "$out/venv"
"$out/venv/bin/pip" install -q --no-build-isolation --no-index "$here"
test_with "$out/venv/bin/python" "$out/venv"
say "in a folder"
"$python" -m pip install -q --no-build-isolation --no-index --no-deps --target "$out/target" "$here"
PYTHONPATH=$out/target test_with "$python" "$out/target"
