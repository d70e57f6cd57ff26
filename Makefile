# The everyday commands; CMakePresets.json says what each build is. `make help` lists them.
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
JOBS ?= $(shell nproc)
# How many seconds `make fuzz` runs in all.
FUZZ_SECONDS ?= 60

configure = cmake --preset $(1) > build/$(1).log || { cat build/$(1).log; exit 1; }
compile = mkdir -p build && $(call configure,$(1)) && \
	cmake --build build/$(1) -j $(JOBS) --target $(or $(2),all)
run_tests = ctest --test-dir build/$(1) -j $(JOBS) --output-on-failure

.PHONY: help build demo tables papers python package bench test asan tsan clang fuzz wasm clean
help: ## list these commands
	@awk -F ':.*## ' '/^[a-z]+:.*## / {printf "make %-7s %s\n", $$1, $$2}' $(MAKEFILE_LIST)

build: ## build the library and the command, build/release/bin/batten
	@./setup.sh core test
	@$(call compile,release,product)

demo: build ## draw fair curves through real data, into build/demo
	@./setup.sh demo
	@tools/demo.sh

tables: ## build the tables of the pseudo-spline again, and check them on a million pairs
	@./setup.sh core
	@$(call compile,release,batten_tables)
	@build/release/tools/batten_tables src/make/pseudo/tables
	@$(call compile,release,batten_check_tables)
	@build/release/tools/batten_check_tables 1000000

papers: ## make the papers' figures and tables again, into papers/
	@./setup.sh core test
	@$(call compile,release,papers)
	@build/release/papers/papers_harada_nakamae papers/harada-nakamae
	@build/release/papers/papers_hatano_curves cases papers/hatano
	@build/release/papers/papers_hatano_surfaces cases papers/hatano
	@build/release/papers/papers_hatano_curved_lines cases papers/hatano
	@build/release/papers/papers_inoue_shibata papers/inoue-shibata
	@build/release/papers/papers_nakajima papers/nakajima
	@build/release/papers/papers_inoue_shibata_tables
	@build/release/papers/papers_miura_yoshida_saito papers/miura-yoshida-saito
	@build/release/papers/papers_miura_yoshida_saito_compared papers/miura-yoshida-saito

python: ## build the Python module and pack it as a wheel, into build/release/wheel
	@./setup.sh core test python
	@$(call compile,release,wheel)

package: ## pack library and command as .tar.gz and .deb, into build/release/package
	@./setup.sh core test package
	@$(call compile,release,product)
	@cmake --build build/release --target package

bench: ## measure speed beside the peers, into docs/benchmarks.md
	@./setup.sh core test bench
	@$(call compile,release,batten_speed surface_speed)
	@/usr/bin/python3 bench/speed/run.py build/release/bench/batten_speed .

test: ## run all tests
	@./setup.sh core test
	@$(call compile,release)
	@$(call run_tests,release)

asan: ## run all tests under the address and undefined-behaviour sanitizers
	@./setup.sh core test
	@$(call compile,asan)
	@$(call run_tests,asan)

tsan: ## run all tests under the thread sanitizer
	@./setup.sh core test
	@$(call compile,tsan)
	@$(call run_tests,tsan)

clang: ## build with clang++ and run the tests against known values
	@./setup.sh core test clang
	@$(call compile,clang)
	@$(call run_tests,clang) -R '^known/'

fuzz: ## feed hostile input to readers and operations for FUZZ_SECONDS in all
	@./setup.sh core clang
	@$(call compile,fuzz)
	@tools/fuzz.sh build/fuzz $(FUZZ_SECONDS)

wasm: ## compile the core to WebAssembly
	@./setup.sh core wasm
	@$(call compile,wasm,product)

clean: ## remove all builds
	@rm -rf build
