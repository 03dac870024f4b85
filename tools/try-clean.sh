#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Tries this repository on a bare Debian or Ubuntu: what a stranger sees. It makes
# one with debootstrap, clones the last commit to a path with a space in it, and
# runs `make` there in a chroot. Needs root and the package debootstrap.
# CALL: tools/try-clean.sh [--again] [--user] [--keep] SUITE TARGET...
#   --again   go on in the machine of the last try, with what it has installed
#   --user    run make as an ordinary user with sudo, not as root
#   --keep    do not renew the clone either (only with --again)
#   SUITE     bookworm (Debian 12), trixie (Debian 13), jammy (Ubuntu 22.04) or
#             noble (Ubuntu 24.04)
# Example: tools/try-clean.sh trixie run &&
#          tools/try-clean.sh --again trixie test ONLY=infrastructure/runs
# Packages of Debian come from the mirrors of this machine, those of Ubuntu from
# ${UBUNTU_MIRROR:-http://archive.ubuntu.com/ubuntu}. The machines are kept in
# ${TMPDIR:-/tmp}/decalioc-SUITE: base (bare), try.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

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
case ${1:-} in
  bookworm | trixie) suite=$1 of=debian parts=main ;;
  jammy | noble)     suite=$1 of=ubuntu parts=main,universe ;;
  *) echo "try-clean.sh: name the suite, bookworm, trixie, jammy or noble, before the targets." >&2
     exit 1 ;;
esac
shift
place=${TMPDIR:-/tmp}/decalioc-$suite
base=$place/base
try=$place/try
[ "$(id -u)" -eq 0 ] || { echo "try-clean.sh: chroot needs root." >&2; exit 1; }
command -v debootstrap > /dev/null || {
  echo "try-clean.sh: please run 'apt-get install debootstrap' first." >&2
  exit 1
}

# Proxies and certificates are those of this machine.
copyNetworkSettings () {
  local item
  sources > "${1:?}/etc/apt/sources.list"
  for item in /etc/apt/{apt.conf,apt.conf.d,auth.conf.d} /etc/pip.conf /etc/resolv.conf \
              /etc/hosts /usr/local/share/ca-certificates /etc/ssl/certs; do
    [ -e "$item" ] || continue
    rm -rf "${1:?}$item"
    mkdir -p "$1${item%/*}"
    cp -aL "$item" "$1$item"
  done
}

# A line for the suite itself, its updates, its security updates. Of Debian: this
# machine's sources, for the suite that is tried.
sources () {
  local codename
  if [ $of = ubuntu ]; then
    printf "deb ${UBUNTU_MIRROR:-http://archive.ubuntu.com/ubuntu} %s main universe\n" \
      "$suite" "$suite-updates" "$suite-security"
    return
  fi
  # shellcheck source=/dev/null
  codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-stable}")
  # shellcheck disable=SC2016  # apt's placeholders, not the shell's
  apt-get indextargets --format '$(RELEASE) $(REPO_URI)' | sort -u |
    awk -v own="^($codename|stable)(-updates|-security)?\$" -v suite="$suite" \
      '$1 ~ own {sub(/^[a-z]*/, suite, $1); print "deb", $2, $1, "main"}'
}

# The keys of Ubuntu where this machine has none: those that Debian 13 has as a
# package, by its checksum.
ubuntuKeys () {
  keys=/usr/share/keyrings/ubuntu-archive-keyring.gpg
  [ ! -e $keys ] || return 0
  [ -e "$place$keys" ] || {
    /usr/lib/apt/apt-helper download-file \
      http://deb.debian.org/debian/pool/main/u/ubuntu-keyring/ubuntu-keyring_2023.11.28.1-0.2_all.deb \
      "$place/keys.deb" SHA256:b2e7ed48431bf9e7978ae810bbdaf253093570d6e3f864e575b7c13554b81174
    dpkg-deb --extract "$place/keys.deb" "$place"
  }
  keys=$place$keys
}

makeBase () {
  local mirror script='' keys='' usual=/usr/share/debootstrap/scripts
  mkdir -p "$place"
  if [ $of = ubuntu ]; then
    ubuntuKeys
    # an older debootstrap does not know its name, but how Ubuntus are made
    [ -e "$usual/$suite" ] || script=$usual/gutsy
  fi
  mirror=$(sources | awk -v suite="$suite" '$3 == suite {print $2; exit}')
  rm -rf "$base"
  echo "Making a bare system ($suite) in $base"
  # git and make are the two things that the README asks for
  debootstrap --variant=minbase --include=git,make,ca-certificates --components=$parts \
    ${keys:+--keyring="$keys"} "$suite" "$base.new" ${mirror:+"$mirror"} ${script:+"$script"} \
    > "$place/debootstrap.log" 2>&1 || {
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
