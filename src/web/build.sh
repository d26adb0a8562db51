#!/usr/bin/env bash
# Makes the page: a folder of static files for any web server. bash src/web/build.sh [FOLDER] [PROFILE]
# Needs Rust and a network the first time: the target, and wasm-bindgen in the version of Cargo.lock.
set -euo pipefail
cd "$(dirname "$0")/../.."
out=${1:-target/page}
profile=${2:-web}
target=wasm32-unknown-unknown
rustup target list --installed | grep -qx $target || rustup target add $target
version=$(grep -A1 '^name = "wasm-bindgen"$' Cargo.lock | sed -n 's/^version = "\(.*\)"$/\1/p')
PATH="$PATH:${CARGO_HOME:-$HOME/.cargo}/bin"
[ "$(wasm-bindgen --version 2>/dev/null)" = "wasm-bindgen $version" ] || CARGO_PROFILE_DEV_OPT_LEVEL=1 cargo install --quiet --debug \
    wasm-bindgen-cli --version "$version" --no-default-features --bin wasm-bindgen --target-dir target/tools
cargo rustc --quiet --lib --crate-type cdylib --no-default-features --features web --target $target --profile "$profile"
mkdir -p "$out"
wasm-bindgen --target web --no-typescript --remove-name-section --remove-producers-section --out-dir "$out" \
    "target/$target/${profile/#dev/debug}/plm_impact.wasm"
cp src/web/page/* "$out"
