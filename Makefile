# `make play` builds what is missing and serves the page; `make test` runs every test; `make bench` compares the
# nets' speed with other engines, which it installs into target/bench.
# `make timings` prints how long a person waits for the page, `make pictures` takes pictures of all its views.

PORT ?= 8080

# Tools that are installed here are shared by all clones, and replace nothing of yours.
TOOLS := $(or $(XDG_CACHE_HOME),$(HOME)/.cache)/pathlight/tools
export TOOLS
export PATH := $(TOOLS)/bin:$(PATH)

PACKAGE := www/pkg/pathlight_bg.wasm
PACKAGED := Cargo.toml Cargo.lock .cargo/config.toml scripts/build-wasm scripts/optimise-wasm \
	src/web/types.d.ts $(shell find src -name '*.rs' -not -path 'src/commands/*' -not -path src/main.rs)

.PHONY: play test bench build timings pictures clean

play: build
	@target/release/pathlight serve --port $(PORT)

test:
	@scripts/test

bench: $(PACKAGE)
	@benches/nets/run

build: $(PACKAGE)
	cargo build --release --bin pathlight

timings pictures: build
	scripts/install-tools browser-tests chromium
	node tests/browser/$@.mjs

$(PACKAGE): $(PACKAGED)
	scripts/build-wasm

clean:
	cargo clean
	rm -rf www/pkg scripts/node_modules tests/browser/node_modules
