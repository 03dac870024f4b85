#!/bin/bash
# Tries this repository on a bare Debian 12: what a stranger sees. It makes one
# with debootstrap, clones the last commit to a path with a space in it, and
# runs `make` there in a chroot. Needs root and the package debootstrap.
# CALL: tools/try-clean.sh [--again] [--user] [--keep] TARGET...
#   --again   go on in the machine of the last try, with what it has installed
#   --user    run make as an ordinary user with sudo, not as root
#   --keep    do not renew the clone either (only with --again)
# Example: tools/try-clean.sh run && tools/try-clean.sh --again test
# The machines are kept in ${TMPDIR:-/tmp}/decalioc-bookworm: base (bare), try.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
place=${TMPDIR:-/tmp}/decalioc-bookworm
base=$place/base
try=$place/try

again='' user=root keep=''
while [[ ${1:-} == --* ]]; do
  case $1 in
    --again) again=yes ;;
    --user)  user=guest ;;
    --keep)  keep=yes ;;
    *)       echo "try-clean.sh: unknown option $1" >&2; exit 1 ;;
  esac
  shift
done
[ "$(id -u)" -eq 0 ] || { echo "try-clean.sh: chroot needs root." >&2; exit 1; }
command -v debootstrap > /dev/null || {
  echo "try-clean.sh: please run 'apt-get install debootstrap' first." >&2
  exit 1
}

# Mirrors, proxies and certificates are those of this machine.
copyNetworkSettings () {
  local item
  rm -f "${1:?}/etc/apt/sources.list"       # debootstrap's own
  for item in /etc/apt/{sources.list,sources.list.d,apt.conf,apt.conf.d,keyrings,auth.conf.d} \
              /etc/apt/trusted.gpg{,.d} /usr/share/keyrings /etc/pip.conf /etc/resolv.conf \
              /etc/hosts /usr/local/share/ca-certificates /etc/ssl/certs; do
    [ -e "$item" ] || continue
    rm -rf "${1:?}$item"
    mkdir -p "$1${item%/*}"
    cp -aL "$item" "$1$item"
  done
}

makeBase () {
  local mirror
  # shellcheck disable=SC2016  # apt's placeholders, not the shell's
  mirror=$(apt-get indextargets --format '$(RELEASE) $(REPO_URI)' |
    awk '$1 == "bookworm" || $1 == "stable" {print $2; exit}')
  rm -rf "$base"
  mkdir -p "$place"
  echo "Making a bare Debian 12 in $base"
  # git and make are the two things that the README asks for
  debootstrap --variant=minbase --include=git,make,ca-certificates bookworm "$base.new" \
    ${mirror:+"$mirror"} > "$place/debootstrap.log" 2>&1 || {
    tail -n 5 "$place/debootstrap.log" >&2
    echo "try-clean.sh: debootstrap failed, see $place/debootstrap.log" >&2
    exit 1
  }
  copyNetworkSettings "$base.new"
  mv "$base.new" "$base"
}

# As a shell in the new machine; all mounts and processes end with it.
inside () {
  local variables
  # the network settings that stand in the environment
  mapfile -t variables < <(env | grep -iE '^([a-z]+_proxy|[a-z_]*ca_?(bundle|info|cert)[a-z_]*|SSL_CERT_[A-Z]+|PIP_[A-Z_]+)=' || true)
  # shellcheck disable=SC2016  # for the inner shells
  unshare --mount --pid --fork --kill-child bash -eu -c '
    try=$1; shift
    mount -t proc proc "$try/proc"
    mount --rbind /dev "$try/dev"
    mount -t sysfs -o ro sysfs "$try/sys"
    mount -t tmpfs tmpfs "$try/tmp"
    exec chroot "$try" "$@"' bash "$try" \
    env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
    TERM=dumb "${variables[@]}" "$@" < /dev/null
}

[ -d "$base" ] || makeBase
if [ -z "$again" ]; then
  rm -rf "$try"
  cp -a "$base" "$try"
fi
if [ "$user" = guest ] && ! [ -e "$try/home/guest" ]; then
  inside bash -c 'apt-get update && apt-get install --yes --no-install-recommends sudo' > /dev/null
  inside useradd --create-home --shell /bin/bash guest
  echo 'guest ALL=(ALL) NOPASSWD: ALL' > "$try/etc/sudoers.d/guest"
fi
home=/root
[ "$user" = root ] || home=/home/$user
clone="$home/my clone"
if [ -z "$keep" ] || [ ! -d "$try$clone" ]; then
  rm -rf "${try:?}$clone"
  git clone --quiet "$root" "$try$clone"
  [ "$user" = root ] || chown -R --reference="$try$home" "$try$clone"
fi

status=0
time inside setpriv --reuid="$(stat -c %u "$try$home")" --regid="$(stat -c %g "$try$home")" \
  --init-groups env HOME="$home" USER="$user" make -C "$clone" "$@" || status=$?
echo "try-clean.sh: make $* has ended with status $status"
exit $status
