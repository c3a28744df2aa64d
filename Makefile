# A thin front: each target sets up whatever it lacks (packages, BLAS, configure, build) and then does its one thing.
# CMakeLists.txt is the real build; `cmake -B build && cmake --build build` works without this file.
.PHONY: help run build test verify bench format tidy clean setup setup-tests
.DEFAULT_GOAL := help

CXX_FILES = $(shell find lib tools tests -name '*.cpp' -o -name '*.hpp')

help:
	@echo 'make run     mesh-gen | solve | postprocess on DESIGN (designs/bellows.yaml); curve, plot and result in results/'
	@echo 'make test    build and run the tests; LABEL=unit, verification, pipeline or slow runs only those'
	@echo 'make verify  the verification table: to the terminal, results/verification.csv and tests/verification/README.md'
	@echo 'make build   everything, into build/ (binaries in build/bin)'
	@echo 'make bench   timings of the standard cases: to the terminal and results/benchmarks; BENCH="rod solid" or all for others'
	@echo 'make format  clang-format over lib, tools and tests'
	@echo 'make tidy    clang-tidy over lib and tools'
	@echo 'make clean   remove build/ and results/'

setup:
	@scripts/setup

setup-tests:
	@scripts/setup --tests

run: setup
	@scripts/build mesh-gen solve postprocess
	@scripts/run-example $(DESIGN)

build: setup
	@scripts/build

test: setup-tests
	@scripts/build
	@scripts/test $(LABEL)

verify: setup
	@scripts/build verify
	@scripts/verify

bench: build
	@scripts/benchmark $(BENCH)

# Debian gives each release of clang's tools a name of its own; other releases find and want other things.
format:
	@command -v clang-format-14 >/dev/null || { echo 'format: needs clang-format-14 (apt-get install clang-format-14)' >&2; exit 1; }
	@clang-format-14 -i $(CXX_FILES)

tidy: setup
	@scripts/tidy

clean:
	@rm -rf build build-asan results
