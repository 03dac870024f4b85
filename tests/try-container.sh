#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Builds the image of Containerfile with podman and runs `decalioc doctor` in it.
# Control groups are not needed. Needs podman, buildah, and root or a user with
# sub-ids. Not part of `make test`: it takes ten minutes and 4 GB.
# CALL: tests/try-container.sh [BASE]
#   BASE  the image to begin with (that of Containerfile). Where no registry can be reached,
#         make one: debootstrap bookworm DIR && tar -C DIR -c . | podman import - NAME
# STORAGE_DRIVER=vfs where overlay file systems are not allowed.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
base=(${1:+--build-arg "BASE=$1"})

driver=(${STORAGE_DRIVER:+--storage-driver "$STORAGE_DRIVER"})
inImage () { buildah "${driver[@]}" "$@"; }

podman "${driver[@]}" build --isolation chroot "${base[@]}" --tag decalioc "$root"
container=$(inImage from --pull-never localhost/decalioc)
place=$(mktemp -d)
chmod 1777 "$place"                # the user of the image is not the one here
trap 'inImage rm "$container" > /dev/null; rm -rf "$place"' EXIT
inImage run --isolation chroot --volume "$place:/case" "$container" -- \
  bash -c '[ "$(id -u)" -ne 0 ] && ! [ -w /opt/decalioc/bin ] && decalioc doctor'
