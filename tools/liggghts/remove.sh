#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-only
# Removes every LIGGGHTS that build.sh has made, with its source and logs.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=settings.sh
. "$(dirname "${BASH_SOURCE[0]}")/settings.sh"
cd "${cache:?}" 2>/dev/null || exit 0
rm -rf liggghts-*/ liggghts-*.log chosen-*/ "$tarball"
