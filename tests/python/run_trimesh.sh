#!/usr/bin/env bash
# run_trimesh.sh [PYTHON] - trimesh's own tests of rays, with rsh in place of its ray objects.
#   TRIMESH_TREE=<checkout of trimesh> tests/python/run_trimesh.sh build/python/pypi/bin/python
# PYTHON: of an environment with rsh; gets what trimesh's tests need. Default: that of tests/python.sh.
set -euo pipefail
: "${TRIMESH_TREE:?must name a checkout of trimesh}"
here=$(realpath "$(dirname "${BASH_SOURCE[0]}")")
python=$(realpath -s "${1:-$here/../../build/python/pypi/bin/python}")
"$python" -m pip install -q pytest embreex scipy rtree jsonschema networkx lxml pyinstrument manifold3d shapely
cd "$TRIMESH_TREE"
PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$here:$PWD "$python" -m pytest -q -p rsh_as_ray -p no:cacheprovider \
    tests/test_ray.py tests/test_ray_upstream.py
