#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Installs the packages of Debian or Ubuntu that a task needs; silent when all are
# there.
# CALL: tools/setup.sh TASK...       (run, build, test, lint, site)
set -euo pipefail

# Ubuntu has no package of it, only a snap: there, tests in a browser are skipped.
browser=chromium
grep -qs '^ID=ubuntu$' /etc/os-release && browser=

packagesOf () {
  case $1 in
    run)   echo octave octave-stk octave-optim octave-parallel octave-struct \
                openmpi-bin procps ;;
    build) echo g++ make patch xz-utils libopenmpi-dev libjpeg-dev libpng-dev ;;
    test)  echo slurm-wlm munge gridengine-master gridengine-exec \
                gridengine-client gnuplot-nox python3-venv $browser ;;    # small clusters
    lint)  echo octave python3-venv shellcheck codespell ;;
    site)  echo python3-venv $browser ;;
    *)     echo "setup.sh: unknown task '$1' (run, build, test, lint, site)" >&2; exit 1 ;;
  esac
}

missingOf () {
  local package status
  for package in "$@"; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) || true
    [ "$status" = installed ] || echo "$package"
  done
}

# Packages of queues would start their services. The tests start their
# own, so keep these from starting, unless the machine has its own rule.
withoutServices () {
  if [ ! -e /usr/sbin/policy-rc.d ]; then
    trap 'rm -f /usr/sbin/policy-rc.d' EXIT
    printf '#!/bin/sh\nexit 101\n' > /usr/sbin/policy-rc.d
    chmod +x /usr/sbin/policy-rc.d
  fi
  "$@"
}

install () {
  DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600 \
    install --yes --no-install-recommends "$@"
}

if [ "${1:-}" = --as-root ]; then      # second half, see below
  shift
  # the package lists may be missing or old: then fetch them and try again
  withoutServices install "$@" || { apt-get update && withoutServices install "$@"; }
  exit
fi

packages=()
for task in "$@"; do
  # shellcheck disable=SC2207  # package names hold no spaces
  packages+=($(packagesOf "$task"))
done
if ! command -v dpkg-query > /dev/null; then
  command -v octave-cli > /dev/null ||
    echo "setup.sh: this is neither Debian nor Ubuntu, nothing is installed. Needed are: ${packages[*]}" >&2
  exit
fi
mapfile -t missing < <(missingOf "${packages[@]}")
[ ${#missing[@]} -eq 0 ] && exit

root=()
if [ "$(id -u)" -ne 0 ]; then
  root=(sudo --)
  command -v sudo > /dev/null || {
    echo "setup.sh: packages are missing, and there is no sudo to install them. As root run:" >&2
    echo "  apt-get update && apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  }
fi
echo "Set-up: installing ${missing[*]}"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
"${root[@]}" bash "${BASH_SOURCE[0]}" --as-root "${missing[@]}" > "$log" 2>&1 || {
  tail -n 15 "$log" >&2
  echo "setup.sh: apt-get could not install ${missing[*]}, see above." >&2
  exit 1
}
