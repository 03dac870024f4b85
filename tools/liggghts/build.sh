#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Builds LIGGGHTS 3.8.0 from Debian's source package, once per machine.
# CALL: tools/liggghts/build.sh      (or: make liggghts)
# LIGGGHTS=/path/to/liggghts or LIGGGHTS=system chooses another program: then
# nothing is built. LIGGGHTS_CXXFLAGS replaces the compiler flags, for instance
# '-O3 -march=x86-64-v3' where the runs go to other processors than this one.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=settings.sh
. "$(dirname "${BASH_SOURCE[0]}")/settings.sh"

say () { echo "LIGGGHTS: $*"; }

# Gets the source package's tarball into the cache, checked. The machine's own
# apt set-up stays as it is: its `deb` entries are copied as `deb-src` entries.
fetchSource () {
  local apt=$work/apt file
  isSource "$cache/$tarball" && return
  say "downloading the source package of Debian"
  mkdir -p "$apt"/{sources,lists/partial,cache}
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ -f "$file" ] && sed -nE 's/^\s*deb(\s)/deb-src\1/p' "$file"
  done > "$apt/sources/source.list" || true
  for file in /etc/apt/sources.list.d/*.sources; do
    [ -f "$file" ] && sed -E 's/^Types:.*/Types: deb-src/I' "$file" > "$apt/sources/${file##*/}"
  done || true
  local options=(-o "Dir::Etc::sourcelist=/dev/null" -o "Dir::Etc::sourceparts=$apt/sources"
                 -o "Dir::State::lists=$apt/lists" -o "Dir::Cache=$apt/cache"
                 -o "APT::Sandbox::User=$(id -un)")
  # Only the tarball counts. Both commands may fail for other reasons: a source
  # of the user's without source packages, Debian's patch archive not there.
  ( cd "$apt"
    apt-get "${options[@]}" update
    apt-get "${options[@]}" source --download-only liggghts ) >> "$log" 2>&1 || true
  advice="Is there a network, and does /etc/apt name a Debian mirror? Or put
  $tarball into $cache by hand."
  isSource "$apt/$tarball"
  mv "$apt/$tarball" "$cache/$tarball"
}

isSource () {
  [ -f "$1" ] && sha256sum --status --check <<< "$tarballSha  $1"
}

# Debian's patches are not to be had; g++ 12 needs only these few.
unpackAndMend () {
  mkdir "$work/source"
  tar -xf "$cache/$tarball" -C "$work/source" --strip-components=1
  cd "$work/source"
  patch -p1 < "$here/gcc12.patch"
  rm src/dump_mesh_vtk.{cpp,h}      # includes VTK also where VTK is not wanted
  cp "$here"/{build.mk,precompiled.h,cohesion_model_dmt.h} src/
  cp "$here/contact_models.whitelist" src/style_contact_model.whitelist
  cd src
  LC_ALL=C sh Make.sh style
  LC_ALL=C sh Make.sh models
}

compile () {
  local number
  number=$(make -s -f build.mk count)
  say "compiling $number files with $(nproc) processes: 2 to 3 minutes on 2 cores, only this once"
  make -f build.mk -j "$(nproc)" "FLAGS=$flags" liggghts 2>&1 | tee -a "$log" | sayQuarters "$number"
}

# In bash, as Debian's awk would keep lines back until it has 4,096 bytes of them.
sayQuarters () {
  local line files=0 quarter=1
  while read -r line; do
    if [[ $line == CXX* ]]; then files=$((files + 1)); fi
    if [ $((4 * files)) -ge $(($1 * quarter)) ] && [ $quarter -lt 4 ]; then
      say "$((25 * quarter))% compiled"
      quarter=$((quarter + 1))
    fi
  done
}

# The finished folder appears in one step: what is there is complete.
installProgram () {
  mkdir -p "$work/done/bin"
  strip -o "$work/done/bin/liggghts" liggghts
  # an empty input is a valid one, so this only starts the program and ends it
  "$work/done/bin/liggghts" -log none < /dev/null > "$work/start" 2>&1 ||
    cat "$work/start" >> "$log"
  grep -q LIGGGHTS "$work/start"
  { echo "source: $tarball, sha256 $tarballSha"
    echo "flags: $flags"
    echo "compiler: $(g++ --version | head -n 1)"
    echo "contact models compiled for speed:"
    cat "$here/contact_models.whitelist"; } > "$work/done/about.txt"
  takeIdentity
  mv -T "$work/done" "$folder"
}

# Where the program of the former sources is here, its runs are runs of this one:
# keys of runs (hashModels) take what "identity" holds for the build.
takeIdentity () {
  local former
  former=$(buildFolder formerSources)
  [ -x "$former/bin/liggghts" ] || return 0
  if [ -f "$former/identity" ]; then cat "$former/identity"
  else sha256sum < "$former/bin/liggghts" | cut -c 1-64; fi > "$work/done/identity"
}

# Runs at the end of the script, also of an interrupted one.
finish () {
  local status=$?
  rm -rf "$work"
  [ $status -eq 0 ] && return
  { tail -n 20 "$log"
    echo "build.sh: LIGGGHTS is not built: failed while $step. The whole log is in"
    echo "  $log"
    echo "  $advice"
    echo "  Or choose a liggghts that you have: make ... LIGGGHTS=/path/to/liggghts"; } >&2
}

if [ -n "${LIGGGHTS:-}" ]; then
  exec "$here/path.sh" > /dev/null   # which complains when it is not there
fi
if "$here/path.sh" > /dev/null 2>&1; then exit; fi

"$here/../setup.sh" build
folder=$(buildFolder sources) || {
  echo "build.sh: g++ does not accept the flags '$flags'." >&2
  exit 1
}
mkdir -p "$cache"

# One build at a time: a second one waits, and then finds the work done.
exec 9> "$cache/build.lock"
flock -n 9 || { say "another build is running, waiting for it"; flock 9; }
[ -x "$folder/bin/liggghts" ] && exit
rm -rf "$cache"/build.tmp.*          # left over from a build that was killed
work=$(mktemp -d "$cache/build.tmp.XXXXXX")
log=$folder.log
: > "$log"
advice="The lines above may tell why."
trap finish EXIT
unset MAKEFLAGS MFLAGS MAKELEVEL     # of the make that has called this script

step="getting the source";       fetchSource
step="unpacking and patching";   unpackAndMend >> "$log" 2>&1
step="compiling";                compile
step="starting the new program"; installProgram
say "installed in $folder"
