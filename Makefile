# DEcalioc: all set-up, and the commands of the README. `make help` lists them.
#
# LIGGGHTS  which LIGGGHTS: nothing = build one, once (see tools/liggghts),
#           'system' = the one on the PATH, or the path of a program
# OCTAVE    which Octave (default: octave-cli)
# CASE      which calibration: a folder with a loadInput.m (default: this folder)
# PREFIX    where make install puts the command (default: ~/.local)
# ONLY      which tests: those whose file's path holds this text (default: all)

SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.NOTPARALLEL:          # apt, the build and the runs use all cores on their own

LIGGGHTS ?=
OCTAVE ?= octave-cli
CASE ?= .
ONLY ?=
PREFIX ?= $(HOME)/.local
export LIGGGHTS OCTAVE CASE ONLY PREFIX

.PHONY: help setup install uninstall liggghts run gap test soak bench figures lint graph doors map wings format index dist release site demo clean liggghts-clean

help:                  ## this list
	@echo 'make TARGET, with the targets'
	@sed -nE 's/^([a-z-]+):[^#]*## (.*)/  \1\t\2/p' Makefile | expand -t 18
	@echo 'Variables: LIGGGHTS=/path/to/liggghts or LIGGGHTS=system, OCTAVE=program,'
	@echo '  CASE=folder (for run and gap), PREFIX=folder (for install), ONLY=text (for test: files whose path holds it)'

setup:                 ## install all Debian packages, also those for test and lint
	@tools/setup.sh run build test lint

install:               ## put command, completion and man page below PREFIX (~/.local)
	@tools/install.sh "$$PREFIX"

uninstall:             ## remove what make install has put there
	@tools/install.sh "$$PREFIX" remove

liggghts:              ## build LIGGGHTS, once per machine
	@tools/liggghts/build.sh

run:                   ## calibrate: all set-up, then DEcalioc.m
	@tools/setup.sh run
	@tools/liggghts/build.sh
	@tools/octave.sh DEcalioc.m

gap:                   ## diagnose the gap: all set-up, then diagnoseGap.m
	@tools/setup.sh run
	@tools/liggghts/build.sh
	@tools/octave.sh diagnoseGap.m

demo:                  ## calibrate and diagnose stored runs in ./decalioc-demo, without LIGGGHTS (CHANGE=1: before and after)
	@tools/setup.sh run
	@tools/demo.sh decalioc-demo$(if $(CHANGE),-change) $(CHANGE)

test:                  ## all set-up, then the tests; ends in "N passed, N failed"
	@tools/setup.sh run test
	@tools/liggghts/build.sh
	@CASE=. tools/octave.sh tests/runTests.m $${ONLY:+"$$ONLY"}

soak:                  ## all tests, in their long form: 1.5 hours on 2 cores
	@DECALIOC_SOAK=1 $(MAKE) --no-print-directory test

bench:                 ## list the programs that measure
	@tools/bench.sh

figures:               ## write the tables of the manual from benchmarks/results; nothing is run again
	@$(OCTAVE) --no-gui --norc --quiet benchmarks/figures.m 2>&1 | \
	  { grep -v 'ignoring const execution_exception' || true; }

lint:                  ## check the style of the Octave and the shell code
	@tools/setup.sh lint
	@tools/lint.sh

graph:                 ## the calls between the folders; fails where one goes up, or nothing calls a function
	@OCTAVE=$${OCTAVE:-octave-cli} tools/graph/graph.sh

doors:                 ## the doors of each room (what others call), and what hangs on seven of them
	@OCTAVE=$${OCTAVE:-octave-cli} tools/graph/graph.sh --doors

map:                   ## make infrastructure/README.md: the doors of each folder
	@OCTAVE=$${OCTAVE:-octave-cli} tools/graph/graph.sh --map

wings:                 ## take each wing off a copy and run the core's tests there: 6 minutes
	@tools/setup.sh run test
	@tools/wings.sh

format:                ## lay out the Octave code, then lint
	@tools/setup.sh lint
	@tools/lint.sh --fix

index:                 ## write docs/functions.md (functions that a user may call) and the fields of docs/inputs.md
	@tools/functionIndex.sh

dist:                  ## make the Octave package dist/decalioc-VERSION.tar.gz
	@tools/dist.sh

release:               ## NUMBER=1.0.0: version, changelog, package, site; what is left to type it says
	@tools/release.sh "$(NUMBER)"

site:                  ## build the manual: dist/site and dist/decalioc-manual.pdf
	@tools/setup.sh site
	@tools/site/build.sh

clean:                 ## remove what tests and crashes leave, never a result
	@rm -f fntests.log tests/fntests.log octave-workspace log.liggghts

liggghts-clean:        ## remove the LIGGGHTS that was built, and its source
	@tools/liggghts/remove.sh
