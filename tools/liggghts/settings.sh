# SPDX-License-Identifier: GPL-3.0-only
# shellcheck shell=bash disable=SC2034
# What is built and where it goes; read by build.sh and path.sh.

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
# without HOME (cron, systemd) the home of the user, as the system knows it
cache=${XDG_CACHE_HOME:-${HOME:-$(unset HOME; echo ~)}/.cache}/decalioc

tarball=liggghts_3.8.0+repack1.orig.tar.xz
tarballSha=c18721d9a870c5170f03b91e4f1ffe13335c66ed1f0ff2c64ebd3be91c37867a

# No -ffast-math: a run that blew up must show its NaN. Fused multiply-add off:
# it gains nothing here (measured), and without it the digits of a result depend
# less on the processor.
flags=${LIGGGHTS_CXXFLAGS:--O3 -march=native -ffp-contract=off}

# What is built: the files that change the program.
sources () {
  cat "$here"/{gcc12.patch,contact_models.whitelist,build.mk,precompiled.h} \
      "$here/cohesion_model_dmt.h"
}

# The same before the law DMT was added, which moved no digit of a run (measured):
# runs of that program count as runs of this one, see "identity" in build.sh. A
# later change that moves no digit either adds a list here; one that does clears it.
formerSources () {
  cat "$here/gcc12.patch"
  grep -v COHESION_DMT "$here/contact_models.whitelist"
  cat "$here"/{build.mk,precompiled.h}
}

# Prints the folder that a build of these sources has, or would get: buildFolder
# sources, or formerSources.
# The name changes with all that changes the program, also with the processor:
# -march=native on another one would end in "illegal instruction".
buildFolder () {
  local target key
  # shellcheck disable=SC2086  # the flags are several words
  # as wide as without a terminal: the lines wrap at its width
  target=$(COLUMNS=80 g++ $flags -Q --help=target 2>/dev/null) || return 1
  key=$( { echo "$tarballSha $flags $target"
           g++ -dumpfullversion
           "$1"
         } | sha256sum | cut -c 1-12)
  echo "$cache/liggghts-$key"
}
