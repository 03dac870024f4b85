#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# install.sh PREFIX [remove]: puts the command, its completion in bash, zsh and
# fish, and its man page below PREFIX, or removes them again. The command is a
# link: the toolbox itself stays where it is.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
fail () { echo "install.sh: $*" >&2; exit 1; }

[[ ${1:-} == /* ]] || fail "PREFIX must be a folder's whole path, got '${1:-}'. For example: make install PREFIX=\$HOME/.local"
link=$1/bin/decalioc
files=("$1/share/bash-completion/completions/decalioc"
       "$1/share/zsh/site-functions/_decalioc"
       "$1/share/fish/vendor_completions.d/decalioc.fish"
       "$1/share/man/man1/decalioc.1")
makers=("cat $(printf %q "$root")/share/bash-completion/completions/decalioc"
        "$(printf %q "$root")/tools/shellTexts.sh zsh"
        "$(printf %q "$root")/tools/shellTexts.sh fish"
        "$(printf %q "$root")/tools/shellTexts.sh man")

# only a link to such a command is replaced or removed
if [ -e "$link" ] || [ -L "$link" ]; then
  [[ $(readlink -- "$link") == */bin/decalioc ]] ||
    fail "$link is there, and not made by this. Move it, or take another PREFIX."
fi

if [ "${2:-}" = remove ]; then
  rm -f -- "$link" "${files[@]}"
  echo "removed from $1: the command, its completion and its man page"
  exit
fi
for k in "${!files[@]}"; do
  mkdir -p -- "$(dirname -- "${files[k]}")"
  # not through a link that is there
  rm -f -- "${files[k]}"
  eval "${makers[k]}" > "${files[k]}"
done
mkdir -p -- "$1/bin"
ln -sfn -- "$root/bin/decalioc" "$link"
echo "installed below $1: bin/decalioc, its completion and its man page"
case :$PATH: in
  *:"$1/bin":*) ;;
  *) echo "The PATH has no $1/bin. In ~/.bashrc: export PATH=\"$1/bin:\$PATH\"" ;;
esac
