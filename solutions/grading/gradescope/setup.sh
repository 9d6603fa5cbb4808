#!/usr/bin/env bash
# Gradescope runs this once, as root, when it builds the image: it installs the tools, unpacks the
# kit, and lets it prove itself. See ../README.md; pack.py makes the zip that this stands in.
set -euo pipefail
base=${AUTOGRADER:-/autograder}
source=$base/source

packages=(bubblewrap catch2 cmake g++ libbenchmark-dev libboost-dev libeigen3-dev libisal-dev
  libstb-dev ninja-build python3 util-linux)
missing=()
for package in "${packages[@]}"; do
  dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null | grep -qx installed || missing+=("$package")
done
if ((${#missing[@]})); then
  export DEBIAN_FRONTEND=noninteractive
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends "${missing[@]}"
fi

# Students' code runs as another user, who must not look in here.
chmod 700 "$source"
mkdir -p -m 700 "$base/grader"
tar -xzf "$source/kit.tar.gz" -C "$base/grader"

# shellcheck disable=SC1091
. "$source/options.sh"
"$base/grader/tumble/tumble" grade --check --out "$base/grader/out" --secret "$source/secret" \
  "${options[@]}"
