# Front end of the CMake build: each target first installs and builds what it needs (packages, BLAS, configure, build).
# `cmake -B build && cmake --build build` works without this file.
.PHONY: help run build test test-all verify install package docs bench format tidy clean setup setup-tests
.DEFAULT_GOAL := help

PREFIX = /usr/local
CXX_FILES = $(shell find lib tools tests -name '*.cpp' -o -name '*.hpp')

help:
	@echo 'make run     run mesh-gen | solve | postprocess on DESIGN (default designs/bellows.yaml); output in results/'
	@echo 'make test    build and run the tests of a few minutes; LABEL=unit, verification, pipeline or extended selects tests'
	@echo 'make test-all  all tests that CI runs'
	@echo 'make verify  compute the verification table: terminal, results/verification.csv, tests/verification/README.md'
	@echo 'make build   build everything in build/ (binaries in build/bin)'
	@echo 'make install  copy programs, designs, headers and libraries to PREFIX (default /usr/local)'
	@echo 'make package  build .deb and .tar.gz in build/packages'
	@echo 'make docs    build the website of docs/ in build/site'
	@echo 'make bench   time the standard cases: terminal and results/benchmarks; BENCH="rod solid" or BENCH=all selects groups'
	@echo 'make format  run clang-format on lib, tools and tests'
	@echo 'make tidy    run clang-tidy on lib and tools'
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

test-all: setup-tests
	@scripts/build
	@scripts/test all

verify: setup
	@scripts/build verify
	@scripts/verify

install: setup
	@scripts/build programs
	@cmake --install build --prefix $(PREFIX)

package:
	@scripts/setup --package
	@scripts/build programs
	@cd build && cpack

docs:
	@scripts/setup --docs
	@scripts/docs-site

bench: build
	@scripts/benchmark $(BENCH)

# The release is fixed, because other releases of clang-format give other results.
format:
	@command -v clang-format-14 >/dev/null || { echo 'format: clang-format-14 is not installed; run apt-get install clang-format-14' >&2; exit 1; }
	@clang-format-14 -i $(CXX_FILES)

tidy: setup
	@scripts/tidy

clean:
	@rm -rf build build-clang results
