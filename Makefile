# make play      builds what is missing and serves the page on PORT
# make dev       serves the page on PORT, and reloads it whenever one of its files changes
# make check     runs the fast checks: formatting, lints, types and unit tests, without a browser
# make test      runs every check and test: native, Node, Chromium, Firefox and WebKit
# make build     builds the wasm package, and the binaries of the player and the lab
# make python    builds the Python wheel into target/wheels
# make package   packs the npm package for scripts and other pages: target/pathlight-VERSION.tgz
# make dist      builds the page as one folder for any static host, and prints its size
# make bench     compares the speed of the nets and the simulator with other engines, which it installs into
#                target/bench; BENCH="simulator nets" runs only these two
# make timings   prints how long a person waits for the page
# make pictures  takes screenshots of all views of the page
# make film      records the film of the page for the README: assets/film.gif
# make clean     removes everything built or installed here, but keeps the lab's output in target
#
# PROFILE=dist compiles as for a release: the result is smaller and faster, but takes several times as long to compile.

PORT ?= 8080
export PROFILE ?= release

# Tools installed by cargo: shared by all clones, separate from the system's.
TOOLS := $(or $(XDG_CACHE_HOME),$(HOME)/.cache)/pathlight/tools
export TOOLS
export PATH := $(TOOLS)/bin:$(PATH)

# Scripts and tests expect build output there, even if the user's cargo builds elsewhere.
export CARGO_TARGET_DIR := $(CURDIR)/target

PACKAGE := www/pkg/worker/pathlight_bg.wasm
PACKAGED := Cargo.toml Cargo.lock .cargo/config.toml scripts/build-wasm scripts/constants.mjs scripts/licences.mjs \
	scripts/mend-glue.mjs scripts/optimise-wasm scripts/package-lock.json LICENSE src/web/types.d.ts src/benchmark/difficulty.json \
	$(shell find src -name '*.rs' -not -path 'src/command*/*' -not -path src/main.rs)

# Changes with the profile, so that wasm built with another profile counts as out of date.
BUILT_AS := target/wasm-profile
$(shell { read -r profile <$(BUILT_AS); [ "$$profile" = $(PROFILE) ] || \
	{ mkdir -p target && echo $(PROFILE) >$(BUILT_AS); }; } 2>/dev/null)

BUNDLE := scripts/install-tools js-tools && node scripts/build-page.mjs

.DELETE_ON_ERROR:
.PHONY: play dev check test bench build python package dist timings pictures film clean

play:
	@PORT=$(PORT) scripts/play

dev: $(PACKAGE)
	@scripts/install-tools js-tools
	@PORT=$(PORT) node scripts/build-page.mjs --watch

check test:
	@scripts/$@

# Times what is released.
bench:
	@$(MAKE) --no-print-directory PROFILE=dist $(PACKAGE)
	@BENCH="$(BENCH)" ROUNDS="$(ROUNDS)" benches/run

# Built separately, because cargo would unify the features and the player would contain the training code.
build: $(PACKAGE)
	cargo build --profile $(PROFILE) --package pathlight
	cargo build --profile $(PROFILE) --package pathlight-lab

python: $(PACKAGE)
	@scripts/build-wheel

package: $(PACKAGE)
	scripts/install-tools js-tools
	node scripts/build-package.mjs

dist: $(PACKAGE)
	@scripts/install-tools js-tools
	@node scripts/build-dist.mjs

timings pictures film: $(PACKAGE)
	cargo build --release --package pathlight
	scripts/install-tools browser-tests chromium
	$(BUNDLE)
	node tests/browser/$@.mjs

$(BUILT_AS): ;

$(PACKAGE): $(PACKAGED) $(BUILT_AS)
	scripts/build-wasm

clean:
	rm -rf target/pathlight-*.tgz $(addprefix target/,bench compressed crates debug doc package package-types page \
		pictures python python-env python-tools release stages tests-www tmp tools wasm32-unknown-unknown \
		wasm-compiled wasm-package wheels)
	rm -rf dist dist.* www/pkg python/pathlight_phyre/page scripts/node_modules tests/browser/node_modules tests/package/node_modules
