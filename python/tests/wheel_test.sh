#!/usr/bin/env bash
# wheel_test.sh SOURCE PYTHON PROGRAM [PACKAGE]: installs a wheel into an empty virtual environment and uses
# it there. With PACKAGE, the wheel has the package that is already built. Without PACKAGE, makes an sdist
# with `build`, unpacks it elsewhere, and compiles the wheel from it. This takes minutes, so it is skipped
# unless FELT_PYTHON_SDIST=1 (./dev test -L python).
set -euo pipefail
source_dir=$1 python=$2 program=$3 package=${4:-}
skip() { echo "$*"; exit 77; }
if [ -z "$package" ] && [ "${FELT_PYTHON_SDIST:-}" != 1 ]; then
  skip "compiling from an sdist takes minutes: ./dev test -L python"
fi
"$python" -c 'import build, numpy, venv, ensurepip' || skip "packages are missing: ./dev setup python"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# quietly COMMAND...: prints the output of the command only if it fails.
quietly() { "$@" >"$work/log" 2>&1 || { echo "FAILED: $*"; tail -n 60 "$work/log"; exit 1; }; }
export PYTHONDONTWRITEBYTECODE=1 PIP_NO_INDEX=1 PIP_DISABLE_PIP_VERSION_CHECK=1
unset PYTHONPATH
cd "$work"

if [ -n "$package" ]; then
  quietly "$python" -m build --wheel --no-isolation -C "package=$package" -o "$work/dist" "$source_dir"
  sources=$source_dir
else
  echo "sdist:"
  quietly "$python" -m build --sdist --no-isolation -o "$work/dist" "$source_dir"
  quietly "$python" -m build --sdist --no-isolation -o "$work/again" "$source_dir"
  cmp "$work"/dist/*.tar.gz "$work"/again/*.tar.gz
  mkdir unpacked
  tar -xf "$work"/dist/*.tar.gz -C unpacked
  sources=$(echo "$work"/unpacked/*)
  echo "wheel from the unpacked sdist:"
  quietly "$python" -m build --wheel --no-isolation -o "$work/dist" "$sources"
fi
ls -l dist

"$python" -m venv --system-site-packages venv
quietly venv/bin/pip install --no-deps dist/*.whl
# Only what concerns our package: others of the system may miss what they need.
if venv/bin/pip check | grep '^feltline '; then exit 1; fi
venv/bin/python - <<'END'
import feltline, importlib.metadata, pathlib
assert "venv" in feltline.__file__, feltline.__file__
assert importlib.metadata.version("feltline") == feltline.__version__
assert importlib.metadata.requires("feltline")[0] == "numpy"
assert (pathlib.Path(feltline.__file__).parent / "py.typed").exists()
END
echo "tests with the installed package:"
for test in fit files recordings texts; do
  (cd "$sources/python/tests" && FELTLINE=$program "$work/venv/bin/python" -m unittest "test_$test")
done
quietly venv/bin/pip uninstall -y feltline
if venv/bin/python -c 'import feltline' 2>/dev/null; then exit 1; fi
echo "libraries of the system that the module needs:"
unzip -q dist/*.whl 'feltline/_feltline*' -d module 2>/dev/null ||
  "$python" -m zipfile -e dist/*.whl module
objdump -p module/feltline/_feltline*.so | sed -n 's/ *NEEDED */  /p'
